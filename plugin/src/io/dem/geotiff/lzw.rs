//! LZW as TIFF has it (TIFF 6.0, section 13): most significant bit first, codes that grow one code
//! early.
//!
//! Libtiff ends a block where its rows end: files without a code for the end, or with other bytes
//! behind it, are common. So bytes are given out as long as there are codes.

use std::io::{BufRead, BufReader, Error, ErrorKind, Read, Result};
use weezl::decode::{Configuration, Decoder};
use weezl::{BitOrder, LzwStatus};

/// Bytes that are asked for at once. Of the decoder's answer to a request for less than the longest
/// word, of 4096 bytes, one cannot tell whether it is at the end.
const AT_ONCE: usize = 1 << 16;

/// Decompresses a block while it is read.
pub(super) fn decompress(block: impl BufRead) -> impl Read {
    let decoder = Configuration::with_tiff_size_switch(BitOrder::Msb, 8)
        .with_yield_on_full_buffer(true)
        .build();
    let words = LzwReader {
        source: block,
        decoder,
    };
    BufReader::with_capacity(AT_ONCE, words)
}

/// Gives out bytes for requests of at least [`AT_ONCE`].
struct LzwReader<R> {
    source: R,
    decoder: Decoder,
}

impl<R: BufRead> Read for LzwReader<R> {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize> {
        loop {
            let input = self.source.fill_buf()?;
            let step = self.decoder.decode_bytes(input, bytes);
            self.source.consume(step.consumed_in);
            if step.consumed_out > 0 || bytes.is_empty() {
                return Ok(step.consumed_out);
            }
            match step.status {
                Ok(LzwStatus::Done) => return Ok(0),
                Ok(LzwStatus::NoProgress) if step.consumed_in == 0 => return Ok(0),
                // A code that clears the table gives no bytes; others may be waiting behind it.
                Ok(_) => {}
                Err(error) => return Err(Error::new(ErrorKind::InvalidData, error)),
            }
        }
    }
}
