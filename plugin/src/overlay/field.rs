//! The quantity that an overlay shows, per sample, and how it becomes a colour.
//!
//! Quantities, not colours, are interpolated between samples: a coast stays a line, and a missing
//! value is left out instead of being mixed in. Classes take the side with most weight.

use super::derivatives::{laplacians, slopes};
use super::palette::{self, Ramp, Rgba};
use super::{Overlay, OverlayInput, ground};
use crate::crust::{CrustKind, Orogeny};
use crate::math;
use crate::noise::Noise;
use crate::parallel;
use crate::random::{Purpose, mix};
use bevy::math::Vec3;

/// What an overlay shows at each sample.
pub(super) enum Field {
    /// Numbers on a ramp between two values; not a number where there is none.
    Scalar {
        values: Vec<f32>,
        ramp: Ramp,
        low: f32,
        high: f32,
    },
    /// Axes: the doubled azimuth as a vector; zero where there is none.
    Axis(Vec<[f32; 2]>),
    /// Classes that do not mix.
    Classes(Vec<Rgba>),
    /// Colours that mix.
    Colors(Vec<Rgba>),
}

/// Ground without a value on oceanic crust.
pub(super) const NO_VALUE_OCEAN: Rgba = [52, 60, 72, 255];
/// Ground without a value on continental crust.
pub(super) const NO_VALUE_LAND: Rgba = [176, 174, 166, 255];

/// Colours of the crust types: ocean, continent above and below the sea.
pub(super) const CRUST: [Rgba; 3] = [
    [30, 66, 116, 255],
    [190, 164, 112, 255],
    [122, 158, 164, 255],
];
/// Colours of Andean and Himalayan folding.
pub(super) const OROGENY: [Rgba; 2] = [[226, 110, 60, 255], [132, 74, 168, 255]];

/// Oldest ocean floor on the ramp, in My; the oldest on Earth.
pub(super) const OCEAN_AGE_MAX: f32 = 180.0;
/// Thickest crust on the ramp, in km; Tibet's.
pub(super) const THICKNESS_MAX: f32 = 75.0;
/// Steepest slope on the ramp, in m per km.
pub(super) const SLOPE_MAX: f32 = 40.0;
/// Largest Laplacian on the ramp, in m per km².
pub(super) const LAPLACIAN_MAX: f32 = 0.6;

/// Oldest folding on the ramp, in My: the age of the planet in whole 50 My, 100 to 1000.
pub(super) fn orogeny_age_max(input: &OverlayInput) -> f32 {
    ((input.surface.time / 50.0).ceil() * 50.0).clamp(100.0, 1000.0) as f32
}

/// Frequency and octaves of the noise that warps borders, as they are for 40 plates: 0.9 periods
/// per distance of two centroids.
const NOISE: (f64, u32) = (1.6, 5);

