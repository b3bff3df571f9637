//! Missing values, filled from their neighbours: ring after ring from the edge of a hole inwards,
//! each value the mean of those of its eight neighbours that were known before the ring.

use core::ops::Range;

/// Fills all NaN in rows of `width`. Returns their number; `None` if there are no other values.
pub(super) fn fill(width: usize, values: &mut [f32]) -> Option<usize> {
    let missing = values.iter().filter(|z| z.is_nan()).count();
    if missing == values.len() {
        return None;
    }
    // The first ring: voids beside known values.
    let mut ring: Vec<(usize, f32)> = (0..values.len())
        .filter(|&i| values[i].is_nan())
        .filter_map(|i| Some((i, mean_around(width, values, i)?)))
        .collect();
    while !ring.is_empty() {
        // All means of a ring are taken before one of them is written: the order of voids does not
        // matter.
        for &(i, mean) in &ring {
            values[i] = mean;
        }
        // The next ring is what lies around this one: every void is looked at a few times, however
        // deep the hole.
        let next = beside(&ring, width, values);
        ring = next
            .into_iter()
            .filter_map(|i| Some((i, mean_around(width, values, i)?)))
            .collect();
    }
    Some(missing)
}

/// A void that is in the next ring: NaN, told from others by its last bit.
const QUEUED: u32 = 0x7fc0_0001;

/// The voids around a ring, each once.
fn beside(ring: &[(usize, f32)], width: usize, values: &mut [f32]) -> Vec<usize> {
    let mut found = Vec::new();
    let len = values.len();
    for j in ring
        .iter()
        .flat_map(|&(i, _)| around(width, len, i).flatten())
    {
        if values[j].is_nan() && values[j].to_bits() != QUEUED {
            values[j] = f32::from_bits(QUEUED);
            found.push(j);
        }
    }
    found
}

/// Ranges of the pixels around pixel `i` in up to three rows, itself included.
fn around(width: usize, len: usize, i: usize) -> impl Iterator<Item = Range<usize>> {
    let (x, y) = (i % width, i / width);
    let (west, east) = (x.saturating_sub(1), (x + 2).min(width));
    let rows = y.saturating_sub(1)..(y + 2).min(len / width);
    rows.map(move |row| row * width + west..row * width + east)
}

/// Mean of the known values among the eight around `i`.
fn mean_around(width: usize, values: &[f32], i: usize) -> Option<f32> {
    let (mut sum, mut count) = (0.0, 0.0);
    for range in around(width, values.len(), i) {
        for z in values[range].iter().filter(|z| !z.is_nan()) {
            sum += f64::from(*z);
            count += 1.0;
        }
    }
    (count > 0.0).then(|| (sum / count) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_are_filled_from_the_edge_inwards() {
        let mut plane: Vec<f32> = (0..49).map(|i| (i % 7) as f32).collect();
        for i in [0, 16, 17, 18, 23, 24, 25, 30, 31, 32, 48] {
            plane[i] = f32::NAN;
        }
        assert_eq!(fill(7, &mut plane), Some(11));
        assert!(plane.iter().all(|z| z.is_finite()));
        // The middle of a symmetric hole in a plane is on the plane; values stay within those
        // around.
        assert!((plane[24] - 3.0).abs() < 1e-6);
        assert!(plane.iter().all(|&z| (0.0..=6.0).contains(&z)));
        assert_eq!(plane[8], 1.0, "known values stay");
    }

    #[test]
    fn one_height_fills_a_plain() {
        let mut plain = vec![f32::NAN; 300 * 200];
        plain[17] = 5.0;
        assert_eq!(fill(300, &mut plain), Some(300 * 200 - 1));
        assert!(plain.iter().all(|&z| z == 5.0));
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert_eq!(fill(2, &mut [f32::NAN; 4]), None);
        assert_eq!(fill(2, &mut []), None);
        assert_eq!(fill(2, &mut [1.0; 4]), Some(0));
    }
}
