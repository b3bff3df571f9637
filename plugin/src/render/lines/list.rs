//! A list of lines as a mesh.

use crate::overlay::palette::Rgba;
use crate::render::axes::to_bevy;
use bevy::asset::RenderAssetUsages;
use bevy::math::DVec3;
use bevy::mesh::{
    Indices, MeshVertexAttribute, PrimitiveTopology, VertexAttributeValues, VertexFormat,
};
use bevy::prelude::*;

/// Attribute: the other end of a line, a direction.
pub(in crate::render) const OTHER: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaOtherEnd",
    0x70a9_6ae5_0000_0002,
    VertexFormat::Float32x3,
);
/// Attribute: elevations of both ends in km.
pub(in crate::render) const HEIGHTS: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaHeights",
    0x70a9_6ae5_0000_0003,
    VertexFormat::Float32x2,
);
/// Attribute: side of the line, and half its width in pixels.
pub(in crate::render) const SIDE: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaSide",
    0x70a9_6ae5_0000_0004,
    VertexFormat::Float32x2,
);
/// Attribute: colour in sRGB.
pub(in crate::render) const COLOR: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaLineColor",
    0x70a9_6ae5_0000_0005,
    VertexFormat::Unorm8x4,
);

/// An end of a line.
#[derive(Clone, Copy)]
pub(super) struct LineEnd {
    /// Unit direction in planet coordinates.
    pub(super) direction: DVec3,
    /// Elevation in km at which the ground is drawn there.
    pub(super) elevation: f32,
}

/// How a line looks.
#[derive(Clone, Copy)]
pub(super) struct LineStyle {
    /// Half the width in pixels of a picture of 720 rows.
    pub(super) half_width: f32,
    /// Colour in sRGB.
    pub(super) color: Rgba,
}

/// Lines being collected: four vertices each, two at either end.
#[derive(Default)]
pub(in crate::render) struct Lines {
    pub(super) here: Vec<[f32; 3]>,
    pub(super) there: Vec<[f32; 3]>,
    heights: Vec<[f32; 2]>,
    pub(super) sides: Vec<[f32; 2]>,
    pub(super) colors: Vec<Rgba>,
}

impl Lines {
    /// Adds a line from `a` to `b`.
    pub(super) fn add(&mut self, a: LineEnd, b: LineEnd, style: LineStyle) {
        // Each end sees the other, so that the shader can turn the line's width towards the camera.
        for (here, there) in [(a, b), (b, a)] {
            for side in [-1.0, 1.0] {
                self.here.push(to_bevy(here.direction).to_array());
                self.there.push(to_bevy(there.direction).to_array());
                self.heights.push([here.elevation, there.elevation]);
                self.sides.push([side, style.half_width]);
                self.colors.push(style.color);
            }
        }
    }

    /// Number of lines.
    pub(in crate::render) fn len(&self) -> usize {
        self.here.len() / 4
    }

    /// Two triangles a line. A mesh must not be empty: without lines there is one of no length in
    /// the planet's centre.
    pub(in crate::render) fn into_mesh(mut self) -> Mesh {
        if self.len() == 0 {
            let centre = LineEnd {
                direction: DVec3::ZERO,
                elevation: 0.0,
            };
            let unseen = LineStyle {
                half_width: 0.0,
                color: [0; 4],
            };
            self.add(centre, centre, unseen);
        }
        // The ends look at each other, so side -1 of one is opposite to side 1 of the other.
        let quad = |k: u32| [0, 1, 2, 0, 2, 3].map(|corner| 4 * k + corner);
        let indices = (0..self.len() as u32).flat_map(quad).collect();
        let usages = RenderAssetUsages::RENDER_WORLD;
        Mesh::new(PrimitiveTopology::TriangleList, usages)
            .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, self.here)
            .with_inserted_attribute(OTHER, self.there)
            .with_inserted_attribute(HEIGHTS, self.heights)
            .with_inserted_attribute(SIDE, self.sides)
            .with_inserted_attribute(COLOR, VertexAttributeValues::Unorm8x4(self.colors))
            .with_inserted_indices(Indices::U32(indices))
    }
}
