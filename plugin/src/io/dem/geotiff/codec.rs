//! Compressions of blocks: none, LZW, Deflate under both of its numbers, PackBits, Zstandard and
//! LERC. A block is a stream of rows: one of any size takes the memory of a row (LERC's: its own).

use super::lerc;
use super::lzw;
use super::packbits::PackBitsReader;
use super::predictor::Predictor;
use super::sample::SampleType;
use super::structure::{ByteOrder, Directory, TiffFile, cut_short, refused, unsupported};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use flate2::bufread::ZlibDecoder;
use ruzstd::decoding::StreamingDecoder;
use std::io::{BufRead, Cursor, ErrorKind, Read, Seek};

/// How blocks become samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Codec {
    compression: Compression,
    predictor: Predictor,
}

/// Compressions that are read.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Compression {
    None,
    Lzw,
    Deflate,
    PackBits,
    Zstd,
    Lerc(LercWrapping),
}

/// The compression of LERC's bytes, by the second number of LercParameters.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LercWrapping {
    None,
    Deflate,
    Zstd,
}

impl Compression {
    /// The compression of a number.
    fn of(number: u64, lerc: Option<&u64>) -> Result<Self, DemError> {
        let named = |name: &str| Err(unsupported(tag::COMPRESSION, format!("{number} ({name})")));
        match number {
            1 => Ok(Self::None),
            5 => Ok(Self::Lzw),
            8 | 32_946 => Ok(Self::Deflate),
            32_773 => Ok(Self::PackBits),
            50_000 => Ok(Self::Zstd),
            34_887 => match lerc {
                None | Some(0) => Ok(Self::Lerc(LercWrapping::None)),
                Some(1) => Ok(Self::Lerc(LercWrapping::Deflate)),
                Some(2) => Ok(Self::Lerc(LercWrapping::Zstd)),
                Some(_) => Err(refused(tag::LERC_PARAMETERS)),
            },
            2..=4 => named("CCITT"),
            6 | 7 => named("JPEG"),
            34_712 => named("JPEG 2000"),
            34_925 => named("LZMA"),
            50_001 => named("WebP"),
            50_002 | 52_546 => named("JPEG XL"),
            _ => Err(unsupported(tag::COMPRESSION, number)),
        }
    }
}

impl Codec {
    /// The codec of an image.
    pub(super) fn read<R: Read + Seek>(
        file: &TiffFile<R>,
        directory: &Directory,
        sample_type: SampleType,
    ) -> Result<Self, DemError> {
        let number = file.number_or(directory, tag::COMPRESSION, 1)?;
        let lerc = file.numbers(directory, tag::LERC_PARAMETERS)?;
        let compression = Compression::of(number, lerc.get(1))?;
        let predictor = match compression {
            Compression::Lzw | Compression::Deflate | Compression::Zstd => {
                let number = file.number_or(directory, tag::PREDICTOR, 1)?;
                Predictor::of(number, sample_type)?
            }
            // The others know none, whatever the tag says.
            _ => Predictor::None,
        };
        Ok(Self {
            compression,
            predictor,
        })
    }

    /// Do blocks hold samples as they are?
    pub(super) fn is_plain(self) -> bool {
        self.compression == Compression::None
    }

    /// The rows of a block of that many bytes, compressed as they come.
    pub(super) fn rows<'a>(
        self,
        block: impl BufRead + 'a,
        order: ByteOrder,
        sample_type: SampleType,
    ) -> Result<BlockRows<'a>, DemError> {
        let source: Box<dyn Read + 'a> = match self.compression {
            Compression::None => Box::new(block),
            Compression::Lzw => Box::new(lzw::decompress(block)),
            Compression::Deflate => Box::new(ZlibDecoder::new(block)),
            Compression::PackBits => Box::new(PackBitsReader::new(block)),
            Compression::Zstd => Box::new(zstd(block)?),
            // Libtiff swaps bytes before it compresses them, as if LERC took bytes and no numbers.
            Compression::Lerc(wrapping) => {
                let bytes = unwrap_lerc(wrapping, block)?;
                Box::new(Cursor::new(lerc::samples(&bytes, sample_type)?))
            }
        };
        Ok(BlockRows {
            source,
            order,
            sample_type,
            predictor: self.predictor,
        })
    }
}

fn zstd<R: Read>(block: R) -> Result<impl Read, DemError> {
    StreamingDecoder::new(block).map_err(|error| invalid(format!("a damaged block: {error}")))
}

/// The bytes of a block of LERC.
fn unwrap_lerc(wrapping: LercWrapping, block: impl BufRead) -> Result<Vec<u8>, DemError> {
    let mut bytes = Vec::new();
    match wrapping {
        LercWrapping::None => {
            let mut block = block;
            block.read_to_end(&mut bytes)
        }
        LercWrapping::Deflate => lerc::limited(ZlibDecoder::new(block)).read_to_end(&mut bytes),
        LercWrapping::Zstd => lerc::limited(zstd(block)?).read_to_end(&mut bytes),
    }
    .map_err(damaged)?;
    Ok(bytes)
}

/// The rows of a block.
pub(super) struct BlockRows<'a> {
    source: Box<dyn Read + 'a>,
    order: ByteOrder,
    sample_type: SampleType,
    predictor: Predictor,
}

impl BlockRows<'_> {
    /// Reads the next row of `stride` samples a pixel; its numbers begin with their least byte.
    pub(super) fn next(&mut self, row: &mut [u8], stride: usize) -> Result<(), DemError> {
        self.source.read_exact(row).map_err(damaged)?;
        let bytes = self.sample_type.bytes().unwrap_or(1);
        // The bytes of predicted floating-point numbers have an order of their own.
        if self.order == ByteOrder::Big && self.predictor != Predictor::Float {
            row.chunks_exact_mut(bytes).for_each(<[u8]>::reverse);
        }
        self.predictor.undo(row, bytes, stride);
        Ok(())
    }
}

fn damaged(error: std::io::Error) -> DemError {
    match error.kind() {
        ErrorKind::UnexpectedEof => cut_short(),
        _ => invalid(format!("a damaged block: {error}")),
    }
}
