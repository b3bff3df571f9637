//! Planets worth looking at: what every grown planet must look like, and one that has grown old.

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use pangaea_tests::measure::{hypsometry, share};
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, planet_app, plates, steps, surface};

/// Width of a bin of the hypsometry in km, and its lower end.
const BIN: f64 = 0.5;
const LOW: f64 = -11.0;

/// Collects what is wrong, so that one run tells all.
struct Verdict {
    seed: u64,
    wrong: Vec<String>,
}

impl Verdict {
    fn within(&mut self, what: &str, value: f64, low: f64, high: f64) {
        if !(value >= low && value <= high) {
            self.wrong
                .push(format!("{what} is {value:.4}, not {low}..{high}"));
        }
    }
}

/// The two highest peaks of the hypsometry and the lowest bin between them: elevations and shares.
fn modes(bins: &[f64]) -> [(f64, f64); 3] {
    let z = |bin: usize| LOW + (bin as f64 + 0.5) * BIN;
    let peak = |range: core::ops::Range<usize>| {
        range
            .max_by(|&a, &b| bins[a].total_cmp(&bins[b]))
            .unwrap_or(0)
    };
    let at = |z: f64| ((z - LOW) / BIN) as usize;
    let (deep, high) = (peak(0..at(-2.5)), peak(at(-1.5)..bins.len()));
    let valley = (deep..high)
        .min_by(|&a, &b| bins[a].total_cmp(&bins[b]))
        .unwrap_or(deep);
    [deep, high, valley].map(|bin| (z(bin), bins[bin]))
}

fn grown(seed: u64) {
    let recipe = PlanetRecipe {
        seed,
        ..small(seed, 60_000)
    };
    assert_eq!((recipe.plate_count, recipe.land), (40, 0.3));
    let (mut app, planet) = planet_app(&recipe);
    steps(&mut app, planet, 125);
    let surface = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let crust = &surface.crust;
    let mut verdict = Verdict {
        seed,
        wrong: Vec::new(),
    };
    verdict.within("time", surface.time, 250.0, 250.0);
    verdict.within(
        "land share",
        share(mesh, |i| surface.elevation(i) > 0.0),
        0.2,
        0.4,
    );
    let z = |i: usize| f64::from(surface.elevation(i));
    verdict.within(
        "highest summit",
        (0..surface.len()).map(z).fold(f64::MIN, f64::max),
        4.0,
        10.0,
    );
    verdict.within(
        "deepest trench",
        (0..surface.len()).map(z).fold(f64::MAX, f64::min),
        -11.0,
        -7.0,
    );
    let ocean = share(mesh, |i| !crust.is_continental(i));
    let age: f64 = (0..surface.len())
        .filter(|&i| !crust.is_continental(i))
        .map(|i| f64::from(crust.ocean_age[i]) * mesh.areas()[i])
        .sum();
    verdict.within(
        "mean ocean age",
        age / (ocean * 4.0 * core::f64::consts::PI),
        30.0,
        90.0,
    );
    verdict.within(
        "plates",
        plates(&app, planet).rows().len() as f64,
        8.0,
        60.0,
    );
    let land: f64 = (0..surface.len())
        .filter(|&i| z(i) > 0.0)
        .map(|i| z(i) * mesh.areas()[i])
        .sum();
    let land_area: f64 = (0..surface.len())
        .filter(|&i| z(i) > 0.0)
        .map(|i| mesh.areas()[i])
        .sum();
    verdict.within("mean elevation of land", land / land_area, 0.4, 1.8);
    let belt = |kind: Orogeny, age: f32| {
        share(mesh, |i| {
            crust.orogeny[i] == kind && crust.orogeny_age[i] < age
        })
    };
    verdict.within(
        "share of young Andean belts",
        belt(Orogeny::Andean, 30.0),
        0.005,
        0.15,
    );
    verdict.within(
        "share of Himalayan belts",
        belt(Orogeny::Himalayan, 250.0),
        0.003,
        0.2,
    );
    verdict.within(
        "unexplained_max",
        get::<Ledger>(&app, planet).unexplained_max,
        0.0,
        1e-4,
    );
    let bins = hypsometry(mesh, &surface, LOW, BIN, 44);
    let [deep, high, valley] = modes(&bins);
    verdict.within("the deep mode", deep.0, -7.0, -3.0);
    verdict.within("the high mode", high.0, -1.0, 1.5);
    verdict.within(
        "the valley between both modes, to the lower",
        valley.1 / deep.1.min(high.1),
        0.0,
        0.6,
    );
    assert!(
        verdict.wrong.is_empty(),
        "seed {}:\n  {}\n  {bins:.3?}",
        verdict.seed,
        verdict.wrong.join("\n  ")
    );
}

