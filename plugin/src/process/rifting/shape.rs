//! The shape of a rift and the motions that open it (paper 000 §4.4).
//!
//! *Two fragments* part along a great circle with a warp, and turn about a pole on the circle's
//! extension outside of the plate: the gap opens like a pair of scissors, and nowhere do they meet
//! again. *Three or four* are sectors around a junction and move away from it; the normal velocity
//! along every line is `cos r` times that at the junction. *A user's line* is followed from its
//! first point to its last and extended by great circles. *A plate wider than half the sphere* has
//! no such circle: it sheds a bite, which a small circle about a point near its border cuts off;
//! the same turn opens that, as long as the arc within the plate is less than half of the circle.
//! *A plate that goes all the way round*, as the last one of a planet does, is torn along a whole
//! great circle: one half of it opens, and along the other the fragments converge.
//!
//! A warp shifts a line by an amount that depends only on the position along it: the line stays a
//! graph over the great circle, so that rigid fragments slide off each other without catching.
//! Voronoi cells of random centroids, as printed, have lines that cannot all open; sectors are
//! their neighbourhood of one junction.

use super::opening::{beside_circle, open_half, open_line, open_sectors};
use crate::math::{PI, TAU, angle_between, any_tangent, asin, atan2, sin, sin_cos};
use crate::noise::Noise;
use crate::random::Stream;
use bevy::math::DVec3;

/// How a plate is split. All directions are in world coordinates.
#[derive(Clone, Debug)]
pub enum RiftShape {
    /// Two fragments on either side of a warped circle.
    Line {
        /// Unit direction of the circle's centre; the first fragment lies on its side.
        center: DVec3,
        /// Angular radius in radians; a quarter of a turn makes it a great circle.
        radius: f64,
        /// Unit vector normal to `center`: positions along the circle are azimuths from it.
        origin: DVec3,
        /// Whether the line is a whole circle within the plate, of which one half opens.
        all_round: bool,
        /// Warp of the line.
        warp: Warp,
    },
    /// Two fragments on either side of a polyline.
    Path {
        /// Unit directions of its points, at least two.
        points: Vec<DVec3>,
        /// Warp of the line.
        warp: Warp,
    },
    /// Fragments around a junction.
    Sectors {
        /// Unit direction of the junction.
        junction: DVec3,
        /// Azimuths of the lines in ascending order, 0..2π.
        azimuths: Vec<f64>,
        /// Warp of the lines.
        warp: Warp,
    },
}

/// The shift of a line as a function of the position along it.
#[derive(Clone, Copy, Debug)]
pub struct Warp {
    /// The noise.
    pub noise: Noise,
    /// Largest shift in radians.
    pub amplitude: f64,
    /// Periods of the noise per radian.
    pub frequency: f64,
}

impl Warp {
    /// Shift at the position `t` radians along line number `line`.
    fn shift(&self, t: f64, line: usize) -> f64 {
        // Lines of a junction lie far apart in the noise, so each has a form of its own.
        let p = DVec3::new(t, 3.7 * line as f64, 0.5);
        self.amplitude * self.noise.fractal(p, self.frequency, 4)
    }
}

impl RiftShape {
    /// A random line or junction through a plate around `centroid` with the extent `reach` radians.
    pub fn random(
        stream: &Stream,
        counter: u64,
        centroid: DVec3,
        reach: f64,
        fragments: u32,
        warp: Warp,
    ) -> Self {
        let draw = |k: u64| stream.unit(16 * counter + k);
        let east = any_tangent(centroid);
        let north = centroid.cross(east);
        let (s, c) = sin_cos(TAU * draw(0));
        // Off the centroid, so that fragments differ in size.
        let offset = (east * c + north * s) * (0.35 * reach * draw(1));
        let junction = (centroid + offset).normalize();
        if fragments == 2 {
            let (s, c) = sin_cos(PI * draw(2));
            let tangent = any_tangent(junction);
            let center = tangent * c + junction.cross(tangent) * s;
            return Self::Line {
                center,
                radius: 0.5 * PI,
                origin: junction,
                all_round: false,
                warp,
            };
        }
        let width = TAU / f64::from(fragments);
        // Even sectors whose lines shift by up to 0.3 of one, turned together by up to half of
        // one.
        let azimuths = (0..fragments)
            .map(|k| width * (f64::from(k) + 0.3 * draw(3 + u64::from(k))) + 0.5 * width * draw(9))
            .collect();
        Self::Sectors {
            junction,
            azimuths,
            warp,
        }
    }

    /// A bite out of a plate at the direction `at` on its border, where `outward` is the border's
    /// normal.
    pub fn bite(stream: &Stream, counter: u64, at: DVec3, outward: DVec3, warp: Warp) -> Self {
        let draw = |k: u64| stream.unit(16 * counter + k);
        let radius = 0.5 + 0.7 * draw(10);
        // The farther its centre lies outside, the shorter is the arc within the plate.
        let (s, c) = sin_cos(radius * (0.2 + 0.5 * draw(11)));
        let (center, origin) = (at * c + outward * s, outward * c - at * s);
        let warp = Warp {
            amplitude: warp.amplitude.min(0.08 * radius),
            frequency: 2.0 / radius,
            ..warp
        };
        Self::Line {
            center,
            radius,
            origin: -origin,
            all_round: false,
            warp,
        }
    }

