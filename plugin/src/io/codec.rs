//! Numbers and texts in little-endian bytes. A reader never trusts a count: it is compared with the
//! bytes that are left before anything is allocated.

use super::SaveError;
use bevy::math::{DQuat, DVec3};

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

    /// A text with its length before it.
    pub(super) fn text(&mut self, value: &str) {
        self.u32(value.len() as u32);
        self.0.extend(value.as_bytes());
    }
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

    /// Four letters.
    pub(super) fn tag(&mut self) -> Result<[u8; 4], SaveError> {
        self.array()
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
        // NaN would spread through the planet, infinities through its sums.
        let value = f64::from_le_bytes(self.array()?);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(invalid(format!("a number is {value}")))
        }
    }

    /// A finite number between two limits; `what` it is is said in the error.
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

    /// A text with its length before it.
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

/// The error of content that makes no planet.
pub(super) fn invalid(problem: String) -> SaveError {
    SaveError::Invalid(problem)
}

/// A switch: 0 or 1.
pub(super) fn flag(byte: u8) -> Result<bool, SaveError> {
    match byte {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(invalid(format!("a switch is {byte}"))),
    }
}

/// A vector of unit length, rounding apart; `what` it is is said in the error.
pub(super) fn unit(v: DVec3, what: &str) -> Result<DVec3, SaveError> {
    if (v.length_squared() - 1.0).abs() < 1e-6 {
        Ok(v)
    } else {
        Err(invalid(format!("the {what} has no unit length")))
    }
}

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
        assert_eq!(read.u8(), Ok(7));
        assert_eq!(read.u16(), Ok(65_000));
        assert_eq!(read.u32(), Ok(4_000_000_000));
        assert_eq!(read.u64(), Ok(u64::MAX));
        assert_eq!(read.f64(), Ok(-0.1));
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
}
