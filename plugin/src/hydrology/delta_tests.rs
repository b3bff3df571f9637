use super::*;
use crate::hydrology::{NO_VERTEX, Profile, Routes};

/// A continent on the northern half of a planet, before a shelf of a depth in m, and a river that
/// ends at a coast; returns its mouth, too.
fn river_before(depth_m: i32, discharge_m3s: f64) -> (SphereMesh, Drainage, u32) {
    let mesh = SphereMesh::fibonacci(100_000).unwrap();
    let n = mesh.len();
    let is_sea = |i: u32| mesh.point(i).z < 0.0;
    let borders = |i: u32| mesh.ring(i).iter().any(|&j| is_sea(j));
    let shore: Vec<ShoreClass> = (0..n as u32)
        .map(|i| match (is_sea(i), borders(i)) {
            (true, _) => ShoreClass::Sea,
            (false, true) => ShoreClass::Coast,
            (false, false) => ShoreClass::Land,
        })
        .collect();
    let ground = shore.iter().map(|class| match class {
        ShoreClass::Sea => -depth_m * GRAINS,
        ShoreClass::Coast => 0,
        ShoreClass::Land => 50 * GRAINS,
    });
    let ground: Vec<i32> = ground.collect();
    let mouth = (0..n).find(|&i| shore[i] == ShoreClass::Coast).unwrap();
    let mut discharge = vec![0; n];
    discharge[mouth] = (discharge_m3s * 31_556_952.0) as u64;
    let drainage = Drainage {
        routes: Routes {
            receiver: vec![NO_VERTEX; n],
            ..Routes::default()
        },
        profile: Profile {
            level: ground.clone(),
            ..Profile::default()
        },
        shore,
        ground,
        discharge,
        radius: 6371.0,
        ..Drainage::default()
    };
    (mesh, drainage, mouth as u32)
}

fn found(depth_m: i32, discharge_m3s: f64) -> Vec<Delta> {
    let (mesh, drainage, mouth) = river_before(depth_m, discharge_m3s);
    deltas(&mesh, &drainage, &[mouth])
}

/// Samples lie 70 km apart: 1 in 500 of that is 140 m.
#[test]
fn great_rivers_on_shallow_shelves_have_deltas() {
    assert_eq!(found(60, 3_000.0).len(), 1);
    assert_eq!(found(60, 400.0), []);
    assert_eq!(found(250, 3_000.0), []);
    // The greatest fill deeper water.
    assert_eq!(found(250, 60_000.0).len(), 1);
}

#[test]
fn arms_share_the_discharge_and_end_at_the_sea() {
    for (discharge, most) in [(600.0, 2), (3_000.0, 3), (60_000.0, 4)] {
        let (mesh, drainage, mouth) = river_before(40, discharge);
        let [delta] = &deltas(&mesh, &drainage, &[mouth])[..] else {
            panic!("one delta at {discharge} m³/s");
        };
        assert_eq!(delta.apex, mouth);
        assert!((2..=most).contains(&delta.arms.len()));
        let sum: f64 = delta.arms.iter().map(|&(_, share)| share).sum();
        assert!((sum - 1.0).abs() < 1e-12);
        for &(arm, share) in &delta.arms {
            let is_coast = drainage.shore[arm as usize] == ShoreClass::Coast;
            assert!(share > 0.05 && (is_coast || delta.shore.contains(&arm)));
            assert!(mesh.ring(mouth).contains(&arm));
        }
        // The apex has land all around it.
        let stays_sea = |j: &&u32| drainage.ground[**j as usize] < 0 && !delta.shore.contains(j);
        assert_eq!(mesh.ring(mouth).iter().find(stays_sea), None);
    }
}

#[test]
fn deltas_do_not_touch() {
    let (mesh, mut drainage, mouth) = river_before(40, 3_000.0);
    let coast = |i: &u32| drainage.shore[*i as usize] == ShoreClass::Coast;
    let beside = mesh.ring(mouth).iter().copied().find(coast).unwrap();
    drainage.discharge[beside as usize] = drainage.discharge[mouth as usize] * 2;
    let found = deltas(&mesh, &drainage, &[mouth, beside]);
    assert_eq!(found.iter().map(|d| d.apex).collect::<Vec<_>>(), [beside]);
}
