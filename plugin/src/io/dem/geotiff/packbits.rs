//! PackBits (TIFF 6.0, section 9): runs of equal bytes, and of others.

use std::io::{BufRead, Read, Result};

/// Decompresses while it is read.
pub(super) struct PackBitsReader<R> {
    source: R,
    /// Bytes that are left of the run.
    left: usize,
    /// The byte of a run of equal ones.
    equal: Option<u8>,
}

impl<R: BufRead> PackBitsReader<R> {
    pub(super) fn new(source: R) -> Self {
        Self {
            source,
            left: 0,
            equal: None,
        }
    }

    /// Begins the next run; `false` at the end.
    fn begin(&mut self) -> Result<bool> {
        let Some(head) = self.byte()? else {
            return Ok(false);
        };
        match head as i8 {
            // Nothing.
            i8::MIN => {}
            head @ 0.. => {
                self.left = head as usize + 1;
                self.equal = None;
            }
            head => {
                self.equal = self.byte()?;
                self.left = self.equal.map_or(0, |_| 1 - isize::from(head)) as usize;
            }
        }
        Ok(true)
    }

    fn byte(&mut self) -> Result<Option<u8>> {
        let byte = self.source.fill_buf()?.first().copied();
        self.source.consume(usize::from(byte.is_some()));
        Ok(byte)
    }
}

impl<R: BufRead> Read for PackBitsReader<R> {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize> {
        while self.left == 0 {
            if !self.begin()? {
                return Ok(0);
            }
        }
        let count = bytes.len().min(self.left);
        let bytes = &mut bytes[..count];
        let count = match self.equal {
            Some(byte) => {
                bytes.fill(byte);
                count
            }
            None => self.source.read(bytes)?,
        };
        self.left -= count;
        Ok(count)
    }
}