impl Field {
    /// The field that `overlay` shows.
    pub(super) fn new(overlay: Overlay, input: &OverlayInput) -> Self {
        let OverlayInput {
            planet,
            mesh,
            surface,
            plates,
            params,
            bake,
        } = *input;
        let crust = &surface.crust;
        let scalar = |ramp, low, high, value: &(dyn Fn(usize) -> f32 + Sync)| Self::Scalar {
            values: parallel::map(mesh.len(), |i| value(i as usize)),
            ramp,
            low,
            high,
        };
        let classes = |color: &(dyn Fn(usize) -> Rgba + Sync)| {
            Self::Classes(parallel::map(mesh.len(), |i| color(i as usize)))
        };
        match overlay {
            baked if ground::is_baked(baked) => match bake {
                Some(bake) => Self::Colors(ground::colors(baked, bake, mesh)),
                None => classes(&|_| NO_VALUE_LAND),
            },
            Overlay::Elevation => scalar(palette::HYPSOMETRIC, 0.0, 1.0, &|i| surface.elevation(i)),
            Overlay::Plates => classes(&|i| plate_color(surface.plate[i].0, crust.kind[i])),
            Overlay::CrustType => classes(&|i| crust_color(crust.kind[i], surface.elevation(i))),
            Overlay::OceanAge => scalar(palette::AGE, 0.0, OCEAN_AGE_MAX, &|i| {
                if crust.is_continental(i) {
                    f32::NAN
                } else {
                    crust.ocean_age[i]
                }
            }),
            Overlay::Thickness => {
                scalar(palette::AMOUNT, 0.0, THICKNESS_MAX, &|i| crust.thickness[i])
            }
            Overlay::OrogenyType => classes(&|i| orogeny_color(crust.orogeny[i], crust.kind[i])),
            Overlay::OrogenyAge => scalar(palette::AGE, 0.0, orogeny_age_max(input), &|i| {
                if crust.orogeny[i] == Orogeny::None {
                    f32::NAN
                } else {
                    crust.orogeny_age[i]
                }
            }),
            Overlay::FoldDirection => axes_of(input, &crust.fold),
            Overlay::RidgeDirection => axes_of(input, &crust.ridge),
            Overlay::Velocity => scalar(palette::AMOUNT, 0.0, params.max_speed as f32, &|i| {
                let omega = plates.angular_velocity(surface.plate[i]);
                (omega.cross(mesh.point(i as u32)).length() * planet.radius) as f32
            }),
            Overlay::Slope => Self::Scalar {
                values: slopes(input),
                ramp: palette::STEEPNESS,
                low: 0.0,
                high: SLOPE_MAX,
            },
            Overlay::Laplacian => {
                let values = laplacians(input);
                Self::Scalar {
                    values,
                    ramp: palette::DIVERGING,
                    low: 0.0,
                    high: LAPLACIAN_MAX,
                }
            }
            Overlay::VectorNoise => {
                let noise = Noise::new(planet.seed, Purpose::BorderWarp, 0);
                Self::Colors(parallel::map(mesh.len(), |i| {
                    noise_color(&noise, mesh.point(i))
                }))
            }
            _ => classes(&|i| {
                let tint = palette::mix(
                    palette::HYPSOMETRIC.at(surface.elevation(i)),
                    [150, 150, 150, 255],
                    0.45,
                );
                palette::scaled(tint, [0.86, 0.95, 1.04, 1.12][(mix(i as u64) & 3) as usize])
            }),
        }
    }

    /// The colour at sample `i`.
    pub(super) fn at(&self, i: u32, kinds: &[CrustKind]) -> Rgba {
        self.between([i; 3], [1.0, 0.0, 0.0], kinds)
    }

    /// The colour between three samples.
    pub(super) fn between(
        &self,
        vertices: [u32; 3],
        weights: [f32; 3],
        kinds: &[CrustKind],
    ) -> Rgba {
        let corner = vertices.map(|v| v as usize);
        match self {
            Self::Scalar {
                values,
                ramp,
                low,
                high,
            } => match mean(corner.map(|i| values[i]), weights) {
                Some(value) => ramp.within(value, *low, *high),
                None => no_value(corner.map(|i| kinds[i]), weights),
            },
            Self::Axis(axes) => {
                let part = |k: usize| (0..3).map(|c| weights[c] * axes[corner[c]][k]).sum::<f32>();
                let known: f32 = (0..3)
                    .filter(|&c| axes[corner[c]] != [0.0; 2])
                    .map(|c| weights[c])
                    .sum();
                if known < 0.5 {
                    return no_value(corner.map(|i| kinds[i]), weights);
                }
                palette::axis_hue(0.5 * math::atan2(part(1).into(), part(0).into()).to_degrees())
            }
            Self::Classes(colors) => majority(corner.map(|i| colors[i]), weights).0,
            Self::Colors(colors) => {
                let channel = |k: usize| {
                    (0..3)
                        .map(|c| weights[c] * f32::from(colors[corner[c]][k]))
                        .sum::<f32>()
                };
                [0, 1, 2, 3].map(|k| (channel(k) + 0.5) as u8)
            }
        }
    }
}

