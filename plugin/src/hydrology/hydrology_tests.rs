use super::*;
use crate::climate::{ClimateMaps, EquirectMap};
use crate::noise::Noise;
use crate::random::Purpose;

/// The drainage of a rough planet of a radius in km.
fn rough(seed: u64, radius: f64, dry: bool) -> (BaseMesh, Drainage) {
    let base = BaseMesh::new(seed, 0.025).unwrap();
    let noise = Noise::new(seed, Purpose::Relief, 0);
    let height =
        |lat: f64, lon: f64| (5.0 * noise.fractal(crate::math::direction(lat, lon), 1.7, 6)) as f32;
    let maps = TerrainMaps {
        crust: EquirectMap::from_fn(128, height).unwrap(),
        age: None,
        plateau: None,
        hills: None,
    };
    let terrain = Terrain::from_maps(&base, &maps);
    let rain = dry.then(|| EquirectMap::from_fn(4, |_, _| 150.0).unwrap());
    let maps = ClimateMaps {
        rain,
        ..ClimateMaps::default()
    };
    let climate = Climate::new(&base.mesh, &base.winds, &terrain.elevation_km(), &maps);
    let drainage = Drainage::new(&base, radius, &terrain, &climate, RiverNetwork::Drainage);
    (base, drainage)
}

/// Every lake has one kind, which says where its water ends.
fn assert_kinds(drainage: &Drainage) {
    let mut kinds = vec![None; drainage.profile.lakes.len()];
    for i in 0..drainage.len() {
        let Some(kind) = drainage.lake_kind(i) else {
            assert!(!drainage.is_lake(i));
            continue;
        };
        assert_eq!(drainage.is_endorheic(i), kind != LakeKind::Draining);
        let lake = drainage.profile.lake[i] as usize;
        assert_eq!(
            drainage.profile.lakes[lake].outlet == NONE,
            kind == LakeKind::Closed
        );
        assert_eq!(
            *kinds[lake].get_or_insert(kind),
            kind,
            "lake {lake} has two kinds"
        );
    }
}

/// The laws that every drainage keeps.
fn assert_lawful(drainage: &Drainage) {
    assert_kinds(drainage);
    let Drainage {
        sites,
        routes,
        discharge,
        supply,
        profile,
        ..
    } = drainage;
    let n = drainage.len();
    // Not a unit of water is lost.
    let given: u64 = supply.iter().sum();
    let ends = (0..n).filter(|&i| routes.receiver[i] == NONE);
    assert_eq!(given, ends.map(|i| discharge[i]).sum::<u64>());
    for i in 0..n {
        let to = routes.receiver[i];
        if sites[i] != Site::Land {
            assert_eq!(to, NONE);
            continue;
        }
        // No loops: all water arrives within as many steps as there are vertices.
        let mut at = i;
        let mut steps = 0;
        while routes.receiver[at] != NONE {
            at = routes.receiver[at] as usize;
            steps += 1;
            assert!(steps <= n, "a loop at {i}");
        }
        assert_eq!(drainage.basin[i], at as u32);
        // It ends at a coast or in a lake without an outlet.
        let lake = profile.lake[at];
        assert!(
            sites[at] == Site::Coast || profile.lakes[lake as usize].outlet == NONE,
            "{i}"
        );
        if to == NONE {
            continue;
        }
        let r = to as usize;
        assert!(discharge[r] >= discharge[i] && drainage.strahler[i] > 0);
        assert!(profile.level[i] >= profile.level[r], "uphill at {i}");
        assert!(profile.level[i] >= profile.bed[i]);
        let (own, next) = (profile.lake[i], profile.lake[r]);
        if own == NONE {
            assert!(profile.level[i] > profile.level[r]);
            assert!(
                next != NONE || profile.bed[i] > profile.bed[r],
                "bed at {i}"
            );
        } else if next == NONE {
            let lake = &profile.lakes[own as usize];
            assert_eq!((lake.outlet, lake.level), (to, profile.level[r]));
        } else {
            assert_eq!(own, next);
        }
    }
    for (id, lake) in profile.lakes.iter().enumerate() {
        let vertices: Vec<usize> = (0..n).filter(|&i| profile.lake[i] == id as u32).collect();
        assert_eq!(vertices.len(), lake.vertices as usize);
        assert!(
            vertices
                .iter()
                .all(|&i| profile.level[i] == lake.level && profile.bed[i] < lake.level)
        );
        assert!(
            vertices
                .iter()
                .all(|&i| lake.level - profile.bed[i] <= profile::DEEPEST_LAKE)
        );
    }
}

#[test]
fn small_and_dry_planets_keep_the_laws_too() {
    let (_, small) = rough(11, 50.0, false);
    assert_lawful(&small);
    let (_, large) = rough(11, 6370.0, false);
    let strongest = |d: &Drainage| {
        (0..d.len())
            .map(|i| d.earth_like_discharge(i))
            .fold(0.0, f64::max)
    };
    let ratio = strongest(&small) / strongest(&large);
    assert!((0.98..1.02).contains(&ratio), "{ratio}");
    let (_, dry) = rough(12, 6370.0, true);
    assert_lawful(&dry);
    let closed = dry
        .profile
        .lakes
        .iter()
        .filter(|lake| lake.outlet == NONE)
        .count();
    assert!(closed > 3, "{closed} closed lakes on a dry planet");
    assert!((0..dry.len()).any(|i| dry.is_endorheic(i)));
}

#[test]
fn a_planet_without_land_or_without_sea_drains() {
    let base = BaseMesh::new(1, 0.08).unwrap();
    for level in [-3.0, 2.0] {
        let crust = EquirectMap::from_fn(8, |_, _| level).unwrap();
        let terrain = Terrain::from_maps(
            &base,
            &TerrainMaps {
                crust,
                age: None,
                plateau: None,
                hills: None,
            },
        );
        let climate = Climate::new(
            &base.mesh,
            &base.winds,
            &terrain.elevation_km(),
            &ClimateMaps::default(),
        );
        for network in [RiverNetwork::Drainage, RiverNetwork::Grown] {
            let drainage = Drainage::new(&base, 6370.0, &terrain, &climate, network);
            let land = drainage.sites.iter().filter(|s| **s == Site::Land).count();
            assert_eq!(drainage.routes.order.len(), land);
        }
    }
}

#[test]
fn every_planet_keeps_the_laws() {
    for seed in 0..12 {
        assert_lawful(&rough(seed, 6370.0, seed % 3 == 0).1);
    }
}
