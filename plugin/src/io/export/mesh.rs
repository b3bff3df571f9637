//! A mesh as binary glTF: a vertex at each point, where it is on the planet, so that the mesh is
//! curved as the planet is.
//!
//! The origin is the middle of the whole grid at sea level; +x is east, +y up, -z north, as glTF
//! has it. Lengths are in m. Tiles have the origin of their block, and their normals know the
//! ground beyond the edge: neighbours have the same vertices.
//!
//! Positions follow from heights at little cost, so each part of the file is computed anew, band by
//! band.

use super::encoding::Encoding;
use super::glb::{MeshSize, write_head};
use crate::query::{AzimuthalEquidistant, GridProjection, MapGrid, row_triangles};
use bevy::math::{DVec3, Vec3};
use core::ops::Range;
use rayon::prelude::*;
use std::io::{self, Write};

/// The file of a grid.
pub(super) fn write(source: &Encoding, out: &mut dyn Write) -> io::Result<()> {
    let mesh = MeshSource::new(source)?;
    write_head(out, mesh.size(), mesh.bounds()?)?;
    source.for_each_rows(|rows| {
        let [columns, rows] = mesh.in_whole(rows);
        write_vectors(out, &mesh.vertices(columns, rows)?.positions)
    })?;
    source.for_each_rows(|rows| write_vectors(out, &mesh.normals(rows)?))?;
    source.for_each_rows(|rows| mesh.write_triangles(out, rows))
}

fn write_vectors(out: &mut dyn Write, vectors: &[Vec3]) -> io::Result<()> {
    let floats = vectors.iter().flat_map(|v| v.to_array());
    let bytes: Vec<u8> = floats.flat_map(f32::to_le_bytes).collect();
    out.write_all(&bytes)
}

/// The mesh of a window of a grid.
struct MeshSource<'a> {
    source: &'a Encoding<'a>,
    whole: MapGrid,
    about: AzimuthalEquidistant,
}

impl<'a> MeshSource<'a> {
    fn new(source: &'a Encoding<'a>) -> io::Result<Self> {
        let GridProjection::Azimuthal(about) = *source.grid.projection() else {
            return Err(io::ErrorKind::Unsupported.into());
        };
        Ok(Self {
            source,
            whole: source.grid.whole(),
            about,
        })
    }

    fn size(&self) -> MeshSize {
        let (columns, rows) = (self.source.grid.columns(), self.source.grid.rows());
        MeshSize {
            vertices: columns * rows,
            indices: 6 * (columns - 1) * (rows - 1),
        }
    }

    /// All columns of the window, and some of its rows, as columns and rows of the whole grid.
    fn in_whole(&self, rows: Range<usize>) -> [Range<usize>; 2] {
        let [column, row] = self.source.grid.first();
        [
            column..column + self.source.grid.columns(),
            row + rows.start..row + rows.end,
        ]
    }

    /// The vertices at columns and rows of the whole grid.
    fn vertices(&self, columns: Range<usize>, rows: Range<usize>) -> io::Result<VertexPatch> {
        let heights = self.source.heights.read(columns.clone(), rows.clone())?;
        let width = columns.len();
        let positions = heights
            .par_iter()
            .enumerate()
            .map(|(i, &z)| self.position(columns.start + i % width, rows.start + i / width, z));
        Ok(VertexPatch {
            columns: columns.clone(),
            rows: rows.clone(),
            positions: positions.collect(),
        })
    }

    /// Where a point of the whole grid is: relative to the middle, before it is an f32, or the
    /// planet's radius would cost its metres.
    fn position(&self, column: usize, row: usize, height: f32) -> Vec3 {
        let (up, (east, north)) = (self.about.centre(), self.about.axes());
        let radius = self.about.radius_m();
        let direction = self.whole.direction(column, row);
        let p = direction * (radius + f64::from(height)) - up * radius;
        DVec3::new(p.dot(east), p.dot(up), -p.dot(north)).as_vec3()
    }

    /// Corners of the box around all positions.
    fn bounds(&self) -> io::Result<[Vec3; 2]> {
        let mut bounds = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        self.source.for_each_rows(|rows| {
            let [columns, rows] = self.in_whole(rows);
            for &p in &self.vertices(columns, rows)?.positions {
                bounds = [bounds[0].min(p), bounds[1].max(p)];
            }
            Ok(())
        })?;
        Ok(bounds)
    }

    /// The normals of some rows of the window.
    fn normals(&self, rows: Range<usize>) -> io::Result<Vec<Vec3>> {
        let [columns, rows] = self.in_whole(rows);
        let [all_columns, all_rows] = [self.whole.columns(), self.whole.rows()];
        let around = self.vertices(
            with_neighbours(&columns, all_columns),
            with_neighbours(&rows, all_rows),
        )?;
        let width = columns.len();
        let normals = (0..width * rows.len())
            .into_par_iter()
            .map(|i| around.normal(columns.start + i % width, rows.start + i / width));
        Ok(normals.collect())
    }

    /// Two triangles for each cell between some rows of the window and the next ones,
    /// counter-clockwise seen from outside.
    fn write_triangles(&self, out: &mut dyn Write, rows: Range<usize>) -> io::Result<()> {
        let n = self.source.grid.columns();
        for y in rows.start..rows.end.min(self.source.grid.rows() - 1) {
            let indices = row_triangles(n, y).flatten();
            out.write_all(&indices.flat_map(u32::to_le_bytes).collect::<Vec<u8>>())?;
        }
        Ok(())
    }
}

/// A range with the numbers before and after it, as far as there are any below `count`.
fn with_neighbours(range: &Range<usize>, count: usize) -> Range<usize> {
    range.start.saturating_sub(1)..(range.end + 1).min(count)
}

/// Vertices at columns and rows of the whole grid.
struct VertexPatch {
    columns: Range<usize>,
    rows: Range<usize>,
    positions: Vec<Vec3>,
}

impl VertexPatch {
    /// The normal at a vertex, from central differences; at the rim from one-sided ones.
    fn normal(&self, column: usize, row: usize) -> Vec3 {
        let columns = with_neighbours(&(column..column + 1), self.columns.end);
        let rows = with_neighbours(&(row..row + 1), self.rows.end);
        let eastward = self.at(columns.end - 1, row) - self.at(columns.start, row);
        let northward = self.at(column, rows.start) - self.at(column, rows.end - 1);
        let normal = eastward.cross(northward).try_normalize();
        normal.unwrap_or(DVec3::Y).as_vec3()
    }

    /// A position; of the nearest column and row where the patch has none.
    fn at(&self, column: usize, row: usize) -> DVec3 {
        let x = column.saturating_sub(self.columns.start);
        let y = row.saturating_sub(self.rows.start);
        self.positions[y * self.columns.len() + x].as_dvec3()
    }
}
