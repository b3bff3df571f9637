//! The long profiles of rivers: water that never runs uphill, beds that strictly descend, lakes
//! that are level.
//!
//! Two sweeps. Upstream first, every vertex learns how low it should lie for what comes from above
//! to run on (the least of its ground and of what drains to it, less the gradient), but no lower
//! than its river can wear it down ([`incision`]): breaching, where it costs less than the river
//! can pay. Then, downstream first, each takes that level, or one gradient above the vertex that it
//! drains to. Where that stands well above its ground water fills the hollow: a lake, at the level
//! of its outlet. Shallow hollows are filled with sediment instead.
//!
//! Depth follows discharge as d = 0.27 Q^0.30 (Moody and Troutman 2002), Q as on an Earth-sized
//! planet.

use super::flood::{NONE, Routes};
use super::growth::RiverNetwork;
use super::sinks::{Closed, incision};
use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;

/// Least fall of a river between two vertices, grains: 1 m, 2 cm per km, that of the lower Amazon.
pub const FALL: i32 = 1024;

/// Least depth of a hollow that holds a lake, grains: 20 m. Sediment fills shallower ones.
pub const LAKE_DEPTH: i32 = 20 * 1024;

/// Greatest depth of a lake, grains: 400 m. Crust is too coarse to tell a valley's floor from its
/// rims, so hollows come out kilometres deep, which sediment would fill. Of the Earth's great lakes
/// only young rifts and the deepest troughs of ice are deeper (Tanganyika 1470 m, Great Slave Lake
/// 614 m); Lake Superior has 406 m, Lake Ladoga 230 m.
pub const DEEPEST_LAKE: i32 = 400 * 1024;

/// A lake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lake {
    /// Level of the water in grains.
    pub level: i32,
    /// The river's vertex through which it drains, at the lake's level; [`NONE`] for a closed
    /// basin.
    pub outlet: u32,
    /// The vertex to which all of it drains, on its bottom or next to the outlet.
    pub sink: u32,
    /// Vertices under water.
    pub vertices: u32,
}

/// Levels along all rivers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Profile {
    /// Level of the water if there is any at the vertex, else of its ground, in grains; never rises
    /// downstream.
    pub level: Vec<i32>,
    /// River bed or lake floor in grains.
    pub bed: Vec<i32>,
    /// The lake that covers each vertex; [`NONE`] for none.
    pub lake: Vec<u32>,
    /// Lakes.
    pub lakes: Vec<Lake>,
}

/// Depth in grains of a river of a discharge in m³/s.
pub fn depth(discharge: f64) -> i32 {
    if discharge > 0.0 {
        (0.27 * math::pow(discharge, 0.3) * 1024.0) as i32
    } else {
        0
    }
}

/// Finds the levels for `routes` over `ground` in grains, with the earth-like discharge of each
/// vertex in m³/s.
pub(super) fn profile(
    mesh: &SphereMesh,
    routes: &Routes,
    ground: &[i32],
    discharge: impl Fn(u32) -> f64 + Sync,
    closed: &[Closed],
    network: RiverNetwork,
) -> Profile {
    let n = ground.len();
    let mut lake = vec![NONE; n];
    let mut lakes = Vec::new();
    for basin in closed {
        basin
            .vertices
            .iter()
            .for_each(|&i| lake[i as usize] = lakes.len() as u32);
        let sink = basin.vertices.first().copied().unwrap_or(NONE);
        lakes.push(Lake {
            level: basin.level,
            outlet: NONE,
            sink,
            vertices: basin.vertices.len() as u32,
        });
    }
    let wanted = breach(mesh, routes, ground, &discharge, &lake, network);
    let mut level: Vec<i32> = ground.to_vec();
    for &i in &routes.order {
        let k = i as usize;
        let r = match (lake[k], routes.receiver[k]) {
            (NONE, NONE) => continue,
            (NONE, to) => to as usize,
            (own, _) => {
                level[k] = lakes[own as usize].level;
                continue;
            }
        };
        let hollow = level[r].saturating_sub(wanted[k]);
        let open = lake[r] != NONE && lakes[lake[r] as usize].outlet != NONE;
        if open && hollow > 0 {
            lake[k] = lake[r];
        } else if lake[r] == NONE && hollow > LAKE_DEPTH {
            lake[k] = lakes.len() as u32;
            lakes.push(Lake {
                level: level[r],
                outlet: r as u32,
                sink: i,
                vertices: 0,
            });
        } else {
            level[k] = wanted[k].max(level[r] + FALL);
            continue;
        }
        lakes[lake[k] as usize].vertices += 1;
        level[k] = level[r];
    }
    let bed = beds(mesh, routes, ground, &level, &lake, &discharge);
    Profile {
        level,
        bed,
        lake,
        lakes,
    }
}

