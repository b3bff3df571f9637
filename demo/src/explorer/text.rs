//! Numbers as people write them.

use bevy::math::DVec3;
use bevy_pangaea::math::lat_lon;

/// `12.3° N  45.6° W`.
pub fn place(direction: DVec3) -> String {
    let (lat, lon) = lat_lon(direction);
    let north = if lat < 0.0 { 'S' } else { 'N' };
    let east = if lon < 0.0 { 'W' } else { 'E' };
    format!("{:.1}° {north}  {:.1}° {east}", lat.abs(), lon.abs())
}

/// About four significant digits, as short as can be: `0.3`, `1800`, `1.3e-5`.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e7).contains(&size) {
        let text = format!("{value:.2e}");
        return match text.split_once('e') {
            Some((digits, power)) => format!("{}e{power}", trimmed(digits)),
            None => text,
        };
    }
    // One digit before the point has three behind it; each further digit takes one away.
    let (mut decimals, mut rest) = (3_usize, size);
    while rest >= 10.0 {
        decimals = decimals.saturating_sub(1);
        rest /= 10.0;
    }
    while rest < 1.0 {
        decimals += 1;
        rest *= 10.0;
    }
    trimmed(&format!("{value:.decimals$}")).to_string()
}

/// Without zeros at the end of the decimals.
fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

/// A number with its unit, which may be empty.
pub fn with_unit(value: f64, unit: &str) -> String {
    if unit.is_empty() {
        number(value)
    } else {
        format!("{} {unit}", number(value))
    }
}

/// `60 000`.
pub fn count(n: usize) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            // A thin space.
            out.push('\u{2009}');
        }
        out.push(digit);
    }
    out
}

/// An area in km² as `12.3 M km²` or `45 000 km²`.
pub fn area(km2: f64) -> String {
    if km2 >= 1e6 {
        format!("{:.1} M km²", km2 * 1e-6)
    } else {
        format!("{} km²", count(km2.max(0.0) as usize))
    }
}

/// `snake_case` as words: `Snake case`.
pub fn words(name: &str) -> String {
    let mut text = name.replace('_', " ");
    if let Some(first) = text.get_mut(0..1) {
        first.make_ascii_uppercase();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_exact_enough() {
        for (value, text) in [
            (0.0, "0"),
            (0.3, "0.3"),
            (1800.0, "1800"),
            (-6.0, "-6"),
            (0.158, "0.158"),
            (0.002, "0.002"),
            (1.3e-5, "1.3e-5"),
            (2e-5, "2e-5"),
            (1e7, "1e7"),
            (33.2, "33.2"),
            (123456.0, "123456"),
        ] {
            assert_eq!(number(value), text);
        }
        for value in [1.3e-5, 0.0712, 33.21, 4200.0, 9.87e8] {
            let back: f64 = number(value).parse().unwrap();
            assert!((back - value).abs() <= 1e-3 * value.abs());
        }
    }

    #[test]
    fn places_have_hemispheres() {
        let at = |lat, lon| place(bevy_pangaea::math::direction(lat, lon));
        assert_eq!(at(-33.0, -70.0), "33.0° S  70.0° W");
        assert_eq!(at(48.1, 11.5), "48.1° N  11.5° E");
    }

    #[test]
    fn counts_and_areas_are_grouped() {
        assert_eq!(count(1_234_567), "1\u{2009}234\u{2009}567");
        assert_eq!(count(60), "60");
        assert_eq!(area(12.34e6), "12.3 M km²");
        assert_eq!(words("slab_pull"), "Slab pull");
    }
}
