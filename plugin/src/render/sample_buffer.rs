//! The buffer of samples that the globe's shaders read: four words of 32 bits per sample (see the
//! README of `pangaea_shaders`).

use super::axes::to_bevy;
use super::relief::DrawnRelief;
use crate::overlay::palette::Rgba;
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec3};

/// Bytes per sample.
const STRIDE: usize = 16;

/// Largest elevation in km that can be packed; the same as in `sample.wgsl`.
const MAX_ELEVATION_KM: f32 = 32.0;
/// Steepest gradient in km per radian that can be packed; the same as in `sample.wgsl`.
const MAX_GRADIENT: f32 = 8192.0;

/// Packs all samples. `colors` are in sRGB; samples without one are black. `marked` samples stand
/// out.
pub(super) fn pack(
    mesh: &SphereMesh,
    relief: &DrawnRelief,
    colors: &[Rgba],
    marked: impl Fn(usize) -> bool,
) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(STRIDE * mesh.len());
    for (i, &point) in mesh.points().iter().enumerate() {
        let heights = [relief.land[i], relief.floor[i]].map(|z| snorm16(z / MAX_ELEVATION_KM));
        let gradient = gradient_words(point, relief.gradient[i]);
        let coast = [relief.coast[i], relief.rough[i]].map(snorm16);
        let [r, g, b, _] = colors.get(i).copied().unwrap_or_default();
        push_words(&mut bytes, heights);
        push_words(&mut bytes, gradient);
        bytes.extend([r, g, b, if marked(i) { 255 } else { 0 }]);
        push_words(&mut bytes, coast);
    }
    bytes
}

fn push_words(bytes: &mut Vec<u8>, words: [i16; 2]) {
    bytes.extend(words.into_iter().flat_map(i16::to_le_bytes));
}

/// A number of -1..=1 as a normalised integer.
fn snorm16(x: f32) -> i16 {
    (x.clamp(-1.0, 1.0) * 32767.0).round() as i16
}

/// A gradient in km per radian in the tangent basis of its sample.
fn gradient_words(point: DVec3, gradient: DVec3) -> [i16; 2] {
    let (u, v) = tangent_basis(to_bevy(point));
    let gradient = to_bevy(gradient) / MAX_GRADIENT;
    [u, v].map(|axis| snorm16(gradient.dot(axis)))
}

/// Two unit vectors perpendicular to the unit vector `n` (Duff et al. 2017). The twin of the one in
/// `sample.wgsl`.
fn tangent_basis(n: Vec3) -> (Vec3, Vec3) {
    // The sign keeps the denominator away from 0.
    let s = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let a = -1.0 / (s + n.z);
    let b = n.x * n.y * a;
    (
        Vec3::new(1.0 + s * n.x * n.x * a, s * b, -s * n.x),
        Vec3::new(b, s + n.y * n.y * a, -n.y),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::{Crust, Surface};
    use crate::params::TectonicParams;
    use crate::random::{Purpose, Stream};

    #[test]
    fn the_basis_is_orthonormal_and_gradients_survive_packing() {
        let random = Stream::new(4, Purpose::Relief, 0);
        for i in 0..2000 {
            let p = random.direction(2 * i);
            let (u, v) = tangent_basis(to_bevy(p));
            assert!(u.dot(v).abs() < 1e-5 && (u.cross(v) - to_bevy(p)).length() < 1e-5);
            let any = random.direction(2 * i + 1);
            let gradient = 3000.0 * (any - p * p.dot(any));
            let [a, b] =
                gradient_words(p, gradient).map(|word| f32::from(word) / 32767.0 * MAX_GRADIENT);
            assert!(
                (u * a + v * b - to_bevy(gradient)).length() < 0.5,
                "{a} {b} {gradient}"
            );
        }
    }

    /// A surface of `n` samples 4 km below the sea.
    fn deep_sea(n: usize) -> Surface {
        let mut crust = Crust::ocean(n, &TectonicParams::default());
        crust.elevation.fill(-4.0);
        Surface {
            crust,
            trench: vec![0.0; n],
            ..Default::default()
        }
    }

    #[test]
    fn samples_take_sixteen_bytes_in_order() {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let relief = DrawnRelief::new(&mesh, &deep_sea(mesh.len()), true);
        let colors: Vec<_> = (0..100).map(|i| [i, 2, 3, 255]).collect();
        let bytes = pack(&mesh, &relief, &colors, |i| i == 7);
        assert_eq!(bytes.len(), mesh.len() * STRIDE);
        let (samples, rest) = bytes.as_chunks::<STRIDE>();
        assert!(rest.is_empty());
        let floor = snorm16(-4.0 / MAX_ELEVATION_KM).to_le_bytes();
        assert_eq!(samples[7][2..4], floor);
        assert_eq!(samples[7][4..], [0, 0, 0, 0, 7, 2, 3, 255, 1, 128, 0, 0]);
        assert_eq!(samples[8][8..12], [8, 2, 3, 0]);
        assert_eq!(samples[200][8..12], [0; 4]);
    }
}
