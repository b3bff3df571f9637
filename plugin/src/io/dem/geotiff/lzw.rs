//! LZW as TIFF has it (TIFF 6.0, section 13): most significant bit first, codes that grow one code
//! early.
//!
//! Libtiff ends a block where its rows end: files without a code for the end, or with other bytes
//! behind it, are common. So bytes are given out as long as there are codes.

use std::io::{BufRead, Error, ErrorKind, Read, Result};
use weezl::decode::{Configuration, Decoder};
use weezl::{BitOrder, LzwStatus};

/// Decompresses while it is read.
pub(super) struct LzwReader<R> {
    source: R,
    decoder: Decoder,
}

impl<R: BufRead> LzwReader<R> {
    pub(super) fn new(source: R) -> Self {
        let decoder = Configuration::with_tiff_size_switch(BitOrder::Msb, 8)
            .with_yield_on_full_buffer(true)
            .build();
        Self { source, decoder }
    }
}

impl<R: BufRead> Read for LzwReader<R> {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize> {
        loop {
            let input = self.source.fill_buf()?;
            let is_over = input.is_empty();
            let step = self.decoder.decode_bytes(input, bytes);
            self.source.consume(step.consumed_in);
            if step.consumed_out > 0 || bytes.is_empty() {
                return Ok(step.consumed_out);
            }
            match step.status {
                Ok(LzwStatus::Done) => return Ok(0),
                Ok(_) if is_over => return Ok(0),
                Ok(_) => {}
                Err(error) => return Err(Error::new(ErrorKind::InvalidData, error)),
            }
        }
    }
}
