//! Figures of rivers and lakes: Horton's ratios, Hack's exponent, discharges (`stats.json`).
//!
//! A *stream* of order ω is an unbroken run of vertices of that order. Horton's laws say that the
//! numbers of streams fall, and their mean lengths and areas grow, by constant ratios from order to
//! order: R_B 3 to 5, R_L 1.5 to 3.5, R_A 3 to 6 on Earth (Horton 1945, Schumm 1956). Hack's law
//! says that the longest way upstream grows with a power of 0.57 to 0.6 of the area (Hack 1957).
//! Ratios and power are slopes of straight lines fitted to logarithms.
//!
//! Policies. A vertex is part of a channel if at least five vertices drain to it, itself included:
//! what drains less follows the edges of the mesh rather than the land (as in any network drawn
//! from a grid, Tarboton, Bras and Rodriguez-Iturbe 1991). The fit of Horton's laws leaves out
//! orders of fewer than ten streams, the fit of Hack's law streams with fewer than ten vertices
//! upstream.

use super::coast::ShoreClass;
use super::drainage::Drainage;
use super::flood::NO_VERTEX;
use super::flow;
use super::order;
use crate::climate::Climate;
use crate::math;
use crate::sphere::SphereMesh;
use bevy::reflect::Reflect;

/// Fewest vertices that drain to a vertex of a channel, itself included: 13,500 km² on an
/// Earth-sized planet.
const CHANNEL_SUPPORT: u32 = 5;

/// Least Horton–Strahler order that a basin must reach for its streams to count in Horton's ratios.
const NETWORK_ORDER: u8 = 3;

/// Fewest streams of an order that counts in the fit of Horton's laws.
const FEWEST_STREAMS: f64 = 10.0;

/// Fewest vertices upstream of a stream's mouth, itself included, that count in the fit of Hack's
/// law.
const FEWEST_VERTICES: u32 = 10;

/// Figures of the hydrology of a planet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Reflect, serde::Serialize)]
pub struct HydrologyStats {
    /// Mean rain on land in mm per year.
    pub land_rain_mm_mean: f64,
    /// Discharge of all rivers together into the sea and into closed lakes, in m³/s.
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Reflect, serde::Serialize)]
pub struct Horton {
    /// Bifurcation ratio R_B: number of streams of an order, divided by that of the next higher.
    pub rb: f64,
    /// Length ratio R_L: mean length of the streams of an order, divided by that of the next lower.
    pub rl: f64,
    /// Area ratio R_A: mean area that streams of an order drain, divided by that of the next lower.
    pub ra: f64,
}

impl HydrologyStats {
    /// The figures of a drainage.
    pub fn new(mesh: &SphereMesh, climate: &Climate, drainage: &Drainage) -> Self {
        let land = LandVertices::new(mesh, drainage);
        let endorheic = |i: usize| if drainage.is_endorheic(i) { 1.0 } else { 0.0 };
        // Rivers end where nothing receives them: at coasts, and in sinks.
        let ends = (0..mesh.len()).filter(|&i| drainage.routes.receiver[i] == NO_VERTEX);
        let discharges: Vec<u64> = ends.map(|i| drainage.discharge[i]).collect();
        let upstream = Upstream::new(mesh, drainage);
        let longest = upstream.length.iter().copied().fold(0.0, f64::max);
        Self {
            land_rain_mm_mean: land.mean(|i| f64::from(climate.rain[i])),
            discharge_total_m3s: flow::per_second(discharges.iter().sum()),
            largest_river_m3s: flow::per_second(discharges.iter().copied().max().unwrap_or(0)),
            longest_river_km: longest * drainage.radius,
            endorheic_share: land.mean(endorheic),
            lakes: drainage.profile.lakes.len(),
            horton: upstream.horton(drainage),
            hack_exponent: upstream.hack(drainage),
            strahler_max: drainage.strahler.iter().copied().max().unwrap_or(0),
        }
    }
}

/// The vertices on land.
struct LandVertices<'a> {
    mesh: &'a SphereMesh,
    vertices: Vec<u32>,
    /// Their area in steradians.
    area: f64,
}

impl<'a> LandVertices<'a> {
    fn new(mesh: &'a SphereMesh, drainage: &Drainage) -> Self {
        let is_land = |i: &u32| drainage.shore[*i as usize] == ShoreClass::Land;
        let vertices: Vec<u32> = (0..mesh.len() as u32).filter(is_land).collect();
        let area = vertices.iter().map(|&i| mesh.area(i)).sum();
        Self {
            mesh,
            vertices,
            area,
        }
    }

    /// The mean of a value by area; 0 where there is no land.
    fn mean(&self, value: impl Fn(usize) -> f64) -> f64 {
        let parts = self.vertices.iter();
        let sum: f64 = parts.map(|&i| self.mesh.area(i) * value(i as usize)).sum();
        if self.area > 0.0 {
            sum / self.area
        } else {
            0.0
        }
    }
}

/// The rivers upstream of each vertex, in radians and steradians.
struct Upstream {
    /// Longest way upstream.
    length: Vec<f64>,
    /// Area, the vertex's own included.
    area: Vec<f64>,
    /// Length of the stream so far, from its beginning down to the vertex.
    stream: Vec<f64>,
    /// Vertices upstream, its own included.
    count: Vec<u32>,
    /// Horton–Strahler order of the channels; 0 elsewhere.
    order: Vec<u8>,
}

