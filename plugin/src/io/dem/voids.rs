//! Missing values, filled from their neighbours: ring after ring from the edge of a hole inwards, each value the
//! mean of those of its eight neighbours that were known before the ring.

/// Fills all values that are not a number in rows of `width`. Returns how many there were; `None` if there is nothing
/// else.
pub(super) fn fill(width: usize, values: &mut [f32]) -> Option<usize> {
    let mut missing: Vec<usize> = (0..values.len()).filter(|&i| values[i].is_nan()).collect();
    let count = missing.len();
    if count == values.len() {
        return None;
    }
    while !missing.is_empty() {
        let found: Vec<Option<f32>> = missing.iter().map(|&i| mean_around(width, values, i)).collect();
        for (&i, mean) in missing.iter().zip(&found) {
            if let Some(mean) = mean {
                values[i] = *mean;
            }
        }
        let mut known = found.iter().map(Option::is_some);
        missing.retain(|_| !known.next().unwrap_or(true));
    }
    Some(count)
}

/// Mean of the known values among the eight around `i`.
fn mean_around(width: usize, values: &[f32], i: usize) -> Option<f32> {
    let (x, y) = (i % width, i / width);
    let (mut sum, mut count) = (0.0_f64, 0);
    for row in y.saturating_sub(1)..=(y + 1).min(values.len() / width - 1) {
        for z in &values[row * width + x.saturating_sub(1)..=row * width + (x + 1).min(width - 1)] {
            if !z.is_nan() {
                sum += f64::from(*z);
                count += 1;
            }
        }
    }
    (count > 0).then(|| (sum / f64::from(count)) as f32)
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
        // The middle of a symmetric hole in a plane is on the plane; values stay within those around.
        assert!((plane[24] - 3.0).abs() < 1e-6);
        assert!(plane.iter().all(|&z| (0.0..=6.0).contains(&z)));
        assert_eq!(plane[8], 1.0, "known values stay");
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert_eq!(fill(2, &mut [f32::NAN; 4]), None);
        assert_eq!(fill(2, &mut []), None);
        assert_eq!(fill(2, &mut [1.0; 4]), Some(0));
    }
}
