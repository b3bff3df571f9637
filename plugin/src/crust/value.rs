//! Values that a column can hold, and how files store columns: values of one type in little-endian
//! bytes, one after the other.

use super::kinds::{CrustKind, Orogeny};
use bevy::math::Vec3;
use core::ops::RangeInclusive;
use thiserror::Error;

/// A type of column: little-endian bytes of fixed length, and what a value shows in a message.
pub trait ColumnValue: Copy + PartialEq + Send + Sync + 'static {
    /// Bytes of a value, in memory and in files.
    const BYTES: usize;

    /// Stores the value in exactly [`BYTES`](Self::BYTES) bytes.
    fn encode(self, bytes: &mut [u8]);

    /// The value that `bytes` hold, exactly [`BYTES`](Self::BYTES) of them; `None` if they are
    /// no valid value.
    fn decode(bytes: &[u8]) -> Option<Self>;

    /// The first component that is NaN or outside of the limits.
    fn outside(&self, min: f32, max: f32) -> Option<f32>;
}

macro_rules! numbers {
    ($($number:ty),+) => { $(
        impl ColumnValue for $number {
            const BYTES: usize = size_of::<Self>();

            fn encode(self, bytes: &mut [u8]) {
                bytes.copy_from_slice(&self.to_le_bytes());
            }

            fn decode(bytes: &[u8]) -> Option<Self> {
                Some(Self::from_le_bytes(bytes.try_into().ok()?))
            }

            fn outside(&self, min: f32, max: f32) -> Option<f32> {
                let value = *self as f32;
                // Written so that NaN is outside of any limits.
                let within = value >= min && value <= max;
                (!within).then_some(value)
            }
        }
    )+ };
}

numbers!(u16, u32, f32);

impl ColumnValue for Vec3 {
    const BYTES: usize = 12;

    fn encode(self, bytes: &mut [u8]) {
        for (bytes, x) in bytes.chunks_exact_mut(4).zip(self.to_array()) {
            x.encode(bytes);
        }
    }

    fn decode(bytes: &[u8]) -> Option<Self> {
        let [x, y, z]: &[[u8; 4]; 3] = bytes.as_chunks::<4>().0.try_into().ok()?;
        Some(Self::new(
            f32::from_le_bytes(*x),
            f32::from_le_bytes(*y),
            f32::from_le_bytes(*z),
        ))
    }

    fn outside(&self, min: f32, max: f32) -> Option<f32> {
        self.to_array().iter().find_map(|x| x.outside(min, max))
    }
}

macro_rules! one_byte {
    ($($kind:ty),+) => { $(
        impl ColumnValue for $kind {
            const BYTES: usize = 1;

            fn encode(self, bytes: &mut [u8]) {
                bytes[0] = self as u8;
            }

            fn decode(bytes: &[u8]) -> Option<Self> {
                Self::from_u8(*bytes.first()?)
            }

            fn outside(&self, _: f32, _: f32) -> Option<f32> {
                None
            }
        }
    )+ };
}

one_byte!(CrustKind, Orogeny);

/// Why a stored column was refused.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ColumnError {
    /// There are more columns or fewer than the crust has.
    #[error("{found} columns of crust instead of {expected}")]
    Count {
        /// Columns that were found.
        found: usize,
        /// Columns that the crust has.
        expected: usize,
    },
    /// A column without which the crust cannot be is not there.
    #[error("the column of {0} is missing")]
    Missing(&'static str),
    /// The column has not one entry per sample.
    #[error("the column of {0} has the wrong length")]
    Length(&'static str),
    /// The bytes of a sample are no value of the column.
    #[error("unknown {label} of sample {sample}")]
    Unknown {
        /// Name of the column in messages.
        label: &'static str,
        /// The sample.
        sample: usize,
    },
    /// The value of a sample is NaN or outside of the limits.
    #[error("{label} of sample {sample} is {value}")]
    OutOfRange {
        /// Name of the column in messages.
        label: &'static str,
        /// The sample.
        sample: usize,
        /// The refused value.
        value: f32,
    },
}

/// The bytes of a column.
pub fn encode_column<T: ColumnValue>(column: &[T]) -> Vec<u8> {
    let mut bytes = vec![0; T::BYTES * column.len()];
    for (bytes, value) in bytes.chunks_exact_mut(T::BYTES).zip(column) {
        value.encode(bytes);
    }
    bytes
}

/// The column of `n` values within `limits` that `bytes` hold; `label` names it in errors.
///
/// # Errors
/// [`ColumnError`] names the first sample whose value is refused.
pub fn decode_column<T: ColumnValue>(
    bytes: &[u8],
    n: usize,
    label: &'static str,
    limits: RangeInclusive<f32>,
) -> Result<Vec<T>, ColumnError> {
    if bytes.len() != T::BYTES * n {
        return Err(ColumnError::Length(label));
    }
    bytes
        .chunks_exact(T::BYTES)
        .enumerate()
        .map(|(sample, bytes)| decode_value(bytes, sample, label, &limits))
        .collect()
}

fn decode_value<T: ColumnValue>(
    bytes: &[u8],
    sample: usize,
    label: &'static str,
    limits: &RangeInclusive<f32>,
) -> Result<T, ColumnError> {
    let value = T::decode(bytes).ok_or(ColumnError::Unknown { label, sample })?;
    match value.outside(*limits.start(), *limits.end()) {
        None => Ok(value),
        Some(value) => Err(ColumnError::OutOfRange {
            label,
            sample,
            value,
        }),
    }
}
