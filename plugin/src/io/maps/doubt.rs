//! Maps whose values look like those of another unit, where the file tells none.

use super::units::MapQuantity;
use crate::climate::EquirectMap;

/// Medians over the pixels of a map of the Earth in °C are about 10, in °F about 50.
const WARMEST_MEDIAN_C: f32 = 40.0;

/// Kelvin begin far above all temperatures in °C.
const KELVIN_C: f32 = 150.0;

/// The wettest place of a planet in mm a year, at least; in m and mm a day it is far below.
const LEAST_WETTEST_MM: f32 = 30.0;

/// The Earth's wettest place has 12,000 mm a year.
const MOST_RAIN_MM: f32 = 30_000.0;

/// A sentence of doubt, if there is one.
pub(super) fn of(map: &EquirectMap, quantity: MapQuantity) -> Option<String> {
    match quantity {
        MapQuantity::Temperature => {
            let median = median(map)?;
            (median > WARMEST_MEDIAN_C).then(|| {
                let unit = if median > KELVIN_C { "kelvin" } else { "°F" };
                format!(
                    "the median is {median} °C, and the file tells no unit: it looks like {unit}"
                )
            })
        }
        MapQuantity::Rain => {
            let values = map.values().iter().copied();
            let most = values.fold(f32::NEG_INFINITY, f32::max);
            let is_odd = !(LEAST_WETTEST_MM..=MOST_RAIN_MM).contains(&most);
            (is_odd && most > 0.0).then(|| {
                format!(
                    "the most rain is {most} mm a year, and the file tells no unit: it looks like \
                     another one"
                )
            })
        }
        _ => None,
    }
}

/// The median of the values that there are.
fn median(map: &EquirectMap) -> Option<f32> {
    let mut values: Vec<f32> = sample(map).filter(|value| !value.is_nan()).collect();
    let middle = values.len() / 2;
    let (_, median, _) =
        (!values.is_empty()).then(|| values.select_nth_unstable_by(middle, f32::total_cmp))?;
    Some(*median)
}

/// At most a million values of a map, as many from everywhere.
fn sample(map: &EquirectMap) -> impl Iterator<Item = f32> {
    let step = map.values().len().div_ceil(1 << 20);
    // Columns in turn, and not always the same.
    let step = if step > 1 { step | 1 } else { step };
    map.values().iter().copied().step_by(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn doubt(quantity: MapQuantity, value: impl Fn(f64) -> f32) -> Option<String> {
        let map = EquirectMap::from_fn(18, |lat, _| value(lat)).unwrap();
        of(&map, quantity)
    }

    #[test]
    fn kelvin_and_fahrenheit_are_told_from_celsius() {
        let celsius = |lat: f64| 28.0 - lat.abs() as f32 * 0.7;
        let of = |value: &dyn Fn(f64) -> f32| doubt(MapQuantity::Temperature, value);
        assert_eq!(of(&celsius), None);
        assert!(of(&|lat| celsius(lat) + 273.15).unwrap().contains("kelvin"));
        let hot = |lat| 1.8 * (celsius(lat) + 15.0) + 32.0;
        assert!(of(&hot).unwrap().contains("°F"));
    }

    #[test]
    fn rain_in_metres_is_told_from_millimetres() {
        let millimetres = |lat: f64| 2500.0 * (1.0 - lat.abs() as f32 / 90.0);
        let of = |value: &dyn Fn(f64) -> f32| doubt(MapQuantity::Rain, value);
        assert_eq!(of(&millimetres), None);
        assert!(of(&|lat| millimetres(lat) / 1000.0).is_some());
        assert!(of(&|lat| millimetres(lat) / 3.2e7).is_some());
        assert!(of(&|lat| 100.0 * millimetres(lat)).is_some());
        assert_eq!(of(&|_| 0.0), None, "a world without rain");
    }
}
