//! Kinds of edges.

/// Kind of an edge (the paper's edge types R and T; gullies have their own).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum EdgeKind {
    /// Ground.
    #[default]
    Terrain = 0,
    /// A river runs along it, from the first end to the second.
    River = 1,
    /// A dry drainage line runs along it, from the first end to the second.
    Gully = 2,
}

crate::wgsl::shared!(
    TERRAIN_EDGE = EdgeKind::Terrain as u32,
    RIVER_EDGE = EdgeKind::River as u32,
    GULLY_EDGE = EdgeKind::Gully as u32,
);
