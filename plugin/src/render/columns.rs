//! What is uploaded per sample: three words of 32 bits (see the README of `pangaea_shaders`).

use super::to_bevy;
use crate::crust::Surface;
use crate::overlay::palette::Rgba;
use crate::plate::PlateId;
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec2, Vec3};

/// Bytes per sample.
pub(super) const STRIDE: usize = 12;

/// Steepest gradient that can be packed, in km per radian; the same as in `sample.wgsl`.
const MAX_GRADIENT: f32 = 8192.0;

/// Packs all samples of a surface.
///
/// `gradients` are in km per km in planet coordinates, `colors` in sRGB; missing ones are black.
pub(super) fn pack(
    mesh: &SphereMesh,
    surface: &Surface,
    gradients: &[Vec3],
    radius: f64,
    colors: &[Rgba],
    selected: Option<PlateId>,
) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(STRIDE * mesh.len());
    for (i, (&point, gradient)) in mesh.points().iter().zip(gradients).enumerate() {
        let [r, g, b, _] = colors.get(i).copied().unwrap_or_default();
        let marked = if selected.is_some_and(|plate| surface.plate[i] == plate) { 255 } else { 0 };
        bytes.extend_from_slice(&surface.elevation(i).to_le_bytes());
        bytes.extend_from_slice(&gradient_word(point, gradient.as_dvec3() * radius).to_le_bytes());
        bytes.extend_from_slice(&[r, g, b, marked]);
    }
    bytes
}

/// A gradient in km per radian as two snorm16 in the tangent basis of its sample.
fn gradient_word(point: DVec3, gradient: DVec3) -> u32 {
    let (u, v) = tangent_basis(to_bevy(point));
    let gradient = to_bevy(gradient);
    let snorm = |x: f32| (((x / MAX_GRADIENT).clamp(-1.0, 1.0) * 32767.0).round() as i16) as u16;
    let Vec2 { x, y } = Vec2::new(gradient.dot(u), gradient.dot(v));
    u32::from(snorm(x)) | u32::from(snorm(y)) << 16
}

/// Two unit vectors perpendicular to the unit vector `n` (Duff et al. 2017). The twin of the one in `sample.wgsl`.
fn tangent_basis(n: Vec3) -> (Vec3, Vec3) {
    let s = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let a = -1.0 / (s + n.z);
    let b = n.x * n.y * a;
    (Vec3::new(1.0 + s * n.x * n.x * a, s * b, -s * n.x), Vec3::new(b, s + n.y * n.y * a, -n.y))
}

#[cfg(test)]
mod tests {
    use super::*;
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
            let word = gradient_word(p, gradient);
            let part = |bits: u32| f32::from(bits as u16 as i16) / 32767.0 * MAX_GRADIENT;
            let unpacked = u * part(word) + v * part(word >> 16);
            assert!((unpacked - to_bevy(gradient)).length() < 0.5, "{unpacked} {gradient}");
        }
    }

    #[test]
    fn samples_take_twelve_bytes_in_order() {
        let mesh = SphereMesh::fibonacci(100).unwrap();
        let params = crate::params::TectonicParams::default();
        let surface = Surface {
            crust: crate::crust::Crust::ocean(100, &params),
            plate: (0..100).map(PlateId).collect(),
            trench: vec![-1.0; 100],
            ..Default::default()
        };
        let colors: Vec<_> = (0..100).map(|i| [i, 2, 3, 255]).collect();
        let bytes = pack(&mesh, &surface, &[Vec3::ZERO; 100], 6370.0, &colors, Some(PlateId(7)));
        assert_eq!(bytes.len(), 100 * STRIDE);
        let seventh = &bytes[7 * STRIDE..8 * STRIDE];
        assert_eq!(seventh[..4], surface.elevation(7).to_le_bytes());
        assert_eq!(seventh[4..], [0, 0, 0, 0, 7, 2, 3, 255]);
        assert_eq!(bytes[8 * STRIDE + 11], 0);
    }
}