/// How low every vertex should lie for the water from upstream to run on, if its river can wear it
/// down so far.
fn breach(
    mesh: &SphereMesh,
    routes: &Routes,
    ground: &[i32],
    discharge: &(impl Fn(u32) -> f64 + Sync),
    lake: &[u32],
    network: RiverNetwork,
) -> Vec<i32> {
    let least = parallel::map(mesh.len(), |i| {
        if routes.receiver[i as usize] == NONE {
            return ground[i as usize];
        }
        match network {
            RiverNetwork::Drainage => ground[i as usize].saturating_sub(incision(discharge(i))),
            // A network that does not follow the relief cuts through whatever is in its way.
            RiverNetwork::Grown => ground[i as usize].min(0),
        }
    });
    let mut wanted = ground.to_vec();
    for &i in routes.order.iter().rev() {
        let k = i as usize;
        wanted[k] = wanted[k].max(least[k]);
        let to = routes.receiver[k];
        if to != NONE && lake[k] == NONE && lake[to as usize] == NONE {
            let r = to as usize;
            wanted[r] = wanted[r].min(wanted[k] - FALL);
        }
    }
    wanted
}

/// Beds: the depth of the river below its level; in lakes the ground, where that is lower, or the
/// sediment on it. At coasts the bed of the mouth.
fn beds(
    mesh: &SphereMesh,
    routes: &Routes,
    ground: &[i32],
    level: &[i32],
    lake: &[u32],
    discharge: &(impl Fn(u32) -> f64 + Sync),
) -> Vec<i32> {
    let mut wet = vec![false; ground.len()];
    routes.order.iter().for_each(|&i| wet[i as usize] = true);
    parallel::map(mesh.len(), |i| {
        let k = i as usize;
        let flow = discharge(i);
        // Coasts lie at 0, and only mouths have a discharge.
        if !wet[k] && flow <= 0.0 {
            return ground[k];
        }
        let river = level[k] - depth(flow);
        let sediment = level[k].saturating_sub(DEEPEST_LAKE);
        if lake[k] == NONE {
            river
        } else {
            river.min(ground[k].max(sediment))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sphere::SphereMesh;

    #[test]
    fn deep_rivers_are_those_of_much_water() {
        assert_eq!(depth(0.0), 0);
        assert_eq!(depth(1.0), 276);
        // The Mississippi at its mouth: some 17,000 m3/s and 5 m in the mean.
        assert!((4.0..8.0).contains(&(f64::from(depth(17_000.0)) / 1024.0)));
    }

    #[test]
    fn sills_are_breached_where_the_river_can_and_dam_lakes_elsewhere() {
        let mesh = SphereMesh::fibonacci(100).unwrap();
        // A chain 5 -> 4 -> 3 -> 2 -> 1 -> 0, the coast; 3 is a sill, 4 a hollow behind it.
        let routes = Routes {
            order: vec![1, 2, 3, 4, 5],
            receiver: (0..100)
                .map(|i| if (1..6).contains(&i) { i - 1 } else { NONE })
                .collect(),
            depressions: vec![],
        };
        let km = 1024 * 1000;
        let mut ground = vec![0; 100];
        ground[1..6].copy_from_slice(&[km / 10, km / 5, km, km / 2, 2 * km]);
        let weak = profile(
            &mesh,
            &routes,
            &ground,
            |_| 1.0,
            &[],
            RiverNetwork::Drainage,
        );
        assert_eq!(weak.level[3], km - incision(1.0));
        assert_eq!(weak.level[4], weak.level[3]);
        assert_eq!((weak.lake[4], weak.lake[3], weak.lake[5]), (0, NONE, NONE));
        assert_eq!(
            weak.bed[4],
            weak.level[4] - DEEPEST_LAKE,
            "750 m of water, but for the sediment"
        );
        assert_eq!(
            weak.lakes,
            [Lake {
                level: weak.level[3],
                outlet: 3,
                sink: 4,
                vertices: 1
            }]
        );
        let strong = profile(
            &mesh,
            &routes,
            &ground,
            |_| 40_000.0,
            &[],
            RiverNetwork::Drainage,
        );
        assert!(strong.lakes.is_empty());
        assert_eq!((strong.level[4], strong.level[3]), (km / 2, km / 2 - FALL));
        for k in 1..6 {
            assert!(
                strong.level[k] >= strong.level[k - 1] + FALL && strong.bed[k] > strong.bed[k - 1]
            );
        }
    }
}