    /// Two halves of the sphere.
    pub fn halves(stream: &Stream, counter: u64, warp: Warp) -> Self {
        let center = stream.direction(16 * counter + 10);
        let warp = Warp {
            amplitude: warp.amplitude.min(0.1),
            frequency: 2.0,
            ..warp
        };
        Self::Line {
            center,
            radius: 0.5 * PI,
            origin: any_tangent(center),
            all_round: true,
            warp,
        }
    }

    /// Number of fragments.
    pub fn fragments(&self) -> usize {
        match self {
            Self::Line { .. } | Self::Path { .. } => 2,
            Self::Sectors { azimuths, .. } => azimuths.len(),
        }
    }

    /// The fragment that holds `p`, and the distance of `p` from the nearest line in radians.
    /// Beyond `near` radians the distance is not exact, but at least `near`.
    pub fn split(&self, p: DVec3, near: f64) -> (usize, f64) {
        match self {
            Self::Line {
                center,
                radius,
                origin,
                warp,
                ..
            } => {
                // Noise is dear, and beyond its reach it decides nothing.
                let reach = near + 2.0 * warp.amplitude;
                let latitude = 0.5 * PI - radius;
                let limit = |latitude: f64| sin(latitude.clamp(-0.5 * PI, 0.5 * PI));
                let height = p.dot(*center);
                if height > limit(latitude + reach) || height < limit(latitude - reach) {
                    return (usize::from(height < sin(latitude)), reach);
                }
                let along = atan2(p.dot(center.cross(*origin)), p.dot(*origin)) * sin(*radius);
                let side = asin(height) - latitude - warp.shift(along, 0);
                (usize::from(side < 0.0), side.abs())
            }
            Self::Path { points, warp } => {
                let (side, along) = beside(points, p);
                let side = side - warp.shift(along, 0);
                (usize::from(side < 0.0), side.abs())
            }
            Self::Sectors {
                junction,
                azimuths,
                warp,
            } => sector(*junction, azimuths, warp, p),
        }
    }

    /// Angular velocities in rad/My that the fragments gain, for a relative speed of `speed`
    /// rad/My. `plate` are directions all over the plate. `far_end` chooses at which end of a line
    /// the pole lies.
    ///
    /// `None` if the plate reaches so far that no motion opens all of it.
    pub fn motions(&self, plate: &[DVec3], speed: f64, far_end: bool) -> Option<Vec<DVec3>> {
        match self {
            Self::Line {
                origin,
                all_round: true,
                ..
            } => Some(open_half(*origin, speed, far_end)),
            Self::Line {
                center,
                radius,
                origin,
                warp,
                ..
            } => {
                let beside = beside_circle(plate, *center, *radius, warp.amplitude);
                open_line(*center, *origin, &beside, speed, far_end)
            }
            Self::Path { points, .. } => {
                let (first, last) = (points[0], points[points.len() - 1]);
                let normal = first.cross(last).try_normalize()?;
                open_line(
                    normal,
                    (first + last).try_normalize()?,
                    plate,
                    speed,
                    far_end,
                )
            }
            Self::Sectors {
                junction, azimuths, ..
            } => {
                // Beyond a quarter of the circle fragments would close in on each other again.
                let near = plate.iter().all(|p| p.dot(*junction) > 0.25);
                near.then(|| open_sectors(*junction, azimuths, speed))
            }
        }
    }
}

/// Signed distance of `p` from a polyline whose ends are extended, and the position along it, in
/// radians. The first fragment lies to its left.
fn beside(points: &[DVec3], p: DVec3) -> (f64, f64) {
    let mut best = (f64::INFINITY, 0.0, 0.0);
    let mut travelled = 0.0;
    let last = points.len() - 2;
    for k in 0..=last {
        let (a, b) = (points[k], points[k + 1]);
        let length = angle_between(a, b);
        let normal = a.cross(b).normalize_or_zero();
        let along = atan2(p.dot(normal.cross(a)), p.dot(a));
        // Only the outermost segments go on beyond their ends.
        let low = if k == 0 { -PI } else { 0.0 };
        let high = if k == last { PI } else { length };
        let on = along.clamp(low, high);
        let (s, c) = sin_cos(on);
        let foot = a * c + normal.cross(a) * s;
        let distance = angle_between(p, foot);
        if distance < best.0 {
            let side = if p.dot(normal) >= 0.0 {
                distance
            } else {
                -distance
            };
            best = (distance, side, travelled + on);
        }
        travelled += length;
    }
    (best.1, best.2)
}

/// The sector around the junction that holds `p`, and the distance from the nearest line.
fn sector(junction: DVec3, azimuths: &[f64], warp: &Warp, p: DVec3) -> (usize, f64) {
    let east = any_tangent(junction);
    let azimuth = atan2(p.dot(junction.cross(east)), p.dot(east));
    let r = angle_between(junction, p);
    let n = azimuths.len();
    let mut found = (n - 1, f64::INFINITY, f64::INFINITY);
    for (k, &line) in azimuths.iter().enumerate() {
        // The shift is an arc across the line; as an angle it must vanish at the junction and stay
        // within the sector.
        let bend = (warp.shift(r, k) / sin(r).max(0.2)).clamp(-0.35, 0.35) * (r / 0.1).min(1.0);
        let ahead = (azimuth - line - bend).rem_euclid(TAU);
        if ahead < found.1 {
            found = (k, ahead, found.2);
        }
        let across = (sin(ahead) * sin(r)).abs();
        if sin(ahead + 0.5 * PI) > 0.0 {
            found.2 = found.2.min(asin(across));
        }
    }
    (found.0, found.2)
}

#[cfg(test)]
#[path = "shape_tests.rs"]
mod tests;
