use super::*;
use crate::hydrology::coast::regularise;
use crate::noise::Noise;
use crate::random::Purpose;

fn rough(seed: u64) -> (SphereMesh, Vec<i32>, Vec<Site>) {
    let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(seed, 0.03)).unwrap();
    let noise = Noise::new(seed, Purpose::Relief, 0);
    let mut ground = parallel::map(mesh.len(), |i| {
        (3e6 * noise.fractal(mesh.point(i), 2.0, 6)) as i32
    });
    let sites = regularise(&mesh, &mut ground);
    (mesh, ground, sites)
}

/// The level at which water leaves each vertex, by relaxation until nothing changes.
fn levels_by_relaxation(mesh: &SphereMesh, ground: &[i32], sites: &[Site]) -> Vec<i32> {
    let mut level: Vec<i32> = (0..mesh.len())
        .map(|i| if sites[i] == Site::Land { i32::MAX } else { 0 })
        .collect();
    loop {
        let mut changed = false;
        for i in 0..mesh.len() {
            if sites[i] != Site::Land {
                continue;
            }
            let around = mesh
                .ring(i as u32)
                .iter()
                .map(|&j| level[j as usize])
                .min()
                .unwrap();
            let z = ground[i].max(around);
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
    let (mesh, ground, sites) = rough(1);
    let routes = flood(&mesh, &sites, &ground);
    let mut rank = vec![usize::MAX; mesh.len()];
    routes
        .order
        .iter()
        .enumerate()
        .for_each(|(k, &i)| rank[i as usize] = k);
    for i in 0..mesh.len() {
        assert_eq!(sites[i] == Site::Land, rank[i] != usize::MAX);
        let r = routes.receiver[i];
        if sites[i] == Site::Land {
            assert!(mesh.ring(i as u32).contains(&r));
            let downstream = if sites[r as usize] == Site::Land {
                rank[r as usize] < rank[i]
            } else {
                true
            };
            assert!(downstream && sites[r as usize] != Site::Sea);
        } else {
            assert_eq!(r, NONE);
        }
    }
}

#[test]
fn depressions_are_where_relaxation_finds_them() {
    let (mesh, ground, sites) = rough(2);
    let routes = flood(&mesh, &sites, &ground);
    let level = levels_by_relaxation(&mesh, &ground, &sites);
    let mut found = ground.clone();
    for depression in &routes.depressions {
        for &i in &routes.order[depression.range.clone()] {
            assert!(ground[i as usize] <= depression.level);
            found[i as usize] = depression.level;
        }
    }
    for i in 0..mesh.len() {
        if sites[i] == Site::Land {
            assert_eq!(found[i], level[i], "vertex {i}");
        }
    }
    assert!(routes.depressions.len() > 5);
}

#[test]
fn a_planet_without_a_sea_has_one_sink() {
    let (mesh, mut ground, _) = rough(3);
    ground.iter_mut().for_each(|z| *z += 10_000_000);
    let sites = vec![Site::Land; mesh.len()];
    let routes = flood(&mesh, &sites, &ground);
    assert_eq!(routes.order.len(), mesh.len());
    let sinks: Vec<usize> = (0..mesh.len())
        .filter(|&i| routes.receiver[i] == NONE)
        .collect();
    assert_eq!(sinks.len(), 1);
    assert_eq!(ground[sinks[0]], *ground.iter().min().unwrap());
}
