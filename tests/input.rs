//! Bad input: every number of a recipe that no planet can have is refused, and every one that it
//! may have works.

use bevy::prelude::App;
use bevy_pangaea::prelude::*;
use pangaea_tests::shape::small;
use pangaea_tests::world::{app, get, heard, listen, planet_app, steps};

const BAD: [f64; 7] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e300,
    -1e300,
    1e9,
    -1e9,
];

/// Asserts that a recipe is refused in one line, and that nothing is made of it.
fn refused(what: &str, recipe: &PlanetRecipe) {
    let error = recipe.validate().expect_err(what);
    assert!(PlanetState::new(recipe).is_err(), "{what}");
    let text = error.to_string();
    assert!(
        !text.is_empty() && !text.contains('\n') && text.len() < 400,
        "{what}: {text}"
    );
}

fn recipe(change: impl FnOnce(&mut PlanetRecipe)) -> PlanetRecipe {
    let mut recipe = small(1, 1000);
    change(&mut recipe);
    recipe
}

#[test]
fn numbers_of_samples() {
    for samples in [0, 1, 2, 3, 99, 2_000_001, 1_000_000_000, u32::MAX] {
        refused("samples", &recipe(|r| r.samples = samples));
    }
    let error = recipe(|r| r.samples = 0)
        .validate()
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("samples = 0") && error.contains("100..=2000000"),
        "{error}"
    );
}

#[test]
fn radii_and_shares_of_land() {
    for radius in BAD.into_iter().chain([0.0, -1.0, 49.9, 100_001.0]) {
        refused("radius", &recipe(|r| r.radius = radius));
    }
    for land in BAD.into_iter().chain([-0.001, 0.901, 1.0, 30.0]) {
        refused("land", &recipe(|r| r.land = land));
    }
}

#[test]
fn islands_and_coasts() {
    for islands in [201, u32::MAX] {
        refused("islands", &recipe(|r| r.islands = islands));
    }
    for roughness in BAD.into_iter().chain([-0.001, 2.001, 5.0]) {
        refused("coasts", &recipe(|r| r.coast_roughness = roughness));
    }
}

#[test]
fn numbers_of_plates() {
    for plates in [0, 1, 101, 1001, 100_000, u32::MAX] {
        refused("plates", &recipe(|r| r.plate_count = plates));
    }
    let error = recipe(|r| r.plate_count = 101).validate().unwrap_err();
    assert_eq!(
        error,
        PlanetError::TooManyPlates {
            plates: 101,
            needed: 1010,
            samples: 1000
        }
    );
    assert!(recipe(|r| r.plate_count = 100).validate().is_ok());
}

/// A recipe of two plates: a good one and one that turns about a pole.
fn two_plates(centroid: (f64, f64), pole: (f64, f64), speed: f64) -> PlanetRecipe {
    let other = PlateRecipe {
        centroid: (-10.0, -160.0),
        pole: None,
        speed: 0.0,
    };
    let plate = PlateRecipe {
        centroid,
        pole: Some(pole),
        speed,
    };
    recipe(|r| r.plates = vec![other, plate])
}

#[test]
fn plates_given_one_by_one() {
    const GOOD: (f64, f64) = (10.0, 20.0);
    let good = two_plates(GOOD, GOOD, 50.0);
    assert!(good.validate().is_ok());
    for bad in BAD {
        refused("latitude", &two_plates((bad, 0.0), GOOD, 50.0));
        refused("longitude", &two_plates((0.0, bad), GOOD, 50.0));
        refused("pole", &two_plates(GOOD, (bad, 0.0), 50.0));
        refused("pole", &two_plates(GOOD, (0.0, bad), 50.0));
        refused("speed", &two_plates(GOOD, GOOD, bad));
    }
    refused("latitude", &two_plates((90.1, 0.0), GOOD, 50.0));
    refused("speed", &two_plates(GOOD, GOOD, -300.1));
    let alone = good.plates[..1].to_vec();
    refused("one plate alone", &recipe(|r| r.plates = alone));
    let many = vec![good.plates[1].clone(); 200];
    refused("too many plates", &recipe(|r| r.plates = many));
}

