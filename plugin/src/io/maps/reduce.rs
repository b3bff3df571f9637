//! Maps that are finer than the base mesh, brought to means: a vertex stands for the ground around
//! it, not for the pixel that it happens to meet.

use crate::climate::{EquirectMap, MapError};
use rayon::prelude::*;

/// Most rows of a map of the terrain: pixels of 28 km at the equator of an Earth, about half an edge
/// of the base mesh.
const MOST_ROWS: u32 = 720;

/// The map in at most [`MOST_ROWS`] rows: means over blocks of pixels, of those that have a value.
pub(in crate::io) fn reduced(map: &EquirectMap) -> Result<EquirectMap, MapError> {
    if map.size()[1] <= MOST_ROWS {
        return Ok(map.clone());
    }
    let width = 2 * MOST_ROWS;
    let mut values = vec![f32::NAN; width as usize * MOST_ROWS as usize];
    values
        .par_chunks_mut(width as usize)
        .enumerate()
        .for_each(|(y, row)| {
            for (x, value) in row.iter_mut().enumerate() {
                *value = block_mean(map, x, y);
            }
        });
    EquirectMap::new(width, MOST_ROWS, values)
}

/// The mean of the pixels of `map` in the place of pixel (`x`, `y`) of the smaller map; NaN where
/// all of them are void.
fn block_mean(map: &EquirectMap, x: usize, y: usize) -> f32 {
    let [width, height] = map.size().map(|side| side as usize);
    let rows = MOST_ROWS as usize;
    let (mut sum, mut count) = (0.0, 0.0);
    for row in y * height / rows..(y + 1) * height / rows {
        let columns = x * height / rows..(x + 1) * height / rows;
        let pixels = &map.values()[row * width..][columns];
        for &value in pixels.iter().filter(|value| !value.is_nan()) {
            sum += f64::from(value);
            count += 1.0;
        }
    }
    (sum / count) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::direction;

    #[test]
    fn small_maps_stay_as_they_are() {
        let map = EquirectMap::from_fn(MOST_ROWS, |lat, lon| (lat + lon) as f32).unwrap();
        assert_eq!(reduced(&map).unwrap(), map);
    }

    #[test]
    fn blocks_become_their_means() {
        // Rows of 0 and 1 km in turn, of which every block has as many.
        let height = 2 * MOST_ROWS;
        let step = 180.0 / f64::from(height);
        let row = |lat: f64| ((90.0 - lat) / step) as u32;
        let map = EquirectMap::from_fn(height, |lat, _| (row(lat) % 2) as f32).unwrap();
        let small = reduced(&map).unwrap();
        assert_eq!(small.size(), [2 * MOST_ROWS, MOST_ROWS]);
        assert!(small.values().iter().all(|&value| value == 0.5));
    }

    #[test]
    fn places_stay_where_they_are_whatever_the_size() {
        let map = EquirectMap::from_fn(1000, |lat, lon| (lat + 0.1 * lon) as f32).unwrap();
        let small = reduced(&map).unwrap();
        for (lat, lon) in [(80.0, -170.0), (0.3, 0.4), (-51.0, 120.0)] {
            let value = small.at(direction(lat, lon)).unwrap();
            let expected = (lat + 0.1 * lon) as f32;
            assert!((value - expected).abs() < 0.25, "{value} {expected}");
        }
    }

    #[test]
    fn voids_count_for_nothing() {
        let map = EquirectMap::from_fn(1440, |lat, lon| match (lat > 0.0, lon > 0.0) {
            (true, _) => 7.0,
            (false, true) => f32::NAN,
            (false, false) => 3.0,
        });
        let small = reduced(&map.unwrap()).unwrap();
        assert_eq!(small.at(direction(45.0, 90.0)), Some(7.0));
        assert_eq!(small.at(direction(-45.0, 90.0)), None);
        assert_eq!(small.at(direction(-45.0, -90.0)), Some(3.0));
    }
}
