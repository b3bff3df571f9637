use super::*;
use crate::crust::Crust;
use crate::params::TectonicParams;
use crate::random::{Purpose, Stream};

fn surface(elevation: impl Fn(DVec3) -> f32) -> (SphereMesh, Surface) {
    let mesh = SphereMesh::fibonacci(2000).unwrap();
    let mut crust = Crust::ocean(mesh.len(), &TectonicParams::default());
    crust.elevation = mesh.points().iter().map(|&p| elevation(p)).collect();
    let surface = Surface {
        crust,
        trench: vec![0.0; mesh.len()],
        ..Default::default()
    };
    (mesh, surface)
}

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

#[test]
fn samples_take_sixteen_bytes_in_order() {
    let (mesh, surface) = surface(|_| -4.0);
    let shape = Shape::new(&mesh, &surface, true);
    let colors: Vec<_> = (0..100).map(|i| [i, 2, 3, 255]).collect();
    let bytes = pack(&mesh, &shape, &colors, |i| i == 7);
    assert_eq!(bytes.len(), mesh.len() * STRIDE);
    let (samples, rest) = bytes.as_chunks::<STRIDE>();
    assert!(rest.is_empty());
    let floor = snorm16(-4.0 / MAX_ELEVATION).to_le_bytes();
    assert_eq!(samples[7][2..4], floor);
    assert_eq!(samples[7][4..], [0, 0, 0, 0, 7, 2, 3, 255, 1, 128, 0, 0]);
    assert_eq!(samples[8][8..12], [8, 2, 3, 0]);
    assert_eq!(samples[200][8..12], [0; 4]);
}

#[test]
fn a_cliff_is_a_coast_that_keeps_its_place_and_tilts_nothing() {
    let (mesh, surface) = surface(|p| if p.x > 0.0 { 0.5 } else { -5.0 });
    let shape = Shape::new(&mesh, &surface, true);
    for (i, p) in mesh.points().iter().enumerate() {
        assert!((shape.coast[i] > 0.0) == (p.x > 0.0) || p.x.abs() < mesh.spacing());
        assert_eq!(
            shape.elevation(i),
            if shape.coast[i] > 0.0 { 0.5 } else { -5.0 }
        );
        // One sample beyond the coast each side goes on as it was.
        if p.x.abs() < 0.5 * mesh.spacing() {
            assert_eq!((shape.land[i], shape.floor[i]), (0.5, -5.0));
            assert_eq!(shape.rough[i], 1.0);
        }
    }
    let area = |on: &dyn Fn(usize) -> bool| (0..mesh.len()).filter(|&i| on(i)).count() as f64;
    let (raw, drawn) = (
        area(&|i| surface.elevation(i) > 0.0),
        area(&|i| shape.coast[i] > 0.0),
    );
    assert!((drawn / raw - 1.0).abs() < 0.01, "{raw} {drawn}");
}

#[test]
fn without_a_sea_there_is_one_surface() {
    let (mesh, surface) = surface(|p| if p.x > 0.0 { 0.5 } else { -5.0 });
    let shape = Shape::new(&mesh, &surface, false);
    assert_eq!(shape.land, shape.floor);
    let steepest = shape
        .gradient
        .iter()
        .map(|g| g.length())
        .fold(0.0, f64::max);
    assert!(
        steepest > 1.5 / mesh.spacing(),
        "the cliff is seen: {steepest}"
    );
}

#[test]
fn a_smooth_slope_keeps_its_gradient() {
    let along = DVec3::new(0.4, 0.1, -0.7);
    let (mesh, surface) = surface(|p| 20.0 + 3.0 * p.dot(along) as f32);
    let shape = Shape::new(&mesh, &surface, true);
    for (&p, &gradient) in mesh.points().iter().zip(&shape.gradient) {
        let expected = 3.0 * (along - p * along.dot(p));
        assert!(
            (gradient - expected).length() < 0.3,
            "{gradient} {expected}"
        );
    }
}
