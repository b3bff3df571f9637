use super::*;
use crate::climate::MapError;
use crate::math;

/// A map with a value at the north pole.
fn with_pole(value: f32) -> EquirectMap {
    EquirectMap::from_fn(8, |lat, _| if lat > 60.0 { value } else { 0.5 }).unwrap()
}

fn plain() -> TerrainMaps {
    TerrainMaps {
        crust: with_pole(-11.0),
        age: None,
        plateau: None,
        hills: None,
    }
}

#[test]
fn maps_of_impossible_planets_are_refused() {
    let too_old = TerrainMaps {
        age: Some(with_pole(-1.0)),
        ..plain()
    };
    let too_level = TerrainMaps {
        plateau: Some(with_pole(1.1)),
        ..plain()
    };
    let too_hilly = TerrainMaps {
        hills: Some(with_pole(-0.1)),
        ..plain()
    };
    for maps in [too_old, too_level, too_hilly] {
        assert!(matches!(maps.check(), Err(MapError::Range { .. })));
    }
    let extreme = TerrainMaps {
        age: Some(with_pole(4000.0)),
        hills: Some(with_pole(1.0)),
        ..plain()
    };
    assert_eq!(extreme.check(), Ok(()));
}

#[test]
fn metres_are_taken_for_what_they_are() {
    let metres = TerrainMaps {
        crust: with_pole(8848.0),
        ..plain()
    };
    let error = metres.check().unwrap_err().to_string();
    assert!(error.contains("8848 at pixel 0") && error.contains("metres"));
}

#[test]
fn heights_beyond_all_bounds_are_clamped() {
    let top = 100_000 * GRAINS;
    let found = [1e-3, 1e9, f32::NEG_INFINITY, f32::NAN].map(to_grains);
    assert_eq!(found, [GRAINS, top, -top, 0]);
}

#[test]
fn maps_alone_make_a_terrain() {
    let base = BaseMesh::new(1, 0.05).unwrap();
    let maps = TerrainMaps {
        crust: EquirectMap::from_fn(32, |lat, _| (lat / 20.0) as f32).unwrap(),
        age: None,
        plateau: Some(EquirectMap::from_fn(4, |_, _| 0.5).unwrap()),
        hills: None,
    };
    let terrain = Terrain::from_maps(&base, &maps);
    assert!(terrain.plateau.iter().all(|&p| p == 0.5));
    for (i, p) in base.mesh.points().iter().enumerate() {
        let z = math::lat_lon(*p).0 / 20.0;
        let found = f64::from(terrain.ground[i]) / 1_024_000.0;
        assert!(found < z + 0.6 && found > z - 1.4, "{z} {found}");
        assert!(terrain.crust[i] >= terrain.ground[i]);
    }
}

#[test]
fn a_crust_with_voids_is_refused() {
    let with_voids = TerrainMaps {
        crust: with_pole(f32::NAN),
        ..plain()
    };
    let error = with_voids.check().unwrap_err().to_string();
    assert!(
        error.contains("the crust has no value at pixel 0"),
        "{error}"
    );
}

#[test]
fn other_maps_count_as_not_given_where_they_are_void() {
    let base = BaseMesh::new(1, 0.1).unwrap();
    let south = |value: f32| move |lat: f64, _: f64| if lat < 0.0 { value } else { f32::NAN };
    let maps = TerrainMaps {
        crust: EquirectMap::from_fn(32, |_, lon| (lon / 60.0) as f32).unwrap(),
        age: EquirectMap::from_fn(32, south(40.0)).ok(),
        plateau: EquirectMap::from_fn(32, south(0.75)).ok(),
        hills: None,
    };
    assert_eq!(maps.check(), Ok(()));
    let bare = TerrainMaps {
        age: None,
        plateau: None,
        ..maps.clone()
    };
    let [found, own] = [&maps, &bare].map(|maps| Terrain::from_maps(&base, maps));
    for (i, p) in base.mesh.points().iter().enumerate() {
        let given = (found.age[i], found.plateau[i]);
        // Well away from the border, which the mesh's own neighbourhoods smooth.
        if p.z < -0.4 {
            assert_eq!(given, (40.0, 0.75));
        } else if p.z > 0.4 {
            assert_eq!(given, (own.age[i], own.plateau[i]));
        }
    }
}
