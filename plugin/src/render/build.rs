//! The build of a globe from a planet: samples to upload, lines, meshes, the picking tree. Pure
//! work, made on another thread.

use super::globe::{Globe, GlobeDrawn};
use super::mesh::{GlobePatch, ground_patches};
use super::picking::GlobePicker;
use super::relief::DrawnRelief;
use super::{lines, sample_buffer};
use crate::control::{Bake, PlanetBake};
use crate::crust::Surface;
use crate::math;
use crate::overlay::{Overlay, OverlayInput, colorize};
use crate::params::TectonicParams;
use crate::planet::Planet;
use crate::plate::{PlateId, PlateTable};
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use std::sync::Arc;

/// Everything about a surface and a [`Globe`] that a build depends on: equal keys give equal
/// builds. The sun, the air and the edges of triangles reach the shaders without a build.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BuildKey {
    version: u64,
    overlay: Overlay,
    relief: f32,
    sea: bool,
    boundaries: bool,
    selected: Option<PlateId>,
    /// Version of the bake, if the overlay shows one.
    bake: Option<u64>,
}

impl BuildKey {
    /// The key of a globe of `radius` km.
    pub(super) fn new(
        surface: &Surface,
        globe: &Globe,
        radius: f64,
        bake: Option<&PlanetBake>,
    ) -> Self {
        let shown = bake.filter(|_| globe.overlay.needs_bake());
        Self {
            version: surface.version,
            overlay: globe.overlay,
            relief: globe.relief(radius),
            sea: globe.sea,
            boundaries: globe.boundaries,
            selected: globe.selected,
            bake: shown.map(|bake| bake.version),
        }
    }
}

/// Everything that a globe is built from.
pub(super) struct BuildInput {
    pub(super) planet: Planet,
    pub(super) mesh: Arc<SphereMesh>,
    pub(super) surface: Arc<Surface>,
    pub(super) plates: PlateTable,
    pub(super) params: TectonicParams,
    pub(super) globe: Globe,
    pub(super) bake: Option<Arc<Bake>>,
    pub(super) key: BuildKey,
    /// Whether the lattice is new, so that its meshes are needed.
    pub(super) new_lattice: bool,
}

/// A built globe.
pub(super) struct BuiltGlobe {
    /// The surface and overlay that it shows.
    pub(super) drawn: GlobeDrawn,
    /// The packed samples.
    pub(super) samples: Vec<u8>,
    pub(super) lines: Mesh,
    pub(super) has_lines: bool,
    /// The meshes of the ground, if the lattice is new.
    pub(super) patches: Option<Vec<GlobePatch>>,
    /// Least and largest distance of the ground from the centre, in planet radii.
    pub(super) radii: (f64, f64),
    pub(super) picker: GlobePicker,
}

impl BuildInput {
    /// Builds the globe.
    pub(super) fn build(self) -> BuiltGlobe {
        let relief = DrawnRelief::new(&self.mesh, &self.surface, self.globe.sea);
        let input = self.overlay_input();
        let lines = lines::collect(&input, &self.globe, |i| relief.elevation(i));
        let radii = self.drawn_radii(&relief);
        BuiltGlobe {
            drawn: GlobeDrawn {
                version: self.key.version,
                overlay: self.key.overlay,
            },
            samples: self.packed_samples(&relief),
            has_lines: lines.len() > 0,
            lines: lines.into_mesh(),
            patches: self.new_lattice.then(|| ground_patches(&self.mesh)),
            radii: range_of(&radii, self.mesh.spacing()),
            picker: GlobePicker::new(self.mesh.clone(), radii),
        }
    }

    fn overlay_input(&self) -> OverlayInput<'_> {
        OverlayInput {
            planet: &self.planet,
            mesh: &self.mesh,
            surface: &self.surface,
            plates: &self.plates,
            params: &self.params,
            bake: self.bake.as_deref(),
        }
    }

    fn packed_samples(&self, relief: &DrawnRelief) -> Vec<u8> {
        // The elevation is tinted by the shader, which knows it between the samples too.
        let colors = match self.globe.overlay {
            Overlay::Elevation => Vec::new(),
            overlay => colorize(overlay, &self.overlay_input()),
        };
        let selected = |i: usize| Some(self.surface.plate[i]) == self.globe.selected;
        sample_buffer::pack(&self.mesh, relief, &colors, selected)
    }

    /// Distances of the samples from the centre, so that rays meet the relief as it is drawn.
    fn drawn_radii(&self, relief: &DrawnRelief) -> Vec<f32> {
        (0..self.mesh.len())
            .map(|i| {
                self.globe
                    .drawn_radius(relief.elevation(i), self.key.relief)
            })
            .collect()
    }
}

/// Least and largest distance of ground from the centre, on samples that are `spacing` apart.
fn range_of(radii: &[f32], spacing: f64) -> (f64, f64) {
    let (low, high) = radii.iter().fold((1.0, 1.0), |(low, high), &r| {
        (f64::min(low, r.into()), f64::max(high, r.into()))
    });
    // Triangles are flat: between their corners the ground is lower.
    (low * math::cos(spacing), high)
}
