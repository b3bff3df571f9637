//! LERC (Esri's Limited Error Raster Compression): a block is a blob with a type of its own.

use super::sample::{NumberKind, SampleType};
use crate::io::dem::error::{DemError, invalid};
use lerc_core::PixelData;
use std::io::Read;

/// Most bytes of a blob: no block of 512 MiB of samples, which is the decoder's limit, has more.
const MAX_BLOB: u64 = 1 << 29;

/// A blob's bytes, as far as there may be any.
pub(super) fn limited(bytes: impl Read) -> impl Read {
    bytes.take(MAX_BLOB)
}

/// The samples of a blob, each from its least byte; NaN where floating-point ones are masked.
pub(super) fn samples(blob: &[u8], sample_type: SampleType) -> Result<Vec<u8>, DemError> {
    let decoded = lerc_reader::decode_first(blob)
        .map_err(|error| invalid(format!("a damaged block: {error}")))?;
    if sample_type != type_of(&decoded.pixels) {
        return Err(invalid("a block of LERC has samples of another type"));
    }
    let mask = decoded.mask.unwrap_or_default();
    Ok(match decoded.pixels {
        PixelData::I8(samples) => bytes(&samples, |z| z.to_le_bytes()),
        PixelData::U8(samples) => samples,
        PixelData::I16(samples) => bytes(&samples, |z| z.to_le_bytes()),
        PixelData::U16(samples) => bytes(&samples, |z| z.to_le_bytes()),
        PixelData::I32(samples) => bytes(&samples, |z| z.to_le_bytes()),
        PixelData::U32(samples) => bytes(&samples, |z| z.to_le_bytes()),
        PixelData::F32(mut samples) => {
            erase(&mut samples, &mask, f32::NAN);
            bytes(&samples, |z| z.to_le_bytes())
        }
        PixelData::F64(mut samples) => {
            erase(&mut samples, &mask, f64::NAN);
            bytes(&samples, |z| z.to_le_bytes())
        }
    })
}

fn type_of(pixels: &PixelData) -> SampleType {
    let (kind, bits) = match pixels {
        PixelData::I8(_) => (NumberKind::Signed, 8),
        PixelData::U8(_) => (NumberKind::Unsigned, 8),
        PixelData::I16(_) => (NumberKind::Signed, 16),
        PixelData::U16(_) => (NumberKind::Unsigned, 16),
        PixelData::I32(_) => (NumberKind::Signed, 32),
        PixelData::U32(_) => (NumberKind::Unsigned, 32),
        PixelData::F32(_) => (NumberKind::Float, 32),
        PixelData::F64(_) => (NumberKind::Float, 64),
    };
    SampleType { kind, bits }
}

fn bytes<T: Copy, const N: usize>(samples: &[T], convert: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    samples.iter().flat_map(|&sample| convert(sample)).collect()
}

/// Writes `void` where the mask is 0. All samples of a pixel share its mask.
fn erase<T: Copy>(samples: &mut [T], mask: &[u8], void: T) {
    let stride = samples.len() / mask.len().max(1);
    for (pixel, _) in mask.iter().enumerate().filter(|(_, valid)| **valid == 0) {
        samples[pixel * stride..][..stride].fill(void);
    }
}
