use super::*;
use crate::hydrology::coast::regularise;
use crate::noise::Noise;
use crate::random::Purpose;

fn rough(seed: u64) -> (SphereMesh, Vec<i32>, Vec<ShoreClass>) {
    let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(seed, 0.03)).unwrap();
    let noise = Noise::new(seed, Purpose::Relief, 0);
    let mut ground = parallel::map(mesh.len(), |i| {
        (3e6 * noise.fractal(mesh.point(i), 2.0, 6)) as i32
    });
    let shore = regularise(&mesh, &mut ground);
    (mesh, ground, shore)
}

/// The lowest level around a vertex.
fn lowest_around(mesh: &SphereMesh, level: &[i32], i: usize) -> i32 {
    let ring = mesh.ring(i as u32).iter();
    ring.map(|&j| level[j as usize]).min().unwrap()
}

/// The level at which water leaves each vertex, by relaxation until nothing changes.
fn levels_by_relaxation(mesh: &SphereMesh, ground: &[i32], shore: &[ShoreClass]) -> Vec<i32> {
    let is_land = |i: &usize| shore[*i] == ShoreClass::Land;
    let land: Vec<usize> = (0..mesh.len()).filter(is_land).collect();
    let mut level = vec![0; mesh.len()];
    land.iter().for_each(|&i| level[i] = i32::MAX);
    loop {
        let mut changed = false;
        for &i in &land {
            let z = ground[i].max(lowest_around(mesh, &level, i));
            changed |= z < level[i];
            level[i] = level[i].min(z);
        }
        if !changed {
            return level;
        }
    }
}

#[test]
fn all_land_is_ordered_and_drains_to_the_coast() {
    let (mesh, ground, shore) = rough(1);
    let routes = priority_flood(&mesh, &shore, &ground);
    let mut rank = vec![usize::MAX; mesh.len()];
    for (k, &i) in routes.order.iter().enumerate() {
        rank[i as usize] = k;
    }
    for i in 0..mesh.len() {
        let receiver = routes.receiver[i];
        if shore[i] != ShoreClass::Land {
            assert_eq!((receiver, rank[i]), (NO_VERTEX, usize::MAX));
            continue;
        }
        assert!(mesh.ring(i as u32).contains(&receiver));
        let r = receiver as usize;
        match shore[r] {
            ShoreClass::Land => assert!(rank[r] < rank[i] && rank[i] != usize::MAX),
            ShoreClass::Coast => assert!(rank[i] != usize::MAX),
            ShoreClass::Sea => panic!("{i} drains past the coast"),
        }
    }
}

#[test]
fn depressions_are_where_relaxation_finds_them() {
    let (mesh, ground, shore) = rough(2);
    let routes = priority_flood(&mesh, &shore, &ground);
    let level = levels_by_relaxation(&mesh, &ground, &shore);
    let mut found = ground.clone();
    for depression in &routes.depressions {
        for &i in &routes.order[depression.range.clone()] {
            assert!(ground[i as usize] <= depression.spill_elevation);
            found[i as usize] = depression.spill_elevation;
        }
    }
    for i in (0..mesh.len()).filter(|&i| shore[i] == ShoreClass::Land) {
        assert_eq!(found[i], level[i], "vertex {i}");
    }
    assert!(routes.depressions.len() > 5);
}

#[test]
fn a_planet_without_a_sea_has_one_sink() {
    let (mesh, mut ground, _) = rough(3);
    ground.iter_mut().for_each(|z| *z += 10_000_000);
    let shore = vec![ShoreClass::Land; mesh.len()];
    let routes = priority_flood(&mesh, &shore, &ground);
    assert_eq!(routes.order.len(), mesh.len());
    let sinks: Vec<usize> = (0..mesh.len())
        .filter(|&i| routes.receiver[i] == NO_VERTEX)
        .collect();
    assert_eq!(sinks.len(), 1);
    assert_eq!(ground[sinks[0]], *ground.iter().min().unwrap());
}
