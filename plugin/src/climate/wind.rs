//! The prevailing winds: easterly trades up to 30°, westerlies up to 65°, polar easterlies (the
//! three cells of a textbook's general circulation, Hartmann 1994, ch. 6).
//!
//! Trades blow towards the equator, the others towards the pole; all belts follow the sun.
//! Directions depend on latitude and season alone, so what lies upwind of each vertex is found once
//! per mesh, and so is an order in which nearly every vertex comes after its upwind neighbours: by
//! longitude, eastwards in the westerlies, westwards elsewhere. One sweep in that order carries
//! moisture around the planet.

use crate::math;
use crate::math::east_north;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Where trades give way to westerlies, and westerlies to polar winds, in degrees.
const BELTS: [f64; 2] = [30.0, 65.0];

/// Where the poleward wind beyond the trades would end, in degrees: beyond the pole, so that some
/// of it crosses the polar front and reaches the pole.
const POLEWARD_END: f64 = 100.0;

/// Poleward (or equatorward) part of the wind, relative to the part along the parallel.
const SLANT: f64 = 0.35;

/// What lies upwind of a vertex: a point on the edge between two of its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Upwind {
    /// The edge's ends.
    pub from: [u32; 2],
    /// Weight of the second end.
    pub weight: f32,
    /// Distance in radians.
    pub distance: f32,
}

/// Winds of one season on a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Belts {
    /// Degrees by which all belts lie farther north than in the mean.
    pub shift: f64,
    /// Distance of every vertex from the belts' middle in degrees.
    pub latitude: Vec<f32>,
    /// What lies upwind of every vertex.
    pub upwind: Vec<Upwind>,
    /// The vertices, each after those upwind of it wherever that can be.
    pub order: Vec<u32>,
}

/// Winds on a mesh in the northern and in the southern summer.
#[derive(Clone, Debug, PartialEq)]
pub struct Winds {
    /// The belts in both seasons.
    pub seasons: [Belts; 2],
}

/// How far the belts follow the sun, in degrees: the convergence of the trades wanders between
/// about 8° S and 8° N and beyond.
pub const SEASON: f64 = 8.0;

/// Eastward and northward part of the wind at a latitude in degrees from the belts' middle; its
/// strength is 1 in the middle of the trades and westerlies.
pub fn wind(latitude: f64) -> (f64, f64) {
    let a = latitude.abs();
    let bump = |from: f64, to: f64| math::sin(math::PI * (a - from) / (to - from));
    let (east, poleward) = if a < BELTS[0] {
        // The trades are strongest half way, but at the equator there still is an easterly.
        (
            -math::cos(0.5 * math::PI * a / BELTS[0]),
            -SLANT * bump(0.0, BELTS[0]),
        )
    } else {
        // Eddies carry moisture poleward across the polar front.
        let poleward = SLANT * bump(BELTS[0], POLEWARD_END);
        let east = if a < BELTS[1] {
            bump(BELTS[0], BELTS[1])
        } else {
            -0.6 * bump(BELTS[1], 90.0)
        };
        (east, poleward)
    };
    (east, if latitude < 0.0 { -poleward } else { poleward })
}

impl Winds {
    /// The winds on `mesh`.
    pub fn new(mesh: &SphereMesh) -> Self {
        Self {
            seasons: [SEASON, -SEASON].map(|shift| Belts::new(mesh, shift)),
        }
    }
}

impl Belts {
    fn new(mesh: &SphereMesh, shift: f64) -> Self {
        let upwind = parallel::map(mesh.len(), |i| upwind(mesh, i, shift));
        let mut keys: Vec<u64> = parallel::map(mesh.len(), |i| {
            let (lat, lon) = math::lat_lon(mesh.point(i));
            let along = if wind(lat - shift).0 >= 0.0 {
                lon
            } else {
                -lon
            };
            ((((along + 180.0) / 360.0) * f64::from(u32::MAX)) as u64) << 32 | u64::from(i)
        });
        keys.par_sort_unstable();
        let latitude = parallel::map(mesh.len(), |i| {
            (math::lat_lon(mesh.point(i)).0 - shift).abs() as f32
        });
        Self {
            shift,
            latitude,
            upwind,
            order: keys.into_iter().map(|key| key as u32).collect(),
        }
    }
}

