//! Figures of rivers and lakes: Horton's ratios, Hack's exponent, discharges (`stats.json`).
//!
//! A *stream* of order ω is an unbroken run of vertices of that order. Horton's laws say that the
//! numbers of streams fall, and their mean lengths and areas grow, by constant ratios from order to
//! order: R_B 3 to 5, R_L 1.5 to 3.5, R_A 3 to 6 on Earth (Horton 1945, Schumm 1956). Hack's law
//! says that the longest way upstream grows with a power of 0.57 to 0.6 of the area (Hack 1957).
//! Ratios and power are slopes of straight lines fitted to logarithms.
//!
//! Policies. Channels begin where `SUPPORT` vertices drain together: the network of single vertices
//! is the mesh's, not the land's (as in any network drawn from a grid, Tarboton, Bras and
//! Rodriguez-Iturbe 1991). Orders with fewer than ten streams are left out of the fit, and basins
//! of fewer than ten vertices.

use super::flood::NONE;
use super::{Drainage, Site, flow, order};
use crate::climate::Climate;
use crate::math;
use crate::sphere::SphereMesh;

/// Vertices that must drain together to make a channel.
const SUPPORT: u32 = 5;

/// Order that a basin must reach to count as a network.
const NETWORK: u8 = 3;

/// Figures of the hydrology of a planet.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct HydrologyStats {
    /// Mean rain on land in mm per year.
    pub land_rain_mm_mean: f64,
    /// What all rivers together bring to the sea and to closed lakes, in m³/s.
    pub discharge_total_m3s: f64,
    /// Discharge of the largest river in m³/s.
    pub largest_river_m3s: f64,
    /// Length of the longest river from spring to mouth in km.
    pub longest_river_km: f64,
    /// Share of the land whose water never reaches the sea.
    pub endorheic_share: f64,
    /// Number of lakes.
    pub lakes: usize,
    /// Horton's ratios; 0 where there are too few streams.
    pub horton: Horton,
    /// Exponent of Hack's law; 0 where there are too few basins.
    pub hack_exponent: f64,
    /// Highest Horton–Strahler order.
    pub strahler_max: u8,
}

/// Horton's ratios.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Horton {
    /// Bifurcation ratio R_B: streams of one order to those of the next.
    pub rb: f64,
    /// Length ratio R_L.
    pub rl: f64,
    /// Area ratio R_A.
    pub ra: f64,
}

impl HydrologyStats {
    /// The figures of a drainage.
    pub fn new(mesh: &SphereMesh, climate: &Climate, drainage: &Drainage) -> Self {
        let land = |i: usize| drainage.sites[i] == Site::Land;
        let area = |i: usize| mesh.area(i as u32);
        let total = |value: &dyn Fn(usize) -> f64| {
            (0..mesh.len()).filter(|&i| land(i)).map(value).sum::<f64>()
        };
        let land_area = total(&area);
        let share = |x: f64| if land_area > 0.0 { x / land_area } else { 0.0 };
        let rain = |i: usize| area(i) * f64::from(climate.rain[i]);
        let closed = |i: usize| {
            if drainage.is_endorheic(i) {
                area(i)
            } else {
                0.0
            }
        };
        let ends = || (0..mesh.len()).filter(|&i| drainage.routes.receiver[i] == NONE);
        let upstream = Upstream::new(mesh, drainage);
        Self {
            land_rain_mm_mean: share(total(&rain)),
            discharge_total_m3s: flow::per_second(ends().map(|i| drainage.discharge[i]).sum()),
            largest_river_m3s: flow::per_second(
                ends().map(|i| drainage.discharge[i]).max().unwrap_or(0),
            ),
            longest_river_km: upstream.length.iter().copied().fold(0.0, f64::max) * drainage.radius,
            endorheic_share: share(total(&closed)),
            lakes: drainage.profile.lakes.len(),
            horton: upstream.horton(drainage),
            hack_exponent: upstream.hack(drainage),
            strahler_max: drainage.strahler.iter().copied().max().unwrap_or(0),
        }
    }
}

/// What lies upstream of each vertex, in radians and steradians.
struct Upstream {
    /// Longest way upstream.
    length: Vec<f64>,
    /// Area, the vertex's own included.
    area: Vec<f64>,
    /// Length of the stream so far, from its beginning down to the vertex.
    stream: Vec<f64>,
    /// Vertices upstream.
    count: Vec<u32>,
    /// Horton–Strahler order of the channels; 0 for what is none.
    order: Vec<u8>,
}

