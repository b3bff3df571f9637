//! Which quantity an overlay shows, on which ramp or in which colours.

use super::derivatives::{laplacians, slopes};
use super::field::OverlayField;
use super::palette::{self, Ramp, Rgba, classes};
use super::{Overlay, OverlayInput, baked};
use crate::crust::{CrustKind, Orogeny};
use crate::math;
use crate::noise::Noise;
use crate::parallel;
use crate::random::{Purpose, mix};
use bevy::math::{DVec3, Vec3};

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

/// Brightness of a plate's continents relative to its ocean floor.
const CONTINENT_SHADE: f32 = 0.72;

/// Frequency of the noise that warps borders, as it is for 40 plates: 0.9 periods per distance of
/// two centroids.
const BORDER_NOISE_FREQUENCY: f64 = 1.6;
/// Octaves of the noise that warps borders.
const BORDER_NOISE_OCTAVES: u32 = 5;

/// The field that `overlay` shows.
pub(super) fn field_of(overlay: Overlay, input: &OverlayInput) -> OverlayField {
    let crust = &input.surface.crust;
    match overlay {
        Overlay::Elevation => elevation(input),
        Overlay::Plates => plates(input),
        Overlay::CrustType => crust_types(input),
        Overlay::OceanAge => ocean_age(input),
        Overlay::Thickness => scalar(input, palette::AMOUNT, THICKNESS_MAX, |i| {
            crust.thickness[i]
        }),
        Overlay::OrogenyType => orogenies(input),
        Overlay::OrogenyAge => orogeny_age(input),
        Overlay::FoldDirection => axes(input, &crust.fold),
        Overlay::RidgeDirection => axes(input, &crust.ridge),
        Overlay::Velocity => velocity(input),
        Overlay::Slope => on_ramp(slopes(input), palette::STEEPNESS, SLOPE_MAX),
        Overlay::Laplacian => on_ramp(laplacians(input), palette::DIVERGING, LAPLACIAN_MAX),
        Overlay::VectorNoise => border_noise(input),
        Overlay::Mesh => samples(input),
        Overlay::Temperature
        | Overlay::Rain
        | Overlay::Wetness
        | Overlay::Drainage
        | Overlay::Rivers
        | Overlay::Basins
        | Overlay::Lakes => baked_colors(overlay, input),
    }
}

/// Values on a ramp from 0 to `high`.
fn on_ramp(values: Vec<f32>, ramp: Ramp, high: f32) -> OverlayField {
    OverlayField::Scalar {
        values,
        ramp,
        low: 0.0,
        high,
    }
}

/// A value per sample on a ramp from 0 to `high`.
fn scalar(
    input: &OverlayInput,
    ramp: Ramp,
    high: f32,
    value: impl Fn(usize) -> f32 + Sync + Send,
) -> OverlayField {
    let values = parallel::map(input.mesh.len(), |i| value(i as usize));
    on_ramp(values, ramp, high)
}

/// A class per sample, by its colour.
fn class(input: &OverlayInput, color: impl Fn(usize) -> Rgba + Sync + Send) -> OverlayField {
    OverlayField::Classes(parallel::map(input.mesh.len(), |i| color(i as usize)))
}

/// Elevation in km; so are the positions of its ramp.
fn elevation(input: &OverlayInput) -> OverlayField {
    scalar(input, palette::HYPSOMETRIC, 1.0, |i| {
        input.surface.elevation(i)
    })
}

fn plates(input: &OverlayInput) -> OverlayField {
    let surface = input.surface;
    class(input, |i| {
        plate_color(surface.plate[i].0, surface.crust.kind[i])
    })
}

/// A plate's colour; its continents are darker.
pub(super) fn plate_color(id: u32, kind: CrustKind) -> Rgba {
    let color = palette::distinct(id);
    match kind {
        CrustKind::Continental => palette::scaled(color, CONTINENT_SHADE),
        CrustKind::Oceanic => color,
    }
}

fn crust_types(input: &OverlayInput) -> OverlayField {
    let surface = input.surface;
    class(input, |i| match surface.crust.kind[i] {
        CrustKind::Oceanic => classes::OCEANIC_CRUST,
        CrustKind::Continental if surface.elevation(i) >= 0.0 => classes::CONTINENT,
        CrustKind::Continental => classes::SHELF,
    })
}

