//! Old, worn mountain belts: where, how strong, how old.
//!
//! A belt follows a zero line of a noise. A second noise says where belts are at all, how old they
//! are and what folded them, so that neighbouring belts are of one orogeny.

use crate::crust::Orogeny;
use crate::math;
use crate::noise::Noise;
use bevy::math::DVec3;

/// Strength above which crust counts as folded: within 1.4 half-widths of the axis of a full belt.
pub(super) const FOLDED_STRENGTH: f64 = 0.15;

/// Half-width of a belt in km, at which its strength is 1/e; the Urals are 150 to 300 km wide.
const HALF_WIDTH_KM: f64 = 140.0;

/// Periods per rad of the noise whose zero lines the belts follow: a line every 1,600 km on Earth.
const LINE_FREQUENCY: f64 = 2.0;

/// Least slope of that noise in 1/rad: where it is flatter its zero line is far, whatever its
/// value.
const LEAST_SLOPE: f64 = 0.3;

/// Step in rad for the slope of that noise: far shorter than its wavelength.
const SLOPE_STEP: f64 = 1e-3;

/// Distance from the coast in km over which a belt gains its full strength: the ends at coasts are
/// more worn.
const COASTAL_KM: f64 = 250.0;

/// Mean age of the belts in My and the range to both sides: the ages of the Urals and the
/// Appalachians.
const AGE_MY: [f64; 2] = [300.0, 100.0];

/// A place in an old belt.
#[derive(Clone, Copy, Debug)]
pub(super) struct Belt {
    /// 1 on the axis of a belt, 0 outside.
    pub(super) strength: f64,
    /// Across the belt: the direction of compression, a unit tangent vector where there is a belt.
    pub(super) fold: DVec3,
    /// Time since it was folded in My.
    pub(super) age: f64,
    /// Folded by a collision (Himalayan) or above a subduction zone (Andean).
    pub(super) orogeny: Orogeny,
}

impl Belt {
    /// A place outside of all belts.
    const NONE: Self = Self {
        strength: 0.0,
        fold: DVec3::ZERO,
        age: 0.0,
        orogeny: Orogeny::None,
    };
}

/// The belts of one planet.
pub(super) struct Belts {
    /// Planet radius in km.
    radius: f64,
    half_width_km: f64,
    coastal_km: f64,
    line: Noise,
    extent: Noise,
}

impl Belts {
    /// Belts on a planet of `radius` km whose distances are `scale` times those of Earth. `line` is
    /// the noise whose zero lines they follow, `extent` says where and of what kind they are.
    pub(super) fn new(radius: f64, scale: f64, line: Noise, extent: Noise) -> Self {
        Self {
            radius,
            half_width_km: HALF_WIDTH_KM * scale,
            coastal_km: COASTAL_KM * scale,
            line,
            extent,
        }
    }

    /// The belt at `p`, `coast` rad from the coast.
    pub(super) fn at(&self, p: DVec3, coast: f64) -> Belt {
        // Broad regions without belts: about half of the planet.
        let present = math::smoothstep(2.5 * self.extent.fractal(p, 1.7, 2) + 0.1);
        if present == 0.0 {
            return Belt::NONE;
        }
        let east = math::any_tangent(p);
        let here = self.line_noise(p);
        let gradient = self.slope(p, here, east) + self.slope(p, here, p.cross(east));
        // Distance to the zero line to first order, in half-widths.
        let rad = here.abs() / gradient.length().max(LEAST_SLOPE);
        let distance = rad * self.radius / self.half_width_km;
        let inland = math::smoothstep(coast * self.radius / self.coastal_km);
        // Seen from the opposite point, or age and presence would be one pattern.
        let epoch = self.extent.fractal(-p, 0.8, 2);
        let [mean_age, range] = AGE_MY;
        Belt {
            strength: math::exp(-distance * distance) * present * (0.25 + 0.75 * inland),
            fold: gradient.normalize_or(east),
            age: mean_age + range * (2.0 * epoch).clamp(-1.0, 1.0),
            orogeny: if self.extent.fractal(p, 0.9, 1) > -0.1 {
                Orogeny::Himalayan
            } else {
                Orogeny::Andean
            },
        }
    }

    fn line_noise(&self, p: DVec3) -> f64 {
        self.line.fractal(p, LINE_FREQUENCY, 2)
    }

    /// Slope of the line noise along the unit tangent vector `along`, as a vector; `here` is the
    /// noise at `p`.
    fn slope(&self, p: DVec3, here: f64, along: DVec3) -> DVec3 {
        along * ((self.line_noise(p + along * SLOPE_STEP) - here) / SLOPE_STEP)
    }
}
