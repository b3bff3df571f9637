//! GDAL_NODATA: the value that marks voids, as text that GDAL reads.

use super::sample::{NumberKind, SampleType};
use super::structure::unsupported;
use super::tag;
use crate::io::dem::error::DemError;

/// The void of SRTM's heights, which many files of 16 bits keep without saying so.
const SRTM_VOID: f64 = -32_768.0;

/// The last place of an f32.
const SINGLE: f64 = f32::EPSILON as f64;

/// The numbers that mark voids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nodata {
    value: Option<f64>,
    /// The largest relative difference from it, over that of two numbers.
    tolerance: f64,
    /// The number in blocks that are left out.
    pub(super) fill: f64,
}

impl Nodata {
    /// The voids that a text marks for a type of samples. Without a text nothing is marked, but
    /// -32768 among signed numbers of 16 bits.
    pub(super) fn of(text: Option<&str>, sample_type: SampleType) -> Result<Self, DemError> {
        let is_srtm = sample_type.kind == NumberKind::Signed && sample_type.bits == 16;
        let told = match text.filter(|text| !text.trim().is_empty()) {
            Some(text) => Some(number(text).ok_or_else(|| unreadable(text))?),
            None => None,
        };
        let value = told.or(is_srtm.then_some(SRTM_VOID));
        let (value, tolerance) = match (sample_type.kind, sample_type.bits) {
            (NumberKind::Float, 64) => (value, 2.0 * SINGLE),
            // A void of -3.4e38 was rounded to an f32 before it was written out.
            (NumberKind::Float, _) => (value.map(|z| f64::from(z as f32)), 2.0 * SINGLE),
            _ => (value.map(f64::trunc), 0.0),
        };
        Ok(Self {
            value,
            tolerance,
            fill: told.unwrap_or(0.0),
        })
    }

    /// Is a number void? As in GDAL, floating-point numbers may differ by two units in the last place
    /// of an f32.
    pub(super) fn marks(&self, z: f64) -> bool {
        z.is_nan()
            || self.value.is_some_and(|void| {
                z == void || (z - void).abs() < self.tolerance * (z + void).abs()
            })
    }
}

fn unreadable(text: &str) -> DemError {
    let start: String = text.chars().take(40).collect();
    unsupported(tag::GDAL_NODATA, format!("{start:?}"))
}

/// The number that a text begins with: blanks before it and anything behind are passed over, as by
/// C's `strtod`; the names that C libraries give to NaN and infinity are known.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim_start().to_ascii_lowercase();
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(&text)),
    };
    let begins = |words: &[&str]| words.iter().any(|word| digits.starts_with(word));
    if begins(&["nan", "1.#qnan", "1.#ind", "1.#snan"]) {
        return Some(f64::NAN);
    }
    if begins(&["inf", "1.#inf"]) {
        return Some(sign * f64::INFINITY);
    }
    // The longest beginning that is a number; a comma may stand for the point.
    let digits = digits.replacen(',', ".", usize::from(!digits.contains('.')));
    let is_part = |c: &u8| c.is_ascii_digit() || b".e+-".contains(c);
    let most = digits.bytes().take_while(|c| is_part(c)).count();
    let longest = (1..=most.min(400)).rev();
    longest
        .filter_map(|end| digits[..end].parse::<f64>().ok())
        .next()
        .map(|z| sign * z)
}
