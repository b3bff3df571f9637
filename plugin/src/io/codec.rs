//! Numbers and texts in little-endian bytes. A reader never trusts a count: it is compared with the
//! bytes that are left before anything is allocated.

use super::save::SaveError;
use bevy::math::{DQuat, DVec3, Vec3};

/// Appends values to a byte vector.
#[derive(Default)]
pub(super) struct Encoder(pub Vec<u8>);

impl Encoder {
    pub(super) fn u8(&mut self, value: u8) {
        self.0.push(value);
    }

    pub(super) fn u16(&mut self, value: u16) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn u32(&mut self, value: u32) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn u64(&mut self, value: u64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn f64(&mut self, value: f64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn dvec3(&mut self, value: DVec3) {
        value.to_array().into_iter().for_each(|x| self.f64(x));
    }

    pub(super) fn dquat(&mut self, value: DQuat) {
        value.to_array().into_iter().for_each(|x| self.f64(x));
    }

    /// A text with its length.
    pub(super) fn text(&mut self, value: &str) {
        self.u32(value.len() as u32);
        self.0.extend(value.as_bytes());
    }
}

/// A column of single numbers.
pub(super) fn floats(column: &[f32]) -> Vec<u8> {
    let mut bytes = vec![0; 4 * column.len()];
    for (out, value) in bytes.chunks_exact_mut(4).zip(column) {
        out.copy_from_slice(&value.to_le_bytes());
    }
    bytes
}

/// A column of vectors, x y z x y z.
pub(super) fn vectors(column: &[Vec3]) -> Vec<u8> {
    let mut bytes = vec![0; 12 * column.len()];
    for (out, value) in bytes.chunks_exact_mut(12).zip(column) {
        for (out, x) in out.chunks_exact_mut(4).zip(value.to_array()) {
            out.copy_from_slice(&x.to_le_bytes());
        }
    }
    bytes
}

/// Takes values from the front of a byte slice.
pub(super) struct Decoder<'a>(pub &'a [u8]);

impl<'a> Decoder<'a> {
    /// The next `n` bytes.
    pub(super) fn take(&mut self, n: usize) -> Result<&'a [u8], SaveError> {
        let (taken, rest) = self.0.split_at_checked(n).ok_or(SaveError::Truncated)?;
        self.0 = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], SaveError> {
        let (taken, rest) = self.0.split_first_chunk().ok_or(SaveError::Truncated)?;
        self.0 = rest;
        Ok(*taken)
    }

    pub(super) fn u8(&mut self) -> Result<u8, SaveError> {
        Ok(u8::from_le_bytes(self.array()?))
    }

    pub(super) fn u16(&mut self) -> Result<u16, SaveError> {
        Ok(u16::from_le_bytes(self.array()?))
    }

    pub(super) fn u32(&mut self) -> Result<u32, SaveError> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    pub(super) fn u64(&mut self) -> Result<u64, SaveError> {
        Ok(u64::from_le_bytes(self.array()?))
    }

    /// A finite number.
    pub(super) fn f64(&mut self) -> Result<f64, SaveError> {
        let value = f64::from_le_bytes(self.array()?);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(invalid(format!("a number is {value}")))
        }
    }

    /// A finite number between two limits.
    pub(super) fn within(&mut self, what: &str, low: f64, high: f64) -> Result<f64, SaveError> {
        let value = self.f64()?;
        if (low..=high).contains(&value) {
            Ok(value)
        } else {
            Err(invalid(format!(
                "{what} = {} is outside of {low}..={high}",
                crate::params::shown(value)
            )))
        }
    }

    pub(super) fn dvec3(&mut self) -> Result<DVec3, SaveError> {
        Ok(DVec3::new(self.f64()?, self.f64()?, self.f64()?))
    }

    pub(super) fn dquat(&mut self) -> Result<DQuat, SaveError> {
        Ok(DQuat::from_xyzw(
            self.f64()?,
            self.f64()?,
            self.f64()?,
            self.f64()?,
        ))
    }

    pub(super) fn text(&mut self) -> Result<&'a str, SaveError> {
        let length = self.u32()? as usize;
        core::str::from_utf8(self.take(length)?).map_err(|_| invalid("a text is no UTF-8".into()))
    }

    /// A count of things that take at least `size` bytes each.
    pub(super) fn count(&mut self, size: usize) -> Result<usize, SaveError> {
        let count = self.u32()? as usize;
        if count
            .checked_mul(size)
            .is_some_and(|bytes| bytes <= self.0.len())
        {
            Ok(count)
        } else {
            Err(SaveError::Truncated)
        }
    }

    /// Nothing may be left.
    pub(super) fn end(&self) -> Result<(), SaveError> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(invalid("a section is too long".into()))
        }
    }
}

