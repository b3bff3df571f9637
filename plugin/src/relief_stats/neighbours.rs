//! The eight neighbours of a cell.

/// A step from a cell to a neighbour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CellStep {
    /// Columns to the east: -1, 0 or 1.
    pub east: isize,
    /// Rows to the south: -1, 0 or 1.
    pub south: isize,
}

impl CellStep {
    const fn new(east: isize, south: isize) -> Self {
        Self { east, south }
    }

    /// Its length in m on pixels of a size.
    pub(super) fn length_m(self, [pixel_x, pixel_y]: [f64; 2]) -> f32 {
        let [x, y] = [self.east as f64 * pixel_x, self.south as f64 * pixel_y];
        (x * x + y * y).sqrt() as f32
    }
}

/// The steps to all neighbours, from the east on clockwise.
pub(super) const NEIGHBOURS: [CellStep; 8] = [
    CellStep::new(1, 0),
    CellStep::new(1, 1),
    CellStep::new(0, 1),
    CellStep::new(-1, 1),
    CellStep::new(-1, 0),
    CellStep::new(-1, -1),
    CellStep::new(0, -1),
    CellStep::new(1, -1),
];

/// From the number of a cell to the numbers of its neighbours, in tiles of so many columns: added
/// with wrapping. From a cell at an edge, some lead beyond the tile or to another edge.
pub(super) fn neighbour_offsets(columns: usize) -> [usize; 8] {
    NEIGHBOURS.map(|step| (step.south * columns as isize + step.east) as usize)
}