/// The edge opposite to vertex `i` that the wind comes across.
fn upwind(mesh: &SphereMesh, i: u32, shift: f64) -> Upwind {
    let p = mesh.point(i);
    let (east, north) = east_north(p);
    let (u, v) = wind(math::lat_lon(p).0 - shift);
    let to = if u * u + v * v > 1e-12 {
        east * u + north * v
    } else {
        east
    };
    let against = -to.normalize();
    let across = p.cross(against);
    // Neighbours as coordinates along the ray and to its left.
    let place = |j: u32| {
        let d = mesh.point(j) - p;
        (d.dot(against), d.dot(across))
    };
    let ring = mesh.ring(i);
    let mut previous = ring[ring.len() - 1];
    for &j in ring {
        let ((xa, ya), (xb, yb)) = (place(previous), place(j));
        // The ring runs counter-clockwise: the ray is crossed from its right to its left.
        if ya <= 0.0 && yb > 0.0 {
            let weight = ya / (ya - yb);
            let distance = xa + (xb - xa) * weight;
            if distance > 0.0 {
                return Upwind {
                    from: [previous, j],
                    weight: weight as f32,
                    distance: distance as f32,
                };
            }
        }
        previous = j;
    }
    let nearest =
        |&a: &u32, &b: &u32| angle(mesh, p, a, against).total_cmp(&angle(mesh, p, b, against));
    let j = ring
        .iter()
        .copied()
        .max_by(|a, b| nearest(a, b))
        .unwrap_or(i);
    Upwind {
        from: [j, j],
        weight: 0.0,
        distance: (mesh.point(j) - p).length() as f32,
    }
}

/// Cosine between the way to `j` and a direction.
fn angle(mesh: &SphereMesh, p: DVec3, j: u32, direction: DVec3) -> f64 {
    (mesh.point(j) - p).normalize_or(DVec3::ZERO).dot(direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn belts_blow_as_on_earth() {
        for lat in [5.0, 15.0, 25.0] {
            let (u, v) = wind(lat);
            assert!(u < 0.0 && v < 0.0, "trades at {lat}: {u} {v}");
            assert_eq!(wind(-lat), (u, -v));
        }
        let (u, v) = wind(47.0);
        assert!(u > 0.9 && v > 0.0);
        assert!(wind(75.0).0 < 0.0);
    }

    #[test]
    fn upwind_points_lie_against_the_wind() {
        let mesh = SphereMesh::fibonacci(4000).unwrap();
        let winds = Belts::new(&mesh, 0.0);
        for i in 0..mesh.len() as u32 {
            let p = mesh.point(i);
            let lat = math::lat_lon(p).0;
            if lat.abs() > 85.0 {
                continue;
            }
            let Upwind {
                from: [a, b],
                weight,
                distance,
            } = winds.upwind[i as usize];
            let at = mesh.point(a).lerp(mesh.point(b), f64::from(weight)) - p;
            let (east, north) = east_north(p);
            let (u, v) = wind(lat);
            let to = (east * u + north * v).normalize();
            assert!(
                at.normalize().dot(to) < -0.99,
                "{i} at {lat}: {}",
                at.normalize().dot(to)
            );
            assert!((f64::from(distance) / at.dot(-to) - 1.0).abs() < 1e-3);
        }
        let mut seen = winds.order.clone();
        seen.sort_unstable();
        assert!(seen.iter().enumerate().all(|(i, &j)| i as u32 == j));
    }

    #[test]
    fn upwind_comes_first_nearly_everywhere() {
        let mesh = SphereMesh::fibonacci(4000).unwrap();
        let winds = Belts::new(&mesh, 0.0);
        let mut rank = vec![0; mesh.len()];
        winds
            .order
            .iter()
            .enumerate()
            .for_each(|(k, &i)| rank[i as usize] = k);
        let late = |i: usize| {
            let up = winds.upwind[i];
            up.from.iter().any(|&j| rank[j as usize] > rank[i])
        };
        let count = (0..mesh.len()).filter(|&i| late(i)).count();
        assert!(count < mesh.len() / 5, "{count}");
    }
}