impl Upstream {
    fn new(mesh: &SphereMesh, drainage: &Drainage) -> Self {
        let mut upstream = Self {
            length: vec![0.0; mesh.len()],
            area: vec![0.0; mesh.len()],
            stream: vec![0.0; mesh.len()],
            count: vec![0; mesh.len()],
            order: Vec::new(),
        };
        upstream.add_up(mesh, drainage);
        // Counts first: they tell channels, and orders are counted along channels alone.
        let is_channel = |i: u32| upstream.count[i as usize] >= CHANNEL_SUPPORT;
        upstream.order = order::strahler_of(&drainage.routes, is_channel);
        upstream.follow_streams(mesh, drainage);
        upstream
    }

    /// Lengths, areas and counts, from the springs down.
    fn add_up(&mut self, mesh: &SphereMesh, drainage: &Drainage) {
        for &i in drainage.routes.order.iter().rev() {
            let k = i as usize;
            self.area[k] += mesh.area(i);
            self.count[k] += 1;
            let to = drainage.routes.receiver[k];
            if to != NO_VERTEX {
                let r = to as usize;
                let edge = math::angle_between(mesh.point(i), mesh.point(to));
                self.length[r] = self.length[r].max(self.length[k] + edge);
                self.area[r] += self.area[k];
                self.count[r] += self.count[k];
            }
        }
    }

    /// Lengths of streams. A stream goes on as long as its order does; the edge from its last
    /// vertex to the next stream is part of it.
    fn follow_streams(&mut self, mesh: &SphereMesh, drainage: &Drainage) {
        for &i in drainage.routes.order.iter().rev() {
            let k = i as usize;
            let to = drainage.routes.receiver[k];
            if to != NO_VERTEX {
                let r = to as usize;
                self.stream[k] += math::angle_between(mesh.point(i), mesh.point(to));
                if self.order[r] == self.order[k] {
                    self.stream[r] = self.stream[k].max(self.stream[r]);
                }
            }
        }
    }

    /// The last vertices of all streams.
    fn mouths<'a>(&'a self, drainage: &'a Drainage) -> impl Iterator<Item = usize> + 'a {
        let order = drainage.routes.order.iter().map(|&i| i as usize);
        order.filter(|&i| self.is_mouth(i, drainage.routes.receiver[i]))
    }

    /// Whether a stream ends at vertex `i`, which drains to `receiver`.
    fn is_mouth(&self, i: usize, receiver: u32) -> bool {
        let order = self.order[i];
        order > 0 && (receiver == NO_VERTEX || self.order[receiver as usize] != order)
    }

    /// The highest order in the basin that ends at each vertex, a coast or a sink; 0 at others.
    fn highest_orders(&self, drainage: &Drainage) -> Vec<u8> {
        let mut highest = vec![0; self.order.len()];
        for i in self.mouths(drainage) {
            let basin = &mut highest[drainage.basin[i] as usize];
            *basin = self.order[i].max(*basin);
        }
        highest
    }

    /// Horton's ratios over the streams of networks: a brook that reaches the sea by itself is not
    /// part of one.
    fn horton(&self, drainage: &Drainage) -> Horton {
        let highest = self.highest_orders(drainage);
        let mut orders = [StreamSums::default(); 256];
        for i in self.mouths(drainage) {
            if highest[drainage.basin[i] as usize] >= NETWORK_ORDER {
                orders[usize::from(self.order[i])].add(self.stream[i], self.area[i]);
            }
        }
        Horton {
            // Numbers of streams fall from order to order: their inverse grows by R_B.
            rb: ratio(&orders, |sums| 1.0 / sums.count),
            rl: ratio(&orders, |sums| sums.length / sums.count),
            ra: ratio(&orders, |sums| sums.area / sums.count),
        }
    }

    /// The exponent of Hack's law, over all streams.
    fn hack(&self, drainage: &Drainage) -> f64 {
        let counts = |i: &usize| self.count[*i] >= FEWEST_VERTICES && self.length[*i] > 0.0;
        let points: Vec<_> = self
            .mouths(drainage)
            .filter(counts)
            .map(|i| (math::ln(self.area[i]), math::ln(self.length[i])))
            .collect();
        slope(&points).unwrap_or(0.0)
    }
}

/// The streams of one order.
#[derive(Clone, Copy, Default)]
struct StreamSums {
    /// Number of streams.
    count: f64,
    /// Sum of their lengths in radians.
    length: f64,
    /// Sum of the areas that they drain, in steradians.
    area: f64,
}

impl StreamSums {
    fn add(&mut self, length: f64, area: f64) {
        self.count += 1.0;
        self.length += length;
        self.area += area;
    }
}

/// The constant ratio by which a value grows from order to order: e to the slope of its logarithms;
/// 0 where too few orders count.
fn ratio(orders: &[StreamSums; 256], value: impl Fn(StreamSums) -> f64) -> f64 {
    let counts = |sums: &StreamSums| sums.count >= FEWEST_STREAMS && sums.length > 0.0;
    let points: Vec<_> = (0..)
        .zip(orders)
        .skip(1)
        .filter(|(_, sums)| counts(sums))
        .map(|(order, &sums)| (f64::from(order), math::ln(value(sums))))
        .collect();
    slope(&points).map_or(0.0, math::exp)
}

/// Slope of the straight line that fits points (x, y) best; `None` where all have one x.
fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let n = points.len() as f64;
    let (mut mean_x, mut mean_y) = (0.0, 0.0);
    for (x, y) in points {
        mean_x += x / n;
        mean_y += y / n;
    }
    // About the means: sums of plain squares would lose digits to each other.
    let (mut variance, mut covariance) = (0.0, 0.0);
    for (x, y) in points {
        variance += (x - mean_x) * (x - mean_x);
        covariance += (x - mean_x) * (y - mean_y);
    }
    (variance > 1e-12).then(|| covariance / variance)
}

#[cfg(test)]
#[path = "stats_tests.rs"]
mod tests;
