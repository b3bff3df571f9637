//! Sea, coast and land, such that no edge joins land and sea (paper 002 §4, Fig. 5d).
//!
//! A coast vertex lies between them: there rivers end, and estuaries have room. Of the two ends of
//! an edge between land and sea the one nearer to sea level becomes coast, so that the land keeps
//! its area in the mean. Hinterland is land with land all around it; land that does not touch any
//! stays land, or islands would vanish.
//!
//! For drainage a coast lies at sea level. The ground keeps its height ([`ground_of_coast`]): the
//! shore is where the ground crosses sea level, up to half an edge from the coast on either side.
//!
//! Policy. *Sea* is a connected body below 0 of at least [`SEA_SHARE`] of the planet, or the
//! largest body if all are smaller; a smaller one is land below sea level, and drainage decides
//! whether it holds a lake. The Caspian, Earth's largest lake by the name of a sea, has 0.07 % of
//! the area.

use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, OUTSIDE};
use bevy::reflect::Reflect;
use pangaea_shaders::amplify::fixed::metres;

/// Share of the planet's area from which on a body of water is a sea: between the Caspian's and
/// that of the smallest seas with an ocean's floor (Black Sea and Mediterranean together 0.6 %).
const SEA_SHARE: f64 = 0.0025;

/// The side of the shore that a vertex lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Reflect)]
pub enum ShoreClass {
    /// Under the sea.
    Sea,
    /// At sea level, between land and sea.
    Coast,
    /// Neither: dry land and lakes, at any height.
    Land,
}

/// Sorts the vertices of `mesh`, and moves the ground of coasts (in grains) to sea level.
pub(super) fn regularise(mesh: &SphereMesh, ground: &mut [i32]) -> Vec<ShoreClass> {
    let is_sea = seas(mesh, ground);
    let is_hinterland = parallel::map(mesh.len(), |i| {
        let land = |j: u32| !is_sea[j as usize];
        land(i) && !borders(mesh, i, |j| !land(j))
    });
    // Land gives way where it is lower than the sea is deep, unless it is an islet or a spit:
    // without hinterland it would vanish.
    let becomes_coast = parallel::map(mesh.len(), |i| {
        !is_sea[i as usize]
            && borders(mesh, i, |j| is_hinterland[j as usize])
            && is_nearer_to_sea_level(mesh, ground, &is_sea, i)
    });
    let stays_land = |j: u32| !is_sea[j as usize] && !becomes_coast[j as usize];
    let shore = parallel::map(mesh.len(), |i| match is_sea[i as usize] {
        // Where the land does not give way the sea does.
        true if borders(mesh, i, stays_land) => ShoreClass::Coast,
        true => ShoreClass::Sea,
        false if becomes_coast[i as usize] => ShoreClass::Coast,
        false => ShoreClass::Land,
    });
    for (z, class) in ground.iter_mut().zip(&shore) {
        if *class == ShoreClass::Coast {
            *z = 0;
        }
    }
    shore
}

/// How much higher than the terrain the ground stands at coasts, grains. Between a sample of land
/// and one of deep sea the terrain's own contour lies nearer to the land, and would drown a
/// twentieth of it. Fitted to three grown planets: their share of land, within 0.003.
const COAST_LIFT: i32 = metres(280);

/// Height of the ground at coast vertex `i`, grains: that of the terrain, lifted. An islet without
/// hinterland beside a deep sea reaches half of the way to its coast, whatever the depth.
pub(crate) fn ground_of_coast(
    mesh: &SphereMesh,
    shore: &[ShoreClass],
    terrain: &[i32],
    i: usize,
) -> i32 {
    let land = mesh.ring(i as u32).iter().map(|&j| j as usize);
    let heights = land
        .filter(|&j| shore[j] == ShoreClass::Land)
        .map(|j| terrain[j]);
    terrain[i].max(-heights.max().unwrap_or(0).max(0)) + COAST_LIFT
}

/// Whether a condition holds at some neighbour of vertex `i`.
fn borders(mesh: &SphereMesh, i: u32, is_such: impl Fn(u32) -> bool) -> bool {
    mesh.ring(i).iter().any(|&j| is_such(j))
}

