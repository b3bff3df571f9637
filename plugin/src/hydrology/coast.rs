//! Sea, coast and land, such that no edge joins land and sea (paper 002 §4, Fig. 5d).
//!
//! A coast vertex stands at sea level between them: there rivers end, and estuaries have room. Of
//! an edge between land and sea that end becomes coast that lies nearer to sea level, so the land
//! neither grows nor shrinks in the mean; land without hinterland stays land, or islands would
//! vanish.
//!
//! Policy. *Sea* is a connected body below 0 of at least [`SEA_SHARE`] of the planet, or the
//! largest if none is; a smaller one is land below sea level, and drainage decides whether it holds
//! a lake. The largest sea on Earth that is none, the Caspian, has 0.07 % of the area.

use crate::parallel;
use crate::sphere::SphereMesh;

/// Share of the planet's area from which on a body of water is a sea.
pub const SEA_SHARE: f64 = 0.0025;

/// Sea, coast or land.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Site {
    /// Under the sea.
    Sea,
    /// At sea level, between land and sea.
    Coast,
    /// Everything else.
    Land,
}

/// Sorts the vertices of `mesh`, and moves the ground of coasts (in grains) to sea level.
pub fn regularise(mesh: &SphereMesh, ground: &mut [i32]) -> Vec<Site> {
    let is_sea = seas(mesh, ground);
    let meets = |i: u32, sea: bool| mesh.ring(i).iter().any(|&j| is_sea[j as usize] == sea);
    // Land all around of which is land.
    let inland = parallel::map(mesh.len(), |i| !is_sea[i as usize] && !meets(i, true));
    let gives_way = parallel::map(mesh.len(), |i| {
        let low = ground[i as usize];
        let seaward = || {
            mesh.ring(i)
                .iter()
                .filter(|&&j| is_sea[j as usize])
                .map(|&j| i64::from(ground[j as usize]))
        };
        let count = seaward().count() as i64;
        !is_sea[i as usize]
            && count > 0
            && i64::from(low) * count < -seaward().sum::<i64>()
            && mesh.ring(i).iter().any(|&j| inland[j as usize])
    });
    let sites = parallel::map(mesh.len(), |i| {
        let keeps = |j: u32| !is_sea[j as usize] && !gives_way[j as usize];
        match (is_sea[i as usize], gives_way[i as usize]) {
            (false, true) => Site::Coast,
            (false, false) => Site::Land,
            (true, _) if mesh.ring(i).iter().any(|&j| keeps(j)) => Site::Coast,
            (true, _) => Site::Sea,
        }
    });
    for (z, site) in ground.iter_mut().zip(&sites) {
        if *site == Site::Coast {
            *z = 0;
        }
    }
    sites
}

/// Which vertices lie under a sea.
fn seas(mesh: &SphereMesh, ground: &[i32]) -> Vec<bool> {
    const NONE: u32 = u32::MAX;
    let mut body = vec![NONE; mesh.len()];
    let mut areas: Vec<f64> = Vec::new();
    let mut stack = Vec::new();
    for start in 0..mesh.len() as u32 {
        if ground[start as usize] >= 0 || body[start as usize] != NONE {
            continue;
        }
        let id = areas.len() as u32;
        let mut area = 0.0;
        body[start as usize] = id;
        stack.push(start);
        while let Some(i) = stack.pop() {
            area += mesh.area(i);
            for &j in mesh.ring(i) {
                if ground[j as usize] < 0 && body[j as usize] == NONE {
                    body[j as usize] = id;
                    stack.push(j);
                }
            }
        }
        areas.push(area);
    }
    let largest = areas.iter().copied().fold(0.0, f64::max);
    let least = (SEA_SHARE * 4.0 * crate::math::PI).min(largest);
    body.into_iter()
        .map(|id| id != NONE && areas[id as usize] >= least)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;
    use crate::noise::Noise;
    use crate::random::Purpose;

    #[test]
    fn no_edge_joins_land_and_sea_and_the_land_keeps_its_area() {
        let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(2, 0.02)).unwrap();
        let noise = Noise::new(8, Purpose::Relief, 0);
        let mut ground = parallel::map(mesh.len(), |i| {
            (4e6 * noise.fractal(mesh.point(i), 2.0, 5)) as i32
        });
        let before: f64 = (0..mesh.len() as u32)
            .filter(|&i| ground[i as usize] >= 0)
            .map(|i| mesh.area(i))
            .sum();
        let sites = regularise(&mesh, &mut ground);
        let mut coast = 0.0;
        let mut land = 0.0;
        for i in 0..mesh.len() as u32 {
            match sites[i as usize] {
                Site::Land => {
                    land += mesh.area(i);
                    assert!(mesh.ring(i).iter().all(|&j| sites[j as usize] != Site::Sea));
                }
                Site::Coast => {
                    coast += mesh.area(i);
                    assert_eq!(ground[i as usize], 0);
                }
                Site::Sea => assert!(ground[i as usize] < 0),
            }
        }
        // The shore runs through the middle of the coast's vertices. Islands and spits, of which
        // this noise is full, keep their vertices and gain a shore.
        assert!(
            (land + 0.5 * coast - before).abs() < 0.08 * before,
            "{land} {coast} {before}"
        );
    }

    #[test]
    fn ponds_are_no_seas() {
        let mesh = SphereMesh::fibonacci(4000).unwrap();
        let pond = |p: bevy::math::DVec3| math::angle_between(p, bevy::math::DVec3::X) < 0.05;
        let mut ground = parallel::map(mesh.len(), |i| {
            let p = mesh.point(i);
            if p.z < 0.0 || pond(p) { -1000 } else { 100_000 }
        });
        let sites = regularise(&mesh, &mut ground);
        let dry = SphereMesh::fibonacci(200).unwrap();
        assert!((0..mesh.len()).all(|i| mesh.points()[i].z < 0.1 || sites[i] == Site::Land));
        assert!(
            regularise(&dry, &mut vec![5; 200])
                .iter()
                .all(|s| *s == Site::Land)
        );
        assert!(
            regularise(&dry, &mut vec![-5; 200])
                .iter()
                .all(|s| *s == Site::Sea)
        );
    }
}
