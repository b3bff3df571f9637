//! An export from the ground to its files.

use super::area::ExportArea;
use super::encoding::Encoding;
use super::error::ExportError;
use super::format::ExportFormat;
use super::greys::{self, GreyRange};
use super::manifest::{add_hashes, manifest};
use super::names::{ExportFiles, file_name};
use super::scratch::HeightScratch;
use super::{exr, geotiff, mesh};
use crate::io::files::write_hashed;
use crate::io::{MarkedJson, write_all};
use crate::query::{Ground, MapGrid};
use serde_json::Value;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// An area, and the files that are to show it.
#[derive(Clone, Debug)]
pub struct ExportJob {
    area: ExportArea,
    files: ExportFiles,
    range: Option<[f64; 2]>,
    level: Option<u8>,
}

/// The outcome of an export.
#[derive(Clone, Debug, PartialEq)]
pub struct Exported {
    /// All files that were written, those with heights first.
    pub files: Vec<PathBuf>,
    /// Lowest and highest ground in m.
    pub heights_m: [f32; 2],
    /// Whether heights beyond the range of greys became black or white.
    pub is_cut_off: bool,
}

impl ExportJob {
    /// An export of an area to `path`, whose extension says in which format; a block of tiles to
    /// `NAME_COLUMN_ROW.EXTENSION` beside it.
    ///
    /// # Errors
    /// [`ExportError::Extension`], [`ExportError::Pixels`], [`ExportError::MeshOfBox`].
    pub fn new(area: impl Into<ExportArea>, path: &Path) -> Result<Self, ExportError> {
        let area = area.into();
        let files = ExportFiles::new(path, area.tiles())?;
        let file = area.file(0);
        files.format().check(file.columns().max(file.rows()))?;
        if matches!(area, ExportArea::Box(_)) && files.format() == ExportFormat::Mesh {
            return Err(ExportError::MeshOfBox);
        }
        Ok(Self {
            area,
            files,
            range: None,
            level: None,
        })
    }

    /// The same at a level of its own, whatever its pixels are.
    ///
    /// # Errors
    /// [`ExportError::Ground`] for a level beyond the finest.
    pub fn at_level(mut self, level: u8) -> Result<Self, ExportError> {
        self.area.grid().at_level(level)?;
        self.level = Some(level);
        Ok(self)
    }

    /// The same with greys from `low`, black, to `high`, white, in m. Without a range they go from
    /// the lowest to the highest ground of all files.
    ///
    /// # Errors
    /// [`ExportError::Range`], [`ExportError::NoGreys`].
    pub fn with_range(mut self, [low, high]: [f64; 2]) -> Result<Self, ExportError> {
        if !self.files.format().has_greys() {
            return Err(ExportError::NoGreys(self.files.format().name()));
        }
        if !(low < high && low.is_finite() && high.is_finite()) {
            return Err(ExportError::Range(low, high));
        }
        self.range = Some([low, high]);
        Ok(self)
    }

    /// All points that it asks for.
    pub fn grid(&self) -> MapGrid {
        let grid = self.area.grid();
        self.level
            .and_then(|level| grid.at_level(level).ok())
            .unwrap_or(grid)
    }

    /// The files that it will write.
    pub fn files(&self) -> &ExportFiles {
        &self.files
    }

    /// Asks for all heights, and writes all files or none. `go_on` is told, from any thread, the
    /// number of points that are known, and says whether to go on.
    ///
    /// Memory does not grow with the area; the disk holds its heights a second time while files are
    /// written.
    ///
    /// # Errors
    /// [`ExportError::Ground`], [`ExportError::Encode`] for heights that are not numbers,
    /// [`ExportError::Io`]; nothing is written then.
    pub fn run(
        &self,
        ground: &(impl Ground + ?Sized),
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Exported, ExportError> {
        let grid = self.grid();
        let heights = HeightScratch::record(ground, &grid, self.files.path(), &go_on)?;
        let [low, high] = self.range.unwrap_or(heights.range.map(f64::from));
        let range = GreyRange { low, high };
        let mut texts = self.texts(&heights, range);
        let mut hashes = Vec::new();
        let named = self.files.named().len();
        let go_on = || go_on(grid.columns() * grid.rows());
        write_all(&self.files.outputs(), |k, out| match k.checked_sub(named) {
            Some(text) => {
                add_hashes(&mut texts[text], &hashes);
                out.write_all(&json_text(&texts[text])?)
            }
            None => {
                let write = |out: &mut dyn Write| self.write_file(k, &heights, range, &go_on, out);
                hashes.push(write_hashed(out, write)?);
                Ok(())
            }
        })?;
        Ok(Exported {
            files: self.files.all(),
            heights_m: heights.range,
            is_cut_off: f64::from(heights.range[0]) < low || f64::from(heights.range[1]) > high,
        })
    }

    /// The files beside those with heights.
    fn texts(&self, heights: &HeightScratch, range: GreyRange) -> Vec<Value> {
        let range = self.files.format().has_greys().then_some(range);
        let mut texts = range.map_or_else(Vec::new, |range| self.sidecars(range));
        if let ExportArea::Tiles(block) = &self.area {
            let level = self.grid().level();
            texts.push(manifest(&self.files, block, level, heights.range, range));
        }
        texts
    }

    /// The sidecar of each file of greys.
    fn sidecars(&self, range: GreyRange) -> Vec<Value> {
        (0..)
            .zip(self.files.named())
            .map(|(k, path)| {
                let mut sidecar = match &self.area {
                    ExportArea::Box(degrees) => greys::box_sidecar(degrees, range),
                    area => greys::square_sidecar(&area.file(k), range),
                };
                sidecar["file"] = file_name(&path).into();
                sidecar
            })
            .collect()
    }

    /// Writes the `k`-th file with heights.
    fn write_file(
        &self,
        k: usize,
        heights: &HeightScratch,
        range: GreyRange,
        go_on: &(dyn Fn() -> bool + Sync),
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let source = Encoding {
            grid: self.area.file(k),
            heights,
            go_on,
        };
        match self.files.format() {
            ExportFormat::GeoTiff => geotiff::write(&source, out),
            ExportFormat::Grey => greys::write_png(&source, range, out),
            ExportFormat::Raw => greys::write_raw(&source, range, out),
            ExportFormat::Exr => exr::write(&source, out),
            ExportFormat::Mesh => mesh::write(&source, out),
        }
    }
}

/// A value as the text of a file.
fn json_text(content: &Value) -> io::Result<Vec<u8>> {
    let mut text = serde_json::to_vec_pretty(&MarkedJson::new(content))?;
    text.push(b'\n');
    Ok(text)
}
