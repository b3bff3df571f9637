//! Predictors: a row holds the differences of neighbouring samples (TIFF 6.0, section 14), or of
//! the bytes of floating-point numbers, sorted by their rank (Adobe Photoshop TIFF Technical Note 3).

use super::sample::{NumberKind, SampleType};
use super::structure::unsupported;
use super::tag;
use crate::io::dem::error::DemError;

/// How a row is predicted from its own beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Predictor {
    /// Not at all.
    None,
    /// A sample by the one before.
    Horizontal,
    /// A byte by the one before, all highest bytes first.
    Float,
}

impl Predictor {
    /// The predictor of a number, for samples of a type.
    pub(super) fn of(number: u64, sample_type: SampleType) -> Result<Self, DemError> {
        let is_float = sample_type.kind == NumberKind::Float;
        match (number, sample_type.bytes()) {
            (1, _) => Ok(Self::None),
            (2, Some(_)) => Ok(Self::Horizontal),
            (3, Some(_)) if is_float => Ok(Self::Float),
            _ => Err(unsupported(tag::PREDICTOR, number)),
        }
    }

    /// Turns a row into samples of `bytes` that begin with their least one, `stride` to a pixel.
    pub(super) fn undo(self, row: &mut [u8], bytes: usize, stride: usize) {
        match self {
            Self::None => {}
            Self::Horizontal => add_up(row, bytes, stride),
            Self::Float => {
                add_up(row, 1, stride);
                join(row, bytes);
            }
        }
    }
}

/// Adds to every number of `bytes` the one `stride` before, without carry out of it.
fn add_up(row: &mut [u8], bytes: usize, stride: usize) {
    match bytes {
        1 => add_each(row, stride, |[a], [b]: [u8; 1]| [a.wrapping_add(b)]),
        2 => add_each(row, stride, |a, b| {
            u16::from_le_bytes(a)
                .wrapping_add(u16::from_le_bytes(b))
                .to_le_bytes()
        }),
        4 => add_each(row, stride, |a, b| {
            u32::from_le_bytes(a)
                .wrapping_add(u32::from_le_bytes(b))
                .to_le_bytes()
        }),
        _ => add_each(row, stride, |a, b| {
            u64::from_le_bytes(a)
                .wrapping_add(u64::from_le_bytes(b))
                .to_le_bytes()
        }),
    }
}

fn add_each<const N: usize>(
    row: &mut [u8],
    stride: usize,
    add: impl Fn([u8; N], [u8; N]) -> [u8; N],
) {
    let (numbers, _) = row.as_chunks_mut::<N>();
    for i in stride..numbers.len() {
        numbers[i] = add(numbers[i], numbers[i - stride]);
    }
}

/// Puts the bytes of each number together, which lie apart by their rank, the highest first.
fn join(row: &mut [u8], bytes: usize) {
    let apart = row.to_vec();
    let count = row.len() / bytes;
    for (i, number) in row.chunks_exact_mut(bytes).enumerate() {
        for (rank, byte) in number.iter_mut().enumerate() {
            *byte = apart[(bytes - 1 - rank) * count + i];
        }
    }
}
