//! Measurements by brute force.

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::math::angle_between;
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::prelude::*;
use bevy_pangaea::sphere::SphereMesh;

/// Continental area in km² and volume in km³.
pub fn continents(crust: &Crust, mesh: &SphereMesh, radius: f64) -> (f64, f64) {
    let mut sum = (0.0, 0.0);
    for i in 0..crust.len() {
        if crust.kind[i] == CrustKind::Continental {
            let area = mesh.area(i as u32) * radius * radius;
            sum.0 += area;
            sum.1 += area * f64::from(crust.thickness[i]);
        }
    }
    sum
}

/// Share of the sphere where `belongs`.
pub fn share(mesh: &SphereMesh, belongs: impl Fn(usize) -> bool) -> f64 {
    let area: f64 = (0..mesh.len())
        .filter(|&i| belongs(i))
        .map(|i| mesh.area(i as u32))
        .sum();
    area / (4.0 * core::f64::consts::PI)
}

/// Share of the sphere per bin of `width` km of elevation, from `low` km on.
pub fn hypsometry(
    mesh: &SphereMesh,
    surface: &Surface,
    low: f64,
    width: f64,
    bins: usize,
) -> Vec<f64> {
    let mut shares = vec![0.0; bins];
    for i in 0..mesh.len() {
        let bin = ((f64::from(surface.elevation(i)) - low) / width).max(0.0) as usize;
        shares[bin.min(bins - 1)] += mesh.area(i as u32) / (4.0 * core::f64::consts::PI);
    }
    shares
}

/// The frames of a world that cover points, found without any table.
pub struct Coverage<'a> {
    /// Samples.
    pub mesh: &'a SphereMesh,
    /// Columns.
    pub crust: &'a Crust,
    /// Frames.
    pub frames: &'a Frames,
}

impl<'a> Coverage<'a> {
    /// The coverage of a planet as it is now.
    pub fn of(app: &'a App, planet: Entity) -> Self {
        let world = app.world();
        Self {
            mesh: world.get::<Lattice>(planet).expect("a lattice"),
            crust: world.get(planet).expect("crust"),
            frames: world.get(planet).expect("frames"),
        }
    }

    /// Plate and sample of every frame that covers `p`.
    pub fn at(&self, p: DVec3) -> Vec<(PlateId, u32)> {
        let mut found = Vec::new();
        for (id, frame) in self.frames.iter().enumerate() {
            let sample = self.mesh.nearest(frame.to_lattice(p).normalize());
            if usize::from(self.crust.frame[sample as usize]) == id {
                found.push((frame.plate, sample));
            }
        }
        found
    }

    /// Whether continental crust of the plate covers `p`.
    pub fn continent(&self, plate: PlateId, p: DVec3) -> bool {
        self.at(p)
            .iter()
            .any(|&(id, i)| id == plate && self.crust.is_continental(i as usize))
    }
}

/// Points on the great circle from `a` to `b`, `count` of them, both ends included.
pub fn great_circle(a: DVec3, b: DVec3, count: usize) -> Vec<DVec3> {
    let whole = angle_between(a, b);
    let tangent = (b - a * a.dot(b)).normalize();
    (0..count)
        .map(|k| {
            let (s, c) = bevy_pangaea::math::sin_cos(whole * k as f64 / (count - 1) as f64);
            a * c + tangent * s
        })
        .collect()
}
