//! Planets worth looking at: figures of every grown planet, and of one that has grown old.

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use bevy_pangaea::sphere::SphereMesh;
use pangaea_tests::measure::{hypsometry, share};
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, planet_app, plates, steps, surface};

/// Width of a bin of the hypsometry in km, and its lower end.
const BIN: f64 = 0.5;
const LOW: f64 = -11.0;

/// Collects all that is wrong, so that one run tells all.
struct Verdict<'a> {
    mesh: &'a SphereMesh,
    surface: &'a Surface,
    wrong: Vec<String>,
}

impl Verdict<'_> {
    fn within(&mut self, name: &str, value: f64, low: f64, high: f64) {
        if !(low..=high).contains(&value) {
            let problem = format!("{name} is {value:.4}, not {low}..{high}");
            self.wrong.push(problem);
        }
    }

    fn elevation(&self, i: usize) -> f64 {
        f64::from(self.surface.elevation(i))
    }

    /// Mean of a value, weighted with the areas of the samples that belong.
    fn mean(&self, value: impl Fn(usize) -> f64, belongs: impl Fn(usize) -> bool) -> f64 {
        let all = (0..self.surface.len()).filter(|&i| belongs(i));
        let (mut sum, mut area) = (0.0, 0.0);
        for i in all {
            sum += value(i) * self.mesh.areas()[i];
            area += self.mesh.areas()[i];
        }
        sum / area
    }

    /// Land, summits and trenches.
    fn judge_heights(&mut self) {
        let heights: Vec<f64> = (0..self.surface.len()).map(|i| self.elevation(i)).collect();
        let highest = heights.iter().copied().fold(f64::MIN, f64::max);
        let deepest = heights.iter().copied().fold(f64::MAX, f64::min);
        let land = share(self.mesh, |i| heights[i] > 0.0);
        let mean = self.mean(|i| heights[i], |i| heights[i] > 0.0);
        self.within("land share", land, 0.2, 0.4);
        self.within("mean elevation of land", mean, 0.4, 1.8);
        self.within("highest summit", highest, 4.0, 10.0);
        self.within("deepest trench", deepest, -11.0, -7.0);
    }

    /// Age of the oceans, and belts.
    fn judge_crust(&mut self) {
        let crust = &self.surface.crust;
        let age = |i: usize| f64::from(crust.ocean_age[i]);
        let mean_age = self.mean(age, |i| !crust.is_continental(i));
        let is_young = |i: usize, years: f32| crust.orogeny_age[i] < years;
        let andes = |i: usize| crust.orogeny[i] == Orogeny::Andean && is_young(i, 30.0);
        let himalaya = |i: usize| crust.orogeny[i] == Orogeny::Himalayan && is_young(i, 250.0);
        let belts = [share(self.mesh, andes), share(self.mesh, himalaya)];
        self.within("mean ocean age", mean_age, 30.0, 90.0);
        self.within("share of young Andean belts", belts[0], 0.005, 0.15);
        self.within("share of Himalayan belts", belts[1], 0.003, 0.2);
    }

    /// Two modes of elevation: ocean floor and continents.
    fn judge_hypsometry(&mut self) {
        let bins = hypsometry(self.mesh, self.surface, LOW, BIN, 44);
        let [deep, high, valley] = modes(&bins);
        self.within("the deep mode", deep.0, -7.0, -3.0);
        self.within("the high mode", high.0, -1.0, 1.5);
        let depth = valley.1 / deep.1.min(high.1);
        self.within(
            "the valley between both modes, to the lower",
            depth,
            0.0,
            0.6,
        );
    }
}

/// The two highest peaks of the hypsometry and the lowest bin between them: elevations and shares.
fn modes(bins: &[f64]) -> [(f64, f64); 3] {
    let by_share = |a: &usize, b: &usize| bins[*a].total_cmp(&bins[*b]);
    let bin_at = |z: f64| ((z - LOW) / BIN) as usize;
    let deep = (0..bin_at(-2.5)).max_by(by_share).unwrap();
    let high = (bin_at(-1.5)..bins.len()).max_by(by_share).unwrap();
    let valley = (deep..high).min_by(by_share).unwrap();
    let middle = |bin: usize| LOW + (bin as f64 + 0.5) * BIN;
    [deep, high, valley].map(|bin| (middle(bin), bins[bin]))
}

fn grown(seed: u64) {
    let recipe = small(seed, 60_000);
    assert_eq!((recipe.plate_count, recipe.land), (40, 0.3));
    let (mut app, planet) = planet_app(&recipe);
    steps(&mut app, planet, 125);
    let surface = surface(&mut app, planet);
    let mut verdict = Verdict {
        mesh: get::<Lattice>(&app, planet),
        surface: &surface,
        wrong: Vec::new(),
    };
    verdict.judge_heights();
    verdict.judge_crust();
    verdict.judge_hypsometry();
    verdict.within("time", surface.time, 250.0, 250.0);
    verdict.within(
        "plates",
        plates(&app, planet).rows().len() as f64,
        8.0,
        60.0,
    );
    let unexplained = get::<Ledger>(&app, planet).unexplained_max;
    verdict.within("unexplained_max", unexplained, 0.0, 1e-4);
    assert!(
        verdict.wrong.is_empty(),
        "seed {seed}: {:#?}",
        verdict.wrong
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

/// Asserts that everything of a planet is a finite number, and within the limits of the model.
fn assert_sound(app: &mut App, planet: Entity) {
    let surface = surface(app, planet);
    let params = get::<TectonicParams>(app, planet);
    let crust = get::<Crust>(app, planet);
    let elevations = params.trench_elevation as f32 - 0.01..=params.summit_elevation as f32 + 0.01;
    for i in 0..crust.len() {
        assert_sound_column(crust, i);
        let z = surface.elevation(i);
        assert!(elevations.contains(&z), "{z} km");
    }
    for row in plates(app, planet).rows() {
        assert!((row.motion.axis.length() - 1.0).abs() < 1e-9);
        let speed = row.motion.speed * 6370.0;
        assert!(
            speed <= params.max_speed + 1e-6,
            "plate {} is too fast",
            row.id.0
        );
        assert!(row.stats.samples > 0);
    }
    for frame in get::<Frames>(app, planet).iter() {
        assert!((frame.rotation.length() - 1.0).abs() < 1e-9);
    }
}

fn assert_sound_column(crust: &Crust, i: usize) {
    assert!(crust.elevation[i].is_finite());
    assert!(crust.ridge[i].is_finite() && crust.fold[i].is_finite());
    assert!(crust.fold[i].length() < 1.001);
    let (thickness, ages) = (
        crust.thickness[i],
        [crust.ocean_age[i], crust.orogeny_age[i]],
    );
    assert!(thickness > 0.0 && thickness < 150.0, "{thickness} km");
    assert!(
        ages.iter().all(|age| age.is_finite() && *age >= 0.0),
        "{ages:?}"
    );
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
    let mut terranes = app.world_mut().query::<&bevy_pangaea::plate::Terrane>();
    let count = terranes.iter(app.world()).count();
    assert!(count < 400, "{count} terranes");
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