/// Age of the ocean floor in My; none on continents.
fn ocean_age(input: &OverlayInput) -> OverlayField {
    let crust = &input.surface.crust;
    scalar(input, palette::AGE, OCEAN_AGE_MAX, |i| {
        if crust.is_continental(i) {
            f32::NAN
        } else {
            crust.ocean_age[i]
        }
    })
}

fn orogenies(input: &OverlayInput) -> OverlayField {
    let crust = &input.surface.crust;
    class(input, |i| match (crust.orogeny[i], crust.kind[i]) {
        (Orogeny::Andean, _) => classes::ANDEAN,
        (Orogeny::Himalayan, _) => classes::HIMALAYAN,
        (Orogeny::None, CrustKind::Continental) => classes::NO_VALUE_LAND,
        (Orogeny::None, CrustKind::Oceanic) => classes::NO_VALUE_OCEAN,
    })
}

fn orogeny_age(input: &OverlayInput) -> OverlayField {
    let crust = &input.surface.crust;
    scalar(
        input,
        palette::AGE,
        orogeny_age_max(input),
        |i| match crust.orogeny[i] {
            Orogeny::None => f32::NAN,
            Orogeny::Andean | Orogeny::Himalayan => crust.orogeny_age[i],
        },
    )
}

/// The axes of tangent vectors.
fn axes(input: &OverlayInput, vectors: &[Vec3]) -> OverlayField {
    OverlayField::Axis(parallel::map(input.mesh.len(), |i| {
        doubled_azimuth(input.mesh.point(i), vectors[i as usize].as_dvec3())
    }))
}

/// Cosine and sine of twice the azimuth of the vector `v` at `p`; zero if `v` is.
fn doubled_azimuth(p: DVec3, v: DVec3) -> [f32; 2] {
    if v.length_squared() < 1e-12 {
        return [0.0; 2];
    }
    // Doubled, an axis and its opposite are the same, and their mean is theirs.
    let (sin, cos) = math::sin_cos(2.0 * math::azimuth(p, v).to_radians());
    [cos as f32, sin as f32]
}

/// Speed of the ground in km per My.
fn velocity(input: &OverlayInput) -> OverlayField {
    let fastest = input.params.max_speed as f32;
    scalar(input, palette::AMOUNT, fastest, |i| {
        let omega = input.plates.angular_velocity(input.surface.plate[i]);
        (omega.cross(input.mesh.point(i as u32)).length() * input.planet.radius) as f32
    })
}

/// The noise that warps the borders of plates, a channel per coordinate.
fn border_noise(input: &OverlayInput) -> OverlayField {
    let noise = Noise::new(input.planet.seed, Purpose::BorderWarp, 0);
    OverlayField::Colors(parallel::map(input.mesh.len(), |i| {
        noise_color(&noise, input.mesh.point(i))
    }))
}

fn noise_color(noise: &Noise, p: DVec3) -> Rgba {
    let v = noise.vector(p, BORDER_NOISE_FREQUENCY, BORDER_NOISE_OCTAVES);
    // Grey is no warp; 190 spreads the range in which the noise mostly lies over all of a channel.
    let channel = |x: f64| (127.5 + 190.0 * x).clamp(0.0, 255.0) as u8;
    [channel(v.x), channel(v.y), channel(v.z), 255]
}

/// Pale heights in four shades by chance, so that samples are told from their neighbours.
fn samples(input: &OverlayInput) -> OverlayField {
    class(input, |i| {
        let height = palette::HYPSOMETRIC.at(input.surface.elevation(i));
        let pale = palette::mix(height, classes::GREY, 0.45);
        palette::scaled(pale, [0.86, 0.95, 1.04, 1.12][(mix(i as u64) & 3) as usize])
    })
}

/// The colours of a bake; grey without one.
fn baked_colors(overlay: Overlay, input: &OverlayInput) -> OverlayField {
    match input.bake {
        Some(bake) => OverlayField::Colors(baked::colors(overlay, bake, input.mesh)),
        None => class(input, |_| classes::NO_VALUE_LAND),
    }
}
