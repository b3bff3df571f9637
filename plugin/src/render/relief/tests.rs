use super::*;
use crate::crust::Crust;
use crate::params::TectonicParams;

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

/// Land and sea that meet in a cliff.
fn cliff() -> (SphereMesh, Surface) {
    surface(|p| if p.x > 0.0 { 0.5 } else { -5.0 })
}

#[test]
fn a_cliff_is_a_coast_that_keeps_its_place_and_tilts_nothing() {
    let (mesh, surface) = cliff();
    let relief = DrawnRelief::new(&mesh, &surface, true);
    for (i, p) in mesh.points().iter().enumerate() {
        assert!((relief.coast[i] > 0.0) == (p.x > 0.0) || p.x.abs() < mesh.spacing());
        assert_eq!(
            relief.elevation(i),
            if relief.coast[i] > 0.0 { 0.5 } else { -5.0 }
        );
        // One sample beyond the coast each side goes on as it was.
        if p.x.abs() < 0.5 * mesh.spacing() {
            assert_eq!((relief.land[i], relief.floor[i]), (0.5, -5.0));
            assert_eq!(relief.rough[i], 1.0);
        }
    }
}

#[test]
fn land_keeps_its_area() {
    let (mesh, surface) = cliff();
    let relief = DrawnRelief::new(&mesh, &surface, true);
    let raw = (0..mesh.len()).filter(|&i| surface.elevation(i) > 0.0);
    let drawn = relief.coast.iter().filter(|&&side| side > 0.0);
    let growth = drawn.count() as f64 / raw.count() as f64 - 1.0;
    assert!(growth.abs() < 0.01, "{growth}");
}

#[test]
fn without_a_sea_there_is_one_surface() {
    let (mesh, surface) = cliff();
    let relief = DrawnRelief::new(&mesh, &surface, false);
    assert_eq!(relief.land, relief.floor);
    let steepest = relief
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
    let relief = DrawnRelief::new(&mesh, &surface, true);
    for (&p, &gradient) in mesh.points().iter().zip(&relief.gradient) {
        let expected = 3.0 * (along - p * along.dot(p));
        assert!(
            (gradient - expected).length() < 0.3,
            "{gradient} {expected}"
        );
    }
}
