//! The part of the planet that is exported.

use crate::query::{DegreeBox, MapGrid, MapSquare, TileBlock};
use bevy::prelude::*;

/// The part of the planet that is exported.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub enum ExportArea {
    /// A square of pixels, in one file.
    Square(MapSquare),
    /// A block of tiles, in a file each.
    Tiles(TileBlock),
    /// A box of degrees, in one file.
    Box(DegreeBox),
}

impl ExportArea {
    /// All points of the area.
    pub fn grid(&self) -> MapGrid {
        match self {
            Self::Square(square) => square.grid(),
            Self::Tiles(block) => block.grid(),
            Self::Box(degrees) => degrees.grid(),
        }
    }

    /// Columns and rows of its tiles.
    pub fn tiles(&self) -> Option<[usize; 2]> {
        match self {
            Self::Tiles(block) => Some(block.tiles()),
            Self::Square(_) | Self::Box(_) => None,
        }
    }

    /// The points of its `k`-th file.
    pub(super) fn file(&self, k: usize) -> MapGrid {
        match self {
            Self::Tiles(block) => {
                let columns = block.tiles()[0];
                block.tile(k % columns, k / columns)
            }
            Self::Square(_) | Self::Box(_) => self.grid(),
        }
    }
}

impl From<MapSquare> for ExportArea {
    fn from(square: MapSquare) -> Self {
        Self::Square(square)
    }
}

impl From<TileBlock> for ExportArea {
    fn from(block: TileBlock) -> Self {
        Self::Tiles(block)
    }
}

impl From<DegreeBox> for ExportArea {
    fn from(degrees: DegreeBox) -> Self {
        Self::Box(degrees)
    }
}