/// Mean of the numbers among `values`, if they have at least half of the weight.
fn mean(values: [f32; 3], weights: [f32; 3]) -> Option<f32> {
    let (mut sum, mut known) = (0.0, 0.0);
    for (value, weight) in values.into_iter().zip(weights) {
        if !value.is_nan() {
            sum += weight * value;
            known += weight;
        }
    }
    (known >= 0.5).then(|| sum / known)
}

/// The class with most weight, and by how much it leads. At a tie the first corner wins.
pub(super) fn majority<T: Copy + PartialEq>(classes: [T; 3], weights: [f32; 3]) -> (T, f32) {
    let total = |class: T| {
        (0..3)
            .filter(|&c| classes[c] == class)
            .map(|c| weights[c])
            .sum::<f32>()
    };
    let mut best = (classes[0], total(classes[0]));
    let mut second = 0.0;
    for class in [classes[1], classes[2]] {
        if class == best.0 {
            continue;
        }
        let weight = total(class);
        if weight > best.1 {
            second = best.1;
            best = (class, weight);
        } else {
            second = weight.max(second);
        }
    }
    (best.0, best.1 - second)
}

fn no_value(kinds: [CrustKind; 3], weights: [f32; 3]) -> Rgba {
    match majority(kinds, weights).0 {
        CrustKind::Oceanic => NO_VALUE_OCEAN,
        CrustKind::Continental => NO_VALUE_LAND,
    }
}

/// A plate's colour; its continents are darker.
pub(super) fn plate_color(id: u32, kind: CrustKind) -> Rgba {
    let color = palette::distinct(id);
    if kind == CrustKind::Continental {
        palette::scaled(color, 0.72)
    } else {
        color
    }
}

fn crust_color(kind: CrustKind, elevation: f32) -> Rgba {
    match kind {
        CrustKind::Oceanic => CRUST[0],
        CrustKind::Continental if elevation >= 0.0 => CRUST[1],
        CrustKind::Continental => CRUST[2],
    }
}

fn orogeny_color(orogeny: Orogeny, kind: CrustKind) -> Rgba {
    match orogeny {
        Orogeny::Andean => OROGENY[0],
        Orogeny::Himalayan => OROGENY[1],
        Orogeny::None if kind == CrustKind::Continental => NO_VALUE_LAND,
        Orogeny::None => NO_VALUE_OCEAN,
    }
}

fn axes_of(input: &OverlayInput, vectors: &[Vec3]) -> Field {
    Field::Axis(parallel::map(input.mesh.len(), |i| {
        let v = vectors[i as usize].as_dvec3();
        if v.length_squared() < 1e-12 {
            return [0.0; 2];
        }
        let (sin, cos) = math::sin_cos(2.0 * math::azimuth(input.mesh.point(i), v).to_radians());
        [cos as f32, sin as f32]
    }))
}

fn noise_color(noise: &Noise, p: bevy::math::DVec3) -> Rgba {
    let v = noise.vector(p, NOISE.0, NOISE.1);
    let channel = |x: f64| (127.5 + 190.0 * x).clamp(0.0, 255.0) as u8;
    [channel(v.x), channel(v.y), channel(v.z), 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_values_are_left_out() {
        assert_eq!(
            mean([2.0, f32::NAN, 4.0], [0.5, 0.25, 0.25]),
            Some(8.0 / 3.0)
        );
        assert_eq!(mean([f32::NAN, f32::NAN, 4.0], [0.4, 0.3, 0.3]), None);
    }

    #[test]
    fn most_weight_wins() {
        assert_eq!(majority(['a', 'b', 'b'], [0.4, 0.3, 0.3]).0, 'b');
        assert_eq!(majority(['a', 'b', 'c'], [0.4, 0.3, 0.3]).0, 'a');
        let (class, lead) = majority(['a', 'b', 'c'], [0.2, 0.5, 0.3]);
        assert!(class == 'b' && (lead - 0.2).abs() < 1e-6);
    }
}
