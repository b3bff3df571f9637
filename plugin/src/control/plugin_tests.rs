use super::*;
use crate::climate::EquirectMap;
use crate::plate::PlateId;

/// A surface of 500 samples without crust.
fn surface(version: u64) -> PlanetSurface {
    PlanetSurface(Arc::new(Surface {
        version,
        plate: vec![PlateId::default(); 500],
        ..Surface::default()
    }))
}

#[test]
fn a_planet_that_cannot_be_baked_is_refused_once() {
    let mut app = App::new();
    app.add_plugins(BakePlugin);
    let planet = Planet {
        radius: 6370.0,
        seed: 1,
    };
    let settings = BakeSettings {
        spacing: f64::NAN,
        ..BakeSettings::default()
    };
    let lattice = Lattice(Arc::new(SphereMesh::fibonacci(500).unwrap()));
    let world = app.world_mut();
    let planet = world.spawn((planet, lattice, settings)).id();
    for version in 1..4 {
        app.world_mut().entity_mut(planet).insert(surface(version));
        app.update();
        assert!(app.world().get::<BakeJob>(planet).is_none());
        let refused = app.world().get::<Baked>(planet).unwrap();
        assert_eq!(refused.version, 1, "refused once");
    }
    let refused = bake_now(app.world_mut(), planet);
    assert!(matches!(refused, Err(BakeError::Spacing(_))));
}

/// A wish with a map of the rain of so many rows.
fn rain(height: u32) -> BakeWish {
    let maps = ClimateMaps {
        rain: EquirectMap::from_fn(height, |_, _| 900.0).ok(),
        ..ClimateMaps::default()
    };
    BakeWish {
        maps,
        ..BakeWish::default()
    }
}

#[test]
fn another_map_of_the_climate_asks_for_another_bake() {
    let none = BakeWish::default();
    assert!(none.asks_for_the_same(&none) && rain(4).asks_for_the_same(&rain(4)));
    assert!(!rain(4).asks_for_the_same(&rain(5)) && !rain(4).asks_for_the_same(&none));
}
