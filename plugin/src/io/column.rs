//! Columns of a save file: values of one type in little-endian bytes, one after the other.
//!
//! [`write_column`] and [`read_column`] are all that a column needs; what it may hold is told to the
//! reader.

use super::SaveError;
use super::codec::invalid;
use crate::crust::{CrustKind, Orogeny};
use bevy::math::Vec3;
use core::fmt::Debug;

/// A value that a column can hold.
pub(super) trait ColumnValue: Copy + Debug {
    /// Bytes of a value.
    const SIZE: usize;

    /// Writes the value into [`Self::SIZE`] bytes.
    fn put(self, bytes: &mut [u8]);

    /// Reads a value from [`Self::SIZE`] bytes; `None` if they stand for no value.
    fn get(bytes: &[u8]) -> Option<Self>;
}

/// The bytes of a column.
pub(super) fn write_column<T: ColumnValue>(column: &[T]) -> Vec<u8> {
    let mut bytes = vec![0; T::SIZE * column.len()];
    for (out, value) in bytes.chunks_exact_mut(T::SIZE).zip(column) {
        value.put(out);
    }
    bytes
}

/// A column of `count` values of which each is `allowed`; `what` they are is said in errors.
pub(super) fn read_column<T: ColumnValue>(
    bytes: &[u8],
    count: usize,
    what: &str,
    allowed: impl Fn(T) -> bool,
) -> Result<Vec<T>, SaveError> {
    if bytes.len() != T::SIZE * count {
        return Err(invalid(format!(
            "the column of {what} has not one entry per sample"
        )));
    }
    let value = |(i, bytes)| match T::get(bytes) {
        Some(value) if allowed(value) => Ok(value),
        Some(value) => Err(invalid(format!("{what} of sample {i} is {value:?}"))),
        None => Err(invalid(format!("unknown {what} of sample {i}"))),
    };
    bytes.chunks_exact(T::SIZE).enumerate().map(value).collect()
}

/// Allows every value of the type.
pub(super) fn any<T>(_: T) -> bool {
    true
}

/// Allows numbers between two limits, and so no NaN.
pub(super) fn between(low: f32, high: f32) -> impl Fn(f32) -> bool {
    move |value| (low..=high).contains(&value)
}

/// Allows vectors that are no longer than a unit, rounding apart.
pub(super) fn within_unit(v: Vec3) -> bool {
    const LONGEST: f32 = 1.001;
    v.to_array().into_iter().all(between(-LONGEST, LONGEST))
}

macro_rules! number_column {
    ($($number:ty),*) => {$(
        impl ColumnValue for $number {
            const SIZE: usize = size_of::<Self>();

            fn put(self, bytes: &mut [u8]) {
                bytes.copy_from_slice(&self.to_le_bytes());
            }

            fn get(bytes: &[u8]) -> Option<Self> {
                Some(Self::from_le_bytes(bytes.try_into().ok()?))
            }
        }
    )*};
}

number_column!(u16, u32, f32);

impl ColumnValue for Vec3 {
    const SIZE: usize = 12;

    fn put(self, bytes: &mut [u8]) {
        for (out, x) in bytes.chunks_exact_mut(4).zip(self.to_array()) {
            x.put(out);
        }
    }

    fn get(bytes: &[u8]) -> Option<Self> {
        let x = f32::get(bytes.get(..4)?)?;
        let y = f32::get(bytes.get(4..8)?)?;
        let z = f32::get(bytes.get(8..)?)?;
        Some(Self::new(x, y, z))
    }
}

macro_rules! enum_column {
    ($($kind:ty),*) => {$(
        impl ColumnValue for $kind {
            const SIZE: usize = 1;

            fn put(self, bytes: &mut [u8]) {
                bytes[0] = self as u8;
            }

            fn get(bytes: &[u8]) -> Option<Self> {
                Self::from_u8(*bytes.first()?)
            }
        }
    )*};
}

enum_column!(CrustKind, Orogeny);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_keep_their_bits() {
        let column = [0.0, -0.0, 1.5e-40, -11.25_f32];
        let read = read_column(&write_column(&column), 4, "x", between(-20.0, 20.0)).unwrap();
        assert_eq!(read.len(), 4);
        assert!((read.iter().zip(column)).all(|(a, b)| a.to_bits() == b.to_bits()));
        let vector = [Vec3::new(0.1, -0.2, 0.3)];
        let read = read_column(&write_column(&vector), 1, "v", within_unit);
        assert_eq!(read.unwrap(), vector);
        let kinds = [CrustKind::Oceanic, CrustKind::Continental];
        assert_eq!(
            read_column(&write_column(&kinds), 2, "k", any),
            Ok(kinds.into())
        );
    }

    #[test]
    fn values_that_are_not_allowed_are_named() {
        let read = |value: f32| read_column(&write_column(&[value]), 1, "x", between(-20.0, 20.0));
        for bad in [f32::NAN, f32::INFINITY, -1e30, 20.1] {
            let error = read(bad).unwrap_err().to_string();
            assert!(error.contains("x of sample 0"), "{error}");
        }
        assert!(
            read_column::<f32>(&[0; 16], 5, "x", any).is_err(),
            "too short"
        );
        let unknown = read_column::<Orogeny>(&[0, 3], 2, "orogeny", any);
        let expected = invalid("unknown orogeny of sample 1".into());
        assert_eq!(unknown, Err(expected));
    }
}
