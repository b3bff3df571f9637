//! The files of an export: the one that was named or its tiles, and those beside it.

use super::error::ExportError;
use super::format::ExportFormat;
use crate::io::{Output, is_marked};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// The field of a tile's hash in the manifest.
pub(super) const HASH: &str = "blake3";

/// The files of an export.
///
/// ```
/// use bevy_pangaea::io::export::ExportFiles;
/// use std::path::{Path, PathBuf};
///
/// let files = ExportFiles::new(Path::new("maps/t.png"), Some([2, 1]))?;
/// let names = ["maps/t_0_0.png", "maps/t_1_0.png"].map(PathBuf::from);
/// assert_eq!(files.named(), names);
/// let beside = ["maps/t_0_0.json", "maps/t_1_0.json", "maps/t.json"].map(PathBuf::from);
/// assert_eq!(files.beside(), beside);
/// # Ok::<(), bevy_pangaea::io::ExportError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportFiles {
    path: PathBuf,
    format: ExportFormat,
    tiles: Option<[usize; 2]>,
}

impl ExportFiles {
    /// The files of an export to `path`, of so many columns and rows of tiles or of one raster.
    ///
    /// # Errors
    /// [`ExportError::Extension`]
    pub fn new(path: &Path, tiles: Option<[usize; 2]>) -> Result<Self, ExportError> {
        Ok(Self {
            path: path.to_path_buf(),
            format: ExportFormat::of(path)?,
            tiles,
        })
    }

    /// The format.
    pub fn format(&self) -> ExportFormat {
        self.format
    }

    /// The path that was given.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The files with heights: the path itself, or `NAME_COLUMN_ROW.EXTENSION` for each tile, row
    /// by row from the north west.
    pub fn named(&self) -> Vec<PathBuf> {
        match self.tiles {
            None => vec![self.path.clone()],
            Some([columns, rows]) => (0..columns * rows)
                .map(|k| self.tile(k % columns, k / columns))
                .collect(),
        }
    }

    /// The files that are written beside them: a sidecar `NAME.json` for each file of greys, and
    /// the manifest of tiles, last.
    pub fn beside(&self) -> Vec<PathBuf> {
        let greys = self.format.has_greys().then(|| self.named());
        let sidecars = greys.into_iter().flatten().map(|path| json_of(&path));
        sidecars.chain(self.manifest()).collect()
    }

    /// All files, with the older ones that they may replace: the file that was named any, the others
    /// only ours.
    pub fn outputs(&self) -> Vec<Output> {
        let named = self.named();
        // A manifest, the last one, is that of the first tile.
        let of = named.iter().chain(named.first());
        let skipped = named.len() * usize::from(!self.format.has_greys());
        let beside = self.beside().into_iter().zip(of.skip(skipped));
        let beside = beside.map(|(path, of)| Output::telling_of(path, file_name(of)));
        let hashes: BTreeMap<_, _> = self.listed().into_iter().collect();
        let hash = |path: &PathBuf| hashes.get(&file_name(path)).cloned().flatten();
        let with_heights = named
            .iter()
            .map(|path| self.output(path.clone()).unchanged(hash(path)));
        with_heights.chain(beside).collect()
    }

    /// The files that an older manifest of ours lists, with their hashes.
    fn listed(&self) -> Vec<(String, Option<String>)> {
        let is_ours = |manifest: &PathBuf| is_marked(manifest).is_ok_and(|is_ours| is_ours);
        let manifest = self.manifest().filter(is_ours);
        manifest.as_deref().map(listed_files).unwrap_or_default()
    }

    /// A file with heights. Raw ones have no room for a mark: the manifest lists them.
    fn output(&self, path: PathBuf) -> Output {
        match self.manifest() {
            None => Output::named(path),
            Some(manifest) if self.format == ExportFormat::Raw => Output::listed(path, manifest),
            Some(_) => Output::beside(path),
        }
    }

    /// The manifest of tiles.
    pub fn manifest(&self) -> Option<PathBuf> {
        self.tiles.map(|_| json_of(&self.path))
    }

    /// The tiles of an older block that stay beside the files of this export: those that the
    /// manifest of its name lists so far, that are there, and that it does not write. Empty where
    /// there is no such manifest.
    pub fn older_tiles(&self) -> Vec<PathBuf> {
        let own: BTreeSet<_> = self.all().into_iter().collect();
        let listed = self.listed().into_iter();
        let paths = listed.map(|(name, _)| self.path.with_file_name(name));
        paths
            .filter(|path| path.is_file() && !own.contains(path))
            .collect()
    }

    /// All files.
    pub fn all(&self) -> Vec<PathBuf> {
        [self.named(), self.beside()].concat()
    }

    /// The file of a tile.
    fn tile(&self, column: usize, row: usize) -> PathBuf {
        let mut name = OsString::from(self.path.file_stem().unwrap_or_default());
        name.push(format!("_{column}_{row}."));
        name.push(self.path.extension().unwrap_or_default());
        self.path.with_file_name(name)
    }
}

/// The names of the tiles that a manifest lists, with their hashes; none if it cannot be read. A path
/// is no name.
fn listed_files(manifest: &Path) -> Vec<(String, Option<String>)> {
    let text = fs::read(manifest).unwrap_or_default();
    let manifest: Value = serde_json::from_slice(&text).unwrap_or_default();
    let tiles = manifest["files"].as_array().map_or(&[][..], Vec::as_slice);
    let name = |tile: &Value| tile["file"].as_str().map(str::to_owned);
    let hash = |tile: &Value| tile[HASH].as_str().map(str::to_owned);
    let files = tiles
        .iter()
        .filter_map(|tile| Some((name(tile)?, hash(tile))));
    files
        .filter(|(name, _)| Path::new(name).file_name() == Some(name.as_ref()))
        .collect()
}

/// The name of a file without its folder.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// The JSON file of the same name.
fn json_of(path: &Path) -> PathBuf {
    path.with_extension("json")
}