#[test]
fn seed_1_is_worth_looking_at() {
    grown(1);
}

#[test]
fn seed_2_is_worth_looking_at() {
    grown(2);
}

#[test]
fn seed_3_is_worth_looking_at() {
    grown(3);
}

/// Everything of a planet is a finite number, and within the limits of the model.
fn assert_sound(app: &mut App, planet: Entity) {
    let surface = surface(app, planet);
    let params = get::<TectonicParams>(app, planet);
    let crust = get::<Crust>(app, planet);
    for i in 0..crust.len() {
        let numbers = [
            crust.thickness[i],
            crust.elevation[i],
            crust.ocean_age[i],
            crust.orogeny_age[i],
            surface.elevation(i),
        ];
        assert!(numbers.iter().all(|x| x.is_finite()), "{numbers:?}");
        assert!(
            crust.ridge[i].is_finite()
                && crust.fold[i].is_finite()
                && crust.fold[i].length() < 1.001
        );
        assert!(
            crust.thickness[i] > 0.0 && crust.thickness[i] < 150.0,
            "{} km",
            crust.thickness[i]
        );
        assert!(surface.elevation(i) <= params.summit_elevation as f32 + 0.01);
        assert!(surface.elevation(i) >= params.trench_elevation as f32 - 0.01);
        assert!(crust.ocean_age[i] >= 0.0 && crust.orogeny_age[i] >= 0.0);
    }
    for row in plates(app, planet).rows() {
        assert!((row.motion.axis.length() - 1.0).abs() < 1e-9);
        assert!(
            row.motion.speed * 6370.0 <= params.max_speed + 1e-6,
            "plate {} is too fast",
            row.id.0
        );
        assert!(row.stats.samples > 0);
    }
    for frame in get::<Frames>(app, planet).iter() {
        assert!((frame.rotation.length() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn a_planet_of_1000_my_still_has_land_and_is_sound() {
    let (mut app, planet) = planet_app(&small(1, 10_000));
    let mut frames = 0;
    for _ in 0..10 {
        steps(&mut app, planet, 50);
        assert_sound(&mut app, planet);
        frames = frames.max(get::<Frames>(&app, planet).len());
    }
    let surface = surface(&mut app, planet);
    assert_eq!(surface.time, 1000.0);
    let land = share(get::<Lattice>(&app, planet), |i| surface.elevation(i) > 0.0);
    assert!(
        (0.15..=0.45).contains(&land),
        "{land:.3} of the planet is land"
    );
    let count = plates(&app, planet).rows().len();
    assert!((4..=80).contains(&count), "{count} plates");
    assert!(frames < 300, "frames pile up: {frames}");
    let terranes = app
        .world_mut()
        .query::<&bevy_pangaea::plate::Terrane>()
        .iter(app.world())
        .count();
    assert!(terranes < 400, "{terranes} terranes");
}

#[test]
fn planets_of_any_size_are_sound() {
    for (samples, radius, plate_count, land) in [
        (100, 6370.0, 2, 0.3),
        (300, 50.0, 8, 0.0),
        (2000, 100_000.0, 30, 0.9),
        (5000, 1737.0, 500, 0.3),
        (2000, 6370.0, 200, 0.6),
    ] {
        let recipe = PlanetRecipe {
            samples,
            radius,
            plate_count,
            land,
            ..PlanetRecipe::default()
        };
        let (mut app, planet) = planet_app(&recipe);
        steps(&mut app, planet, 40);
        let crust = get::<Crust>(&app, planet);
        assert!(
            crust
                .elevation
                .iter()
                .chain(&crust.thickness)
                .all(|x| x.is_finite()),
            "{recipe:?}"
        );
        let share = get::<Ledger>(&app, planet).unexplained_volume_max;
        assert!(
            share < 1e-5,
            "{samples} samples, {radius} km, {plate_count} plates, {land} land: {share:e}"
        );
    }
}
