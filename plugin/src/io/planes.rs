//! Numbers of a map in few bytes, and back to the last bit.
//!
//! The bytes of all numbers are sorted into four planes: all last bytes, then those before them,
//! and so on. In a plane each byte is stored as its difference to the one before. So the slow
//! changes of a map become long runs of equal bytes, which DEFLATE packs well. NaN keeps its bits.

use super::SaveError;
use super::codec::invalid;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::stream::{InflateState, inflate};
use miniz_oxide::{DataFormat, MZFlush, MZStatus};

/// Bytes of a number, and planes.
const PLANES: usize = 4;

/// zlib's own default: higher levels take far longer for little.
const LEVEL: u8 = 6;

/// DEFLATE makes no more than 1032 bytes of one.
const MOST_DEFLATION: usize = 1040;

/// Bytes that are unpacked at a time.
const CHUNK_BYTES: usize = 1 << 15;

/// Packs numbers.
pub(super) fn pack(values: &[f32]) -> Vec<u8> {
    let mut planes = Vec::with_capacity(PLANES * values.len());
    for plane in 0..PLANES {
        let mut last = 0_u8;
        planes.extend(values.iter().map(|value| {
            let byte = value.to_le_bytes()[plane];
            byte.wrapping_sub(core::mem::replace(&mut last, byte))
        }));
    }
    compress_to_vec(&planes, LEVEL)
}

/// The `count` numbers that were packed. Memory goes by `count`, which the bytes must be able to
/// hold.
///
/// # Errors
/// [`SaveError::Invalid`] for bytes that [`pack`] did not make of so many numbers.
pub(super) fn unpack(bytes: &[u8], count: usize) -> Result<Vec<f32>, SaveError> {
    let torn = || invalid(format!("a map of {count} pixels cannot be unpacked"));
    let length = count.checked_mul(PLANES).ok_or_else(torn)?;
    if length > bytes.len().saturating_mul(MOST_DEFLATION) {
        return Err(torn());
    }
    let mut numbers = NumberPlanes::new(count);
    let mut state = InflateState::new_boxed(DataFormat::Raw);
    let (mut chunk, mut rest) = (vec![0; CHUNK_BYTES], bytes);
    loop {
        let step = inflate(&mut state, rest, &mut chunk, MZFlush::None);
        rest = &rest[step.bytes_consumed..];
        numbers
            .take(&chunk[..step.bytes_written])
            .ok_or_else(torn)?;
        match step.status {
            Ok(MZStatus::Ok) if step.bytes_consumed + step.bytes_written > 0 => {}
            Ok(MZStatus::StreamEnd) => break,
            _ => return Err(torn()),
        }
    }
    numbers.finish().ok_or_else(torn)
}

/// Numbers while their planes come.
struct NumberPlanes {
    bits: Vec<u32>,
    /// Bytes that have come.
    taken: usize,
    /// The last byte of the plane.
    last: u8,
}

impl NumberPlanes {
    fn new(count: usize) -> Self {
        Self {
            bits: vec![0; count],
            taken: 0,
            last: 0,
        }
    }

    /// Takes the next differences; `None` if they are too many.
    fn take(&mut self, differences: &[u8]) -> Option<()> {
        let count = self.bits.len();
        for difference in differences {
            let plane = self.taken.checked_div(count)?;
            let place = self.taken % count;
            if plane == PLANES {
                return None;
            }
            let before = if place == 0 { 0 } else { self.last };
            self.last = before.wrapping_add(*difference);
            self.bits[place] |= u32::from(self.last) << (8 * plane);
            self.taken += 1;
        }
        Some(())
    }

    /// The numbers, if all have come.
    fn finish(self) -> Option<Vec<f32>> {
        let is_whole = self.taken == PLANES * self.bits.len();
        is_whole.then(|| self.bits.into_iter().map(f32::from_bits).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind of number that a map may hold, voids with two payloads, and noise.
    fn numbers() -> Vec<f32> {
        let odd = [
            0.0,
            -0.0,
            1e-40,
            f32::MAX,
            f32::MIN_POSITIVE,
            f32::NAN,
            f32::from_bits(0x7fc0_1234),
        ];
        let noise = (0..5000_u32).map(|i| f32::from_bits(i.wrapping_mul(2_654_435_761)));
        odd.into_iter().chain(noise).collect()
    }

    fn bits(values: &[f32]) -> Vec<u32> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    #[test]
    fn numbers_come_back_to_the_last_bit() {
        let values = numbers();
        let back = unpack(&pack(&values), values.len()).unwrap();
        assert_eq!(bits(&back), bits(&values));
        assert_eq!(unpack(&pack(&[]), 0), Ok(Vec::new()));
    }

    #[test]
    fn smooth_maps_become_small() {
        let smooth: Vec<f32> = (0..100_000).map(|i| (i as f32 * 1e-3).round()).collect();
        assert!(pack(&smooth).len() < 4 * smooth.len() / 100);
    }

    #[test]
    fn streams_of_another_length_and_torn_ones_are_refused() {
        let packed = pack(&[1.5; 1000]);
        for count in [0, 1, 999, 1001, usize::MAX / 8, usize::MAX] {
            assert!(unpack(&packed, count).is_err(), "{count}");
        }
        // A constant map packs as well as any.
        let constant = vec![0.0; 1 << 20];
        assert_eq!(unpack(&pack(&constant), 1 << 20), Ok(constant));
        for end in 0..packed.len() {
            assert!(unpack(&packed[..end], 1000).is_err(), "{end}");
        }
        assert!(unpack(b"nonsense", 1000).is_err());
    }
}
