//! Numbers of a map in few bytes, and back to the last bit.
//!
//! The bytes of all numbers are sorted into four planes: all last bytes, then those before them,
//! and so on. In a plane each byte is stored as its difference to the one before. So the slow
//! changes of a map become long runs of equal bytes, which DEFLATE packs well. NaN keeps its bits.

use super::SaveError;
use super::codec::invalid;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

/// Bytes of a number, and planes.
const PLANES: usize = 4;

/// zlib's own default: higher levels take far longer for little.
const LEVEL: u8 = 6;

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

/// The `count` numbers that were packed. A stream that holds more is left after so many: memory
/// goes by what the bytes really hold, at most by `count`.
///
/// # Errors
/// [`SaveError::Invalid`] for bytes that [`pack`] did not make of so many numbers.
pub(super) fn unpack(bytes: &[u8], count: usize) -> Result<Vec<f32>, SaveError> {
    let torn = || invalid(format!("a map of {count} pixels cannot be unpacked"));
    let length = count.checked_mul(PLANES).ok_or_else(torn)?;
    let mut planes = decompress_to_vec_with_limit(bytes, length).map_err(|_| torn())?;
    if planes.len() != length {
        return Err(torn());
    }
    if count == 0 {
        return Ok(Vec::new());
    }
    planes.chunks_exact_mut(count).for_each(sum_up);
    let byte = |plane: usize, i: usize| planes[plane * count + i];
    let value = |i| f32::from_le_bytes([byte(0, i), byte(1, i), byte(2, i), byte(3, i)]);
    Ok((0..count).map(value).collect())
}

/// Makes bytes of their differences.
fn sum_up(plane: &mut [u8]) {
    let mut last = 0_u8;
    for byte in plane {
        last = last.wrapping_add(*byte);
        *byte = last;
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
        for end in 0..packed.len() {
            assert!(unpack(&packed[..end], 1000).is_err(), "{end}");
        }
        assert!(unpack(b"nonsense", 1000).is_err());
    }
}
