use super::*;
use crate::climate::{Climate, ClimateMaps, EquirectMap};
use crate::hydrology::{Drainage, RiverNetwork, TerrainMaps};

/// The grown drainage of a continent about the equator.
fn grown(base: &BaseMesh) -> Drainage {
    let crust = EquirectMap::from_fn(64, |lat, _| (1.0 - lat.abs() / 30.0) as f32 * 2.0);
    let maps = TerrainMaps {
        crust: crust.unwrap(),
        age: None,
        plateau: None,
        hills: None,
    };
    let terrain = Terrain::from_maps(base, &maps);
    let elevation = terrain.elevation_km();
    let climate = Climate::new(&base.mesh, &base.winds, &elevation, &ClimateMaps::default());
    Drainage::new(base, 6370.0, &terrain, &climate, RiverNetwork::Grown)
}

#[test]
fn grown_rivers_cover_the_land_and_reach_the_sea() {
    let base = BaseMesh::new(3, 0.015).unwrap();
    let drainage = grown(&base);
    let mut rank = vec![usize::MAX; base.mesh.len()];
    for (k, &i) in drainage.routes.order.iter().enumerate() {
        rank[i as usize] = k;
    }
    let level = &drainage.profile.level;
    for i in 0..base.mesh.len() {
        if drainage.shore[i] != ShoreClass::Land {
            continue;
        }
        let to = drainage.routes.receiver[i] as usize;
        assert!(drainage.shore[to] == ShoreClass::Coast || rank[to] < rank[i]);
        assert!(level[i] >= level[to]);
        assert!(!drainage.is_endorheic(i));
    }
    assert!(drainage.strahler.iter().max() >= Some(&3));
    assert_eq!(drainage, grown(&base));
}
