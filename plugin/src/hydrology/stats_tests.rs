use super::*;
use crate::hydrology::{Routes, order};

#[test]
fn slopes_are_those_of_lines() {
    assert_eq!(slope(&[(1.0, 2.0)]), None);
    assert!((slope(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]).unwrap() - 2.0).abs() < 1e-12);
}

/// A drainage in which vertex 0 is the coast, 1 the trunk, and vertex k has the children 2k and
/// 2k + 1.
fn binary_tree() -> Drainage {
    let parent = |k: u32| if k == 0 { NO_VERTEX } else { k / 2 };
    let routes = Routes {
        order: (1..512).collect(),
        receiver: (0..512).map(parent).collect(),
        depressions: vec![],
    };
    let mut shore = vec![ShoreClass::Land; 512];
    shore[0] = ShoreClass::Coast;
    Drainage {
        shore,
        ground: vec![0; 512],
        supply: vec![1; 512],
        discharge: vec![1; 512],
        strahler: order::strahler(&routes),
        basin: vec![0; 512],
        routes,
        radius: 6370.0,
        ..Drainage::default()
    }
}

#[test]
fn a_binary_tree_bifurcates_by_two() {
    let mesh = SphereMesh::fibonacci(512).unwrap();
    let climate = Climate {
        rain: vec![500.0; 512],
        ..Climate::default()
    };
    let stats = HydrologyStats::new(&mesh, &climate, &binary_tree());
    assert!((stats.horton.rb - 2.0).abs() < 1e-9, "{:?}", stats.horton);
    // Areas are 1, 3, 7, ... cells.
    assert!((1.9..2.3).contains(&stats.horton.ra), "{:?}", stats.horton);
    assert_eq!(stats.strahler_max, 9);
    assert!((stats.land_rain_mm_mean - 500.0).abs() < 1e-9);
    assert_eq!(stats.endorheic_share, 0.0);
}