pub(super) fn invalid(problem: String) -> SaveError {
    SaveError::Invalid(problem)
}

/// A column of `n` numbers within limits.
pub(super) fn read_floats(
    bytes: &[u8],
    n: usize,
    what: &str,
    (low, high): (f32, f32),
) -> Result<Vec<f32>, SaveError> {
    if bytes.len() != 4 * n {
        return Err(invalid(format!(
            "the column of {what} has the wrong length"
        )));
    }
    let values: Vec<f32> = bytes
        .as_chunks::<4>()
        .0
        .iter()
        .map(|&chunk| f32::from_le_bytes(chunk))
        .collect();
    match values
        .iter()
        .position(|value| !(low..=high).contains(value))
    {
        None => Ok(values),
        Some(i) => Err(invalid(format!("{what} of sample {i} is {}", values[i]))),
    }
}

/// A column of `n` vectors no longer than a unit.
pub(super) fn read_vectors(bytes: &[u8], n: usize, what: &str) -> Result<Vec<Vec3>, SaveError> {
    if bytes.len() != 12 * n {
        return Err(invalid(format!(
            "the column of {what} has the wrong length"
        )));
    }
    let values = read_floats(bytes, 3 * n, what, (-LONGEST, LONGEST))?;
    Ok(values
        .as_chunks::<3>()
        .0
        .iter()
        .map(|&v| Vec3::from_array(v))
        .collect())
}

/// Unit vectors may be so long after rounding.
const LONGEST: f32 = 1.001;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let mut out = Encoder::default();
        out.u8(7);
        out.u16(65_000);
        out.u32(4_000_000_000);
        out.u64(u64::MAX);
        out.f64(-0.1);
        out.dvec3(DVec3::new(1.0, 2.0, 3.0));
        out.dquat(DQuat::from_xyzw(0.0, 0.6, 0.0, 0.8));
        out.text("Pangäa");
        let mut read = Decoder(&out.0);
        assert_eq!(
            (read.u8(), read.u16(), read.u32()),
            (Ok(7), Ok(65_000), Ok(4_000_000_000))
        );
        assert_eq!((read.u64(), read.f64()), (Ok(u64::MAX), Ok(-0.1)));
        assert_eq!(read.dvec3(), Ok(DVec3::new(1.0, 2.0, 3.0)));
        assert_eq!(read.dquat(), Ok(DQuat::from_xyzw(0.0, 0.6, 0.0, 0.8)));
        assert_eq!(read.text(), Ok("Pangäa"));
        assert_eq!(read.end(), Ok(()));
        assert_eq!(read.u8(), Err(SaveError::Truncated));
    }

    #[test]
    fn counts_beyond_the_end_are_refused() {
        let bytes = [255, 255, 255, 255, 0, 0];
        assert_eq!(Decoder(&bytes).count(1), Err(SaveError::Truncated));
        assert_eq!(Decoder(&bytes).text(), Err(SaveError::Truncated));
        assert_eq!(Decoder(&[2, 0, 0, 0, 9, 9]).count(1), Ok(2));
    }

    #[test]
    fn columns_keep_their_bits_and_refuse_what_is_no_number() {
        let column = [0.0, -0.0, 1.5e-40, -11.25];
        let read = read_floats(&floats(&column), 4, "x", (-20.0, 20.0)).unwrap();
        assert!(
            read.iter()
                .zip(column)
                .all(|(a, b)| a.to_bits() == b.to_bits())
        );
        for bad in [f32::NAN, f32::INFINITY, -1e30, 20.1] {
            assert!(read_floats(&floats(&[bad]), 1, "x", (-20.0, 20.0)).is_err());
        }
        assert!(read_floats(&floats(&column), 5, "x", (-20.0, 20.0)).is_err());
        let vector = [Vec3::new(0.1, -0.2, 0.3)];
        assert_eq!(read_vectors(&vectors(&vector), 1, "v").unwrap(), vector);
    }
}
