//! The colours of a map's pixels: the overlay's own, and what is drawn over them.

use crate::crust::{CrustKind, Surface};
use crate::overlay::boundary::{BoundaryKind, boundaries};
use crate::overlay::derivatives::{gradients_of, shade};
use crate::overlay::field::{Barycentric, OverlayField, majority};
use crate::overlay::palette::{self, Rgba};
use crate::overlay::quantity::field_of;
use crate::overlay::{Overlay, OverlayInput};
use crate::sphere::SphereMesh;
use bevy::math::Vec3;

/// How much steeper than true the relief of land is drawn.
const LAND_EXAGGERATION: f32 = 20.0;
/// How much steeper than true the relief of the sea floor is drawn.
const SEA_EXAGGERATION: f32 = 9.0;

/// Least and greatest brightness of shaded relief.
const BRIGHTNESS: (f32, f32) = (0.45, 1.35);

/// Lead in weight of one plate over the others up to which a line between plates is drawn.
const BOUNDARY_LEAD: f32 = 0.5;

/// Edges of triangles.
const EDGE: Rgba = [40, 42, 48, 255];

/// Drawn over the colours of an overlay.
enum Decoration {
    None,
    /// Shading, from the uphill gradient at every sample: that of the land, with the sea as a
    /// plain, and that of the sea floor, with the land as a plain. So a coast is not shaded as a
    /// cliff.
    Relief {
        land: Vec<Vec3>,
        sea: Vec<Vec3>,
    },
    /// Lines between plates, by the kind of boundary per sample.
    Boundaries(Vec<BoundaryKind>),
    /// Edges of triangles: opacity, and width in barycentric weight.
    Edges {
        opacity: f32,
        width: f32,
    },
}

impl Decoration {
    /// The decoration of `overlay` on a map of `height` rows.
    fn new(overlay: Overlay, input: &OverlayInput, height: u32) -> Self {
        match overlay {
            Overlay::Elevation => Self::Relief {
                land: gradients_of(input, |z| z.max(0.0)),
                sea: gradients_of(input, |z| z.min(0.0)),
            },
            Overlay::Plates => Self::Boundaries(boundaries(input)),
            Overlay::Mesh => Self::edges(input.mesh.spacing(), height),
            _ => Self::None,
        }
    }

    /// Edges of triangles with sides of `spacing` radians. Where triangles are small, edges fade
    /// instead of covering all.
    fn edges(spacing: f64, height: u32) -> Self {
        let radians_per_pixel = crate::math::PI / f64::from(height);
        let triangle_height = 0.866 * spacing / radians_per_pixel;
        Self::Edges {
            opacity: (triangle_height / 12.0).min(0.6) as f32,
            width: (0.6 / triangle_height).min(0.3) as f32,
        }
    }
}

/// Colours of the places of a map.
pub(super) struct MapColors<'a> {
    field: OverlayField,
    decoration: Decoration,
    mesh: &'a SphereMesh,
    surface: &'a Surface,
    kinds: &'a [CrustKind],
}

impl<'a> MapColors<'a> {
    /// The colours of `overlay` on a map of `height` rows.
    pub(super) fn new(overlay: Overlay, input: &OverlayInput<'a>, height: u32) -> Self {
        Self {
            field: field_of(overlay, input),
            decoration: Decoration::new(overlay, input, height),
            mesh: input.mesh,
            surface: input.surface,
            kinds: &input.surface.crust.kind,
        }
    }

    /// The colour at a place.
    pub(super) fn at(&self, place: &Barycentric) -> Rgba {
        let color = self.field.at(place, self.kinds);
        match &self.decoration {
            Decoration::None => color,
            Decoration::Relief { land, sea } => self.shaded(color, place, land, sea),
            Decoration::Boundaries(kinds) => self.bordered(color, place, kinds),
            Decoration::Edges { opacity, width } => {
                let [a, b, c] = place.weights;
                if a.min(b).min(c) < *width {
                    palette::mix(color, EDGE, *opacity)
                } else {
                    color
                }
            }
        }
    }

    /// The colour in the light of the map's sun.
    fn shaded(&self, color: Rgba, place: &Barycentric, land: &[Vec3], sea: &[Vec3]) -> Rgba {
        let z: f32 = corners(place)
            .map(|(v, w)| w * self.surface.elevation(v))
            .sum();
        let (gradients, exaggeration) = if z >= 0.0 {
            (land, LAND_EXAGGERATION)
        } else {
            (sea, SEA_EXAGGERATION)
        };
        // The normal is taken where the pixel is, or triangles would show as facets.
        let p: Vec3 = corners(place)
            .map(|(v, w)| w * self.mesh.point(v as u32).as_vec3())
            .sum();
        let gradient: Vec3 = corners(place).map(|(v, w)| w * gradients[v]).sum();
        let light = shade(p.normalize_or(Vec3::Z), gradient * exaggeration);
        palette::scaled(color, light.clamp(BRIGHTNESS.0, BRIGHTNESS.1))
    }

    /// The colour of the boundary where two plates meet, else the overlay's.
    fn bordered(&self, color: Rgba, place: &Barycentric, kinds: &[BoundaryKind]) -> Rgba {
        // The boundary runs where no plate has most of the weight.
        let plates = place.of(&self.surface.plate);
        if plates[0] == plates[1] && plates[1] == plates[2] {
            return color;
        }
        let (_, lead) = majority(plates, place.weights);
        if lead > BOUNDARY_LEAD {
            return color;
        }
        match majority(place.of(kinds), place.weights).0 {
            BoundaryKind::None => color,
            kind => kind.color(),
        }
    }
}

/// The samples at the corners of a place, each with its weight.
fn corners(place: &Barycentric) -> impl Iterator<Item = (usize, f32)> {
    let vertices = place.vertices.into_iter().map(|v| v as usize);
    vertices.zip(place.weights)
}
