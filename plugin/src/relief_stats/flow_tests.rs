use super::*;

fn grid(width: usize, values: Vec<f32>) -> HeightGrid {
    HeightGrid {
        width,
        height: values.len() / width,
        values,
        pixel_m: [10.0; 2],
    }
}

/// Heights that no two cells share.
fn rough(width: usize, height: usize) -> HeightGrid {
    let mix = |i: usize| (i as u32).wrapping_mul(0x9E37_79B1) >> 12;
    let values = (0..width * height).map(|i| mix(i) as f32 - 500_000.0);
    grid(width, values.collect())
}

/// The eight neighbours of an inner cell, and how far they are in m.
fn around(cells: &HeightGrid, cell: usize) -> Vec<(usize, f32)> {
    let (x, y) = (cell % cells.width, cell / cells.width);
    let mut found = Vec::new();
    for (row, column) in (y - 1..=y + 1).flat_map(|row| (x - 1..=x + 1).map(move |c| (row, c))) {
        let squared = row.abs_diff(y) + column.abs_diff(x);
        if squared > 0 {
            found.push((row * cells.width + column, 10.0 * (squared as f32).sqrt()));
        }
    }
    found
}

fn is_edge(cells: &HeightGrid, cell: usize) -> bool {
    let (x, y) = (cell % cells.width, cell / cells.width);
    x == 0 || y == 0 || x + 1 == cells.width || y + 1 == cells.height
}

/// Filled levels by relaxation: a cell is as high as its lowest way out, or as its ground.
fn relaxed(cells: &HeightGrid) -> Vec<f32> {
    let count = cells.values.len();
    let mut level: Vec<f32> = (0..count)
        .map(|i| {
            if is_edge(cells, i) {
                cells.values[i]
            } else {
                f32::INFINITY
            }
        })
        .collect();
    loop {
        let before = level.clone();
        for cell in (0..count).filter(|&i| !is_edge(cells, i)) {
            let out = around(cells, cell).into_iter().map(|(next, _)| level[next]);
            level[cell] = cells.values[cell].max(out.fold(f32::INFINITY, f32::min));
        }
        if level == before {
            return level;
        }
    }
}

#[test]
fn depressions_are_filled_to_their_saddles() {
    let cells = rough(23, 17);
    let mut flood = CellFlood::new(&cells);
    flood.seed_edges();
    flood.rise();
    assert_eq!(flood.level, relaxed(&cells));
    assert_eq!(flood.order.len(), cells.values.len());
}

#[test]
fn slopes_are_those_of_the_steepest_descent() {
    let cells = rough(23, 17);
    let level = relaxed(&cells);
    let flow = CellFlow::of(&cells);
    for cell in (0..level.len()).filter(|&i| !is_edge(&cells, i)) {
        let slopes = around(&cells, cell).into_iter();
        let steepest = slopes.fold(0.0_f32, |steepest, (next, metres)| {
            steepest.max((level[cell] - level[next]) / metres)
        });
        assert!(
            (flow.slope[cell] - steepest).abs() <= 1e-5 * steepest,
            "{cell}"
        );
    }
}

/// All water leaves at the edges, each cell's once.
#[test]
fn no_water_is_lost() {
    for cells in [rough(23, 17), grid(9, vec![3.0; 81])] {
        let flow = CellFlow::of(&cells);
        let edges = (0..cells.values.len()).filter(|&i| is_edge(&cells, i));
        let leaving: usize = edges.map(|i| flow.upstream[i] as usize).sum();
        assert_eq!(leaving, cells.values.len());
    }
}

/// A gutter from north to south between two hillsides of 4 cells: 9 cells a row drain to it, but
/// for those at the edge.
#[test]
fn a_gutter_gathers_its_hillsides() {
    let height = |i: usize| (i % 11).abs_diff(5) as f32 * 100.0 - (i / 11) as f32;
    let flow = CellFlow::of(&grid(11, (0..11 * 8).map(height).collect()));
    for row in 1..7 {
        assert_eq!(flow.upstream[row * 11 + 5] as usize, 9 * row);
        assert_eq!(flow.slope[row * 11 + 5], 0.1);
    }
}

#[test]
fn levels_are_ranked_in_order() {
    let levels = [-8000.0, -1.5, -0.0, 0.0, 0.25, 1.0, 8848.0];
    assert!(levels.windows(2).all(|pair| rank(pair[0]) < rank(pair[1])));
}