/// Whether vertex `i`, on land, is less high than its neighbours in the sea are deep in the mean.
/// False where none of its neighbours lies in the sea.
fn is_nearer_to_sea_level(mesh: &SphereMesh, ground: &[i32], is_sea: &[bool], i: u32) -> bool {
    let height = i64::from(ground[i as usize]);
    // Sums instead of means: whole numbers, exact.
    let (mut count, mut depth) = (0, 0);
    for &j in mesh.ring(i).iter().filter(|&&j| is_sea[j as usize]) {
        count += 1;
        depth -= i64::from(ground[j as usize]);
    }
    count > 0 && height * count < depth
}

/// Whether each vertex lies under a sea; water that is no sea counts as land.
fn seas(mesh: &SphereMesh, ground: &[i32]) -> Vec<bool> {
    let bodies = Components::new(mesh, |i| ground[i as usize] < 0, |_, _| true);
    let mut areas = vec![0.0; bodies.count];
    for (i, &body) in (0..).zip(&bodies.of) {
        if body != OUTSIDE {
            areas[body as usize] += mesh.area(i);
        }
    }
    // A planet whose waters are all small keeps the largest as its sea.
    let largest = areas.iter().copied().fold(0.0, f64::max);
    let least = (SEA_SHARE * 4.0 * math::PI).min(largest);
    let is_sea = |body: u32| body != OUTSIDE && areas[body as usize] >= least;
    bodies.of.into_iter().map(is_sea).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise::Noise;
    use crate::random::Purpose;
    use bevy::math::DVec3;

    /// Area of the vertices that fulfil a condition, in steradians.
    fn area(mesh: &SphereMesh, is_such: impl Fn(usize) -> bool) -> f64 {
        (0..mesh.len())
            .filter(|&i| is_such(i))
            .map(|i| mesh.area(i as u32))
            .sum()
    }

    #[test]
    fn no_edge_joins_land_and_sea_and_the_land_keeps_its_area() {
        let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(2, 0.02)).unwrap();
        let noise = Noise::new(8, Purpose::Relief, 0);
        let mut ground = parallel::map(mesh.len(), |i| {
            (4e6 * noise.fractal(mesh.point(i), 2.0, 5)) as i32
        });
        let before = area(&mesh, |i| ground[i] >= 0);
        let shore = regularise(&mesh, &mut ground);
        for i in 0..mesh.len() {
            match shore[i] {
                ShoreClass::Land => assert!(!borders(&mesh, i as u32, |j| {
                    shore[j as usize] == ShoreClass::Sea
                })),
                ShoreClass::Coast => assert_eq!(ground[i], 0),
                ShoreClass::Sea => assert!(ground[i] < 0),
            }
        }
        let land = area(&mesh, |i| shore[i] == ShoreClass::Land);
        let coast = area(&mesh, |i| shore[i] == ShoreClass::Coast);
        // The shore runs through the middle of the coast's vertices. Islands and spits, of which
        // this noise is full, keep their vertices and gain a shore.
        let change = land + 0.5 * coast - before;
        assert!(change.abs() < 0.08 * before, "{land} {coast} {before}");
    }

    #[test]
    fn ponds_are_no_seas() {
        let mesh = SphereMesh::fibonacci(4000).unwrap();
        let mut ground = parallel::map(mesh.len(), |i| {
            let p = mesh.point(i);
            let is_pond = math::angle_between(p, DVec3::X) < 0.05;
            if p.z < 0.0 || is_pond { -1000 } else { 100_000 }
        });
        let shore = regularise(&mesh, &mut ground);
        let north = (0..mesh.len()).filter(|&i| mesh.points()[i].z >= 0.1);
        assert!(north.into_iter().all(|i| shore[i] == ShoreClass::Land));
    }

    #[test]
    fn planets_of_land_or_sea_alone_have_no_coast() {
        let mesh = SphereMesh::fibonacci(200).unwrap();
        for (z, class) in [(5, ShoreClass::Land), (-5, ShoreClass::Sea)] {
            let shore = regularise(&mesh, &mut vec![z; 200]);
            assert!(shore.iter().all(|&found| found == class));
        }
    }
}
