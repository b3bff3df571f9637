use super::*;
use crate::plate::PlateId;

#[test]
fn settings_that_are_no_numbers_equal_themselves_and_are_refused() {
    let odd = BakeSettings {
        spacing: f64::NAN,
        ..BakeSettings::default()
    };
    assert!(odd.asks_for_the_same(&odd) && !odd.asks_for_the_same(&BakeSettings::default()));
    for spacing in [f64::NAN, f64::INFINITY, 0.0, -0.01] {
        let settings = BakeSettings {
            spacing,
            ..BakeSettings::default()
        };
        assert!(
            matches!(settings.check(), Err(BakeError::Spacing(_))),
            "{spacing}"
        );
    }
    let mut rivers = BakeSettings::default();
    rivers.rules.rivers.discharge = f64::NAN;
    assert!(rivers.check().is_ok() && rivers.asks_for_the_same(&rivers.clone()));
    assert!(!rivers.asks_for_the_same(&BakeSettings::default()));
}

#[test]
fn a_planet_that_cannot_be_baked_is_refused_once() {
    let mut app = App::new();
    app.add_plugins(BakePlugin);
    let lattice = Lattice(Arc::new(SphereMesh::fibonacci(500).unwrap()));
    let surface = |version| Surface {
        version,
        plate: vec![PlateId::default(); 500],
        ..Surface::default()
    };
    let settings = BakeSettings {
        spacing: f64::NAN,
        ..BakeSettings::default()
    };
    let planet = app
        .world_mut()
        .spawn((
            Planet {
                radius: 6370.0,
                seed: 1,
            },
            lattice,
            settings,
        ))
        .id();
    for version in 1..4 {
        app.world_mut()
            .entity_mut(planet)
            .insert(PlanetSurface(Arc::new(surface(version))));
        app.update();
        assert!(app.world().get::<BakeJob>(planet).is_none());
        assert_eq!(
            app.world().get::<Baked>(planet).unwrap().version,
            1,
            "refused once"
        );
    }
    assert!(matches!(
        bake_now(app.world_mut(), planet),
        Err(BakeError::Spacing(_))
    ));
}