impl Upstream {
    fn new(mesh: &SphereMesh, drainage: &Drainage) -> Self {
        let n = mesh.len();
        let routes = &drainage.routes;
        let (mut length, mut area, mut stream) = (vec![0.0_f64; n], vec![0.0; n], vec![0.0; n]);
        let mut count = vec![0; n];
        for &i in routes.order.iter().rev() {
            let (k, to) = (i as usize, routes.receiver[i as usize]);
            area[k] += mesh.area(i);
            count[k] += 1;
            if to != NONE {
                let r = to as usize;
                length[r] =
                    length[r].max(length[k] + math::angle_between(mesh.point(i), mesh.point(to)));
                area[r] += area[k];
                count[r] += count[k];
            }
        }
        let order = order::strahler_of(routes, |i| count[i as usize] >= SUPPORT);
        for &i in routes.order.iter().rev() {
            let (k, to) = (i as usize, routes.receiver[i as usize]);
            if to != NONE {
                let r = to as usize;
                stream[k] += math::angle_between(mesh.point(i), mesh.point(to));
                if order[r] == order[k] {
                    stream[r] = stream[k].max(stream[r]);
                }
            }
        }
        Self {
            length,
            area,
            stream,
            count,
            order,
        }
    }

    /// The last vertices of all streams.
    fn mouths<'a>(&'a self, drainage: &'a Drainage) -> impl Iterator<Item = usize> + 'a {
        drainage
            .routes
            .order
            .iter()
            .map(|&i| i as usize)
            .filter(|&i| {
                let to = drainage.routes.receiver[i];
                self.order[i] > 0 && (to == NONE || self.order[to as usize] != self.order[i])
            })
    }

    fn horton(&self, drainage: &Drainage) -> Horton {
        // Number, sum of lengths and sum of areas of the streams of each order.
        let mut orders = [(0.0, 0.0, 0.0); 256];
        // The laws are those of networks: a brook that reaches the sea by itself is none.
        let mut top = vec![0; self.order.len()];
        for i in self.mouths(drainage) {
            let basin = &mut top[drainage.basin[i] as usize];
            *basin = self.order[i].max(*basin);
        }
        for i in self
            .mouths(drainage)
            .filter(|&i| top[drainage.basin[i] as usize] >= NETWORK)
        {
            let (count, length, area) = &mut orders[usize::from(self.order[i])];
            (*count, *length, *area) =
                (*count + 1.0, *length + self.stream[i], *area + self.area[i]);
        }
        let known: Vec<(f64, (f64, f64, f64))> = (1..=255)
            .map(|order| (f64::from(order), orders[order as usize]))
            .filter(|(_, (count, length, _))| *count >= 10.0 && *length > 0.0)
            .collect();
        let ratio = |value: &dyn Fn((f64, f64, f64)) -> f64| {
            let points: Vec<_> = known
                .iter()
                .map(|&(order, sums)| (order, math::ln(value(sums))))
                .collect();
            slope(&points).map_or(0.0, math::exp)
        };
        Horton {
            rb: ratio(&|(n, ..)| 1.0 / n),
            rl: ratio(&|(n, l, _)| l / n),
            ra: ratio(&|(n, _, a)| a / n),
        }
    }

    fn hack(&self, drainage: &Drainage) -> f64 {
        let basins = self
            .mouths(drainage)
            .filter(|&i| self.count[i] >= 10 && self.length[i] > 0.0);
        let points: Vec<_> = basins
            .map(|i| (math::ln(self.area[i]), math::ln(self.length[i])))
            .collect();
        slope(&points).unwrap_or(0.0)
    }
}

/// Slope of the straight line that fits points best; none for fewer than two different ones.
fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let n = points.len() as f64;
    let (mx, my) = points
        .iter()
        .fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let (xx, xy) = points.iter().fold((0.0, 0.0), |(xx, xy), p| {
        (xx + (p.0 - mx) * (p.0 - mx), xy + (p.0 - mx) * (p.1 - my))
    });
    (xx > 1e-12).then(|| xy / xx)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hydrology::{Routes, order};

    #[test]
    fn slopes_are_those_of_lines() {
        assert_eq!(slope(&[(1.0, 2.0)]), None);
        assert!((slope(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]).unwrap() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_binary_tree_bifurcates_by_two() {
        // 0 is the coast; 1 the trunk; vertex k has the children 2k and 2k + 1.
        let mesh = SphereMesh::fibonacci(512).unwrap();
        let routes = Routes {
            order: (1..512).collect(),
            receiver: (0..512)
                .map(|k| if k == 0 { NONE } else { k / 2 })
                .collect(),
            depressions: vec![],
        };
        let drainage = Drainage {
            sites: (0..512)
                .map(|k| if k == 0 { Site::Coast } else { Site::Land })
                .collect(),
            ground: vec![0; 512],
            supply: vec![1; 512],
            discharge: vec![1; 512],
            strahler: order::strahler(&routes),
            basin: vec![0; 512],
            routes,
            radius: 6370.0,
            ..Drainage::default()
        };
        let climate = Climate {
            rain: vec![500.0; 512],
            ..Climate::default()
        };
        let stats = HydrologyStats::new(&mesh, &climate, &drainage);
        assert!((stats.horton.rb - 2.0).abs() < 1e-9, "{:?}", stats.horton);
        // Areas are 1, 3, 7, ... cells.
        assert!((1.9..2.3).contains(&stats.horton.ra), "{:?}", stats.horton);
        assert_eq!(stats.strahler_max, 9);
        assert!((stats.land_rain_mm_mean - 500.0).abs() < 1e-9 && stats.endorheic_share == 0.0);
    }
}
