//! Types of samples: whole numbers with and without sign, and IEEE's floating-point numbers.

use super::structure::{Directory, TiffFile, unsupported};
use super::tag;
use crate::io::dem::error::DemError;
use half::f16;
use std::io::{Read, Seek};

/// The type of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SampleType {
    pub(super) kind: NumberKind,
    pub(super) bits: u32,
}

/// Kinds of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NumberKind {
    /// Whole, at least 0; from 1 to 32 or 64 bits.
    Unsigned,
    /// Whole; 8, 16, 32 or 64 bits.
    Signed,
    /// Floating-point; 16, 32 or 64 bits.
    Float,
}

/// Converts samples of a type of Rust's.
macro_rules! each {
    ($number:ty, $samples:expr, $numbers:expr) => {
        convert($samples, $numbers, |bytes| {
            <$number>::from_le_bytes(bytes) as f64
        })
    };
}

impl SampleType {
    /// The type of an image's samples, which must be one.
    pub(super) fn read<R: Read + Seek>(
        file: &TiffFile<R>,
        directory: &Directory,
    ) -> Result<Self, DemError> {
        let all = file.numbers(directory, tag::BITS_PER_SAMPLE)?;
        let bits = *all.first().unwrap_or(&1);
        if all.iter().any(|&other| other != bits) {
            return Err(unsupported(tag::BITS_PER_SAMPLE, "of several kinds"));
        }
        let all = file.numbers(directory, tag::SAMPLE_FORMAT)?;
        let format = *all.first().unwrap_or(&1);
        if all.iter().any(|&other| other != format) {
            return Err(unsupported(tag::SAMPLE_FORMAT, "of several kinds"));
        }
        let kind = match (format, bits) {
            (1 | 4, 1..=32 | 64) => NumberKind::Unsigned,
            (2, 8 | 16 | 32 | 64) => NumberKind::Signed,
            (3, 16 | 32 | 64) => NumberKind::Float,
            (1..=4, _) => return Err(unsupported(tag::BITS_PER_SAMPLE, bits)),
            // Complex numbers.
            _ => return Err(unsupported(tag::SAMPLE_FORMAT, format)),
        };
        Ok(Self {
            kind,
            bits: bits as u32,
        })
    }

    /// Bytes of a sample that has whole ones.
    pub(super) fn bytes(self) -> Option<usize> {
        matches!(self.bits, 8 | 16 | 32 | 64).then_some(self.bits as usize / 8)
    }

    /// The numbers of one sample of every pixel in a row whose bytes begin with the least of a
    /// number: sample `first` of each `stride`.
    pub(super) fn decode(self, row: &[u8], stride: usize, first: usize, numbers: &mut [f64]) {
        use NumberKind::{Float, Signed, Unsigned};
        let samples = (row, stride, first);
        match (self.kind, self.bits) {
            (Unsigned, 8) => each!(u8, samples, numbers),
            (Signed, 8) => each!(i8, samples, numbers),
            (Unsigned, 16) => each!(u16, samples, numbers),
            (Signed, 16) => each!(i16, samples, numbers),
            (Unsigned, 32) => each!(u32, samples, numbers),
            (Signed, 32) => each!(i32, samples, numbers),
            (Unsigned, 64) => each!(u64, samples, numbers),
            (Signed, 64) => each!(i64, samples, numbers),
            (Float, 16) => convert(samples, numbers, |bytes| f16::from_le_bytes(bytes).to_f64()),
            (Float, 32) => each!(f32, samples, numbers),
            (Float, _) => each!(f64, samples, numbers),
            _ => self.unpack(row, stride, first, numbers),
        }
    }

    /// The numbers of samples that share bytes, which begin with the highest bit.
    fn unpack(self, row: &[u8], stride: usize, first: usize, numbers: &mut [f64]) {
        let bits = self.bits as usize;
        for (x, number) in numbers.iter_mut().enumerate() {
            let start = (x * stride + first) * bits;
            let places = start..start + bits;
            *number = places.fold(0, |n: u64, place| n << 1 | bit(row, place)) as f64;
        }
    }
}

/// The bit at a place of a row.
fn bit(row: &[u8], place: usize) -> u64 {
    let byte = row.get(place / 8).copied().unwrap_or(0);
    u64::from(byte >> (7 - place % 8) & 1)
}

/// Converts sample `first` of each `stride` of `N` bytes.
fn convert<const N: usize>(
    (row, stride, first): (&[u8], usize, usize),
    numbers: &mut [f64],
    convert: impl Fn([u8; N]) -> f64,
) {
    let (samples, _) = row.as_chunks::<N>();
    let samples = samples.iter().skip(first).step_by(stride);
    for (number, &bytes) in numbers.iter_mut().zip(samples) {
        *number = convert(bytes);
    }
}