#[test]
fn continents_given_one_by_one() {
    let with = |center, radius| recipe(|r| r.continents = vec![DiscRecipe { center, radius }]);
    assert!(with((0.0, 0.0), 3000.0).validate().is_ok());
    for bad in BAD {
        refused("latitude", &with((bad, 0.0), 3000.0));
        refused("longitude", &with((0.0, bad), 3000.0));
        refused("radius", &with((0.0, 0.0), bad));
    }
    for radius in [0.0, 0.9, -5.0, 20_001.0] {
        refused("radius", &with((0.0, 0.0), radius));
    }
}

#[test]
fn parameters_out_of_their_limits() {
    for info in TectonicParams::TABLE {
        let span = info.max - info.min;
        for bad in [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            info.min - 1e-6 * span,
            info.max + 1e-6 * span,
        ] {
            let params = unchecked(info.name, bad);
            let refused_recipe = recipe(|r| r.params = params);
            refused(info.name, &refused_recipe);
            let error = refused_recipe.validate().unwrap_err().to_string();
            assert!(error.contains(info.name), "{error}");
        }
    }
}

/// Parameters with one value that `set` would refuse, written straight into the field as a program
/// may.
fn unchecked(name: &str, value: f64) -> TectonicParams {
    use bevy::reflect::GetPath;
    let mut params = TectonicParams::default();
    *params
        .path_mut::<f64>(name)
        .expect("the table names fields") = value;
    params
}

#[test]
fn every_parameter_works_at_its_limits() {
    for info in TectonicParams::TABLE {
        for value in [info.min, info.max] {
            let place = format!("{} = {value}", info.name);
            let recipe = recipe(|r| {
                r.samples = 600;
                r.plate_count = 12;
                r.params.set(info.name, value).expect("limits are allowed");
            });
            let (mut app, planet) = planet_app(&recipe);
            steps(&mut app, planet, 30);
            let crust = get::<Crust>(&app, planet);
            let columns = [&crust.elevation, &crust.thickness, &crust.ocean_age];
            assert!(
                columns.into_iter().flatten().all(|x| x.is_finite()),
                "{place}"
            );
            assert!(crust.thickness.iter().all(|&e| e > 0.0), "{place}");
            let ledger = get::<Ledger>(&app, planet);
            assert!(ledger.unexplained_volume_max < 1e-5, "{place}: {ledger:?}");
        }
    }
}

/// Spawns a recipe, and runs frames until its planet is there or it is refused.
fn grow(app: &mut App, recipe: PlanetRecipe) -> Option<PlanetFailed> {
    listen::<PlanetReady>(app);
    listen::<PlanetFailed>(app);
    let heard_before = (
        heard::<PlanetReady>(app).len(),
        heard::<PlanetFailed>(app).len(),
    );
    app.world_mut().commands().spawn_planet(recipe);
    app.world_mut().flush();
    for _ in 0..3000 {
        app.update();
        let heard_now = (
            heard::<PlanetReady>(app).len(),
            heard::<PlanetFailed>(app).len(),
        );
        if heard_now != heard_before {
            return heard::<PlanetFailed>(app).get(heard_before.1).cloned();
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    panic!("neither a planet nor an error");
}

#[test]
fn a_refused_recipe_makes_no_planet() {
    let mut app = app();
    for (bad, word) in [
        (recipe(|r| r.samples = 0), "samples"),
        // 40 plates need 400 samples.
        (recipe(|r| r.samples = 200), "400"),
    ] {
        let failed = grow(&mut app, bad).expect("the recipe is refused");
        let message = failed.error.to_string();
        assert!(
            message.contains(word) && message.lines().count() == 1,
            "{message}"
        );
        assert!(app.world().get::<Planet>(failed.planet).is_none());
    }
    assert_eq!(grow(&mut app, recipe(|_| {})), None);
    let planets = app.world_mut().query::<&Planet>().iter(app.world()).count();
    assert_eq!(planets, 1);
}

#[test]
fn a_planet_that_is_gone_is_no_longer_simulated() {
    let (mut app, planet) = planet_app(&small(1, 500));
    steps(&mut app, planet, 2);
    app.world_mut().despawn(planet);
    steps(&mut app, planet, 2);
    assert!(bevy_pangaea::io::capture(app.world(), planet).is_none());
    assert_eq!(
        app.world_mut()
            .query::<&PlateId>()
            .iter(app.world())
            .count(),
        0,
        "its plates go with it"
    );
    app.update();
}
