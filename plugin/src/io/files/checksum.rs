//! The BLAKE3 hash of a file as it was written, by which a change is noticed.

use blake3::Hasher;
use std::fs::File;
use std::io::{self, Read};
#[cfg(feature = "export")]
use std::io::{BufWriter, Write};
use std::path::Path;

/// Bytes that are hashed together: the hash is slow with few at a time.
const BLOCK: usize = 1 << 16;

/// Writes, and hashes what it writes.
#[cfg(feature = "export")]
struct HashedWriter<'a> {
    out: &'a mut dyn Write,
    hasher: Hasher,
}

#[cfg(feature = "export")]
impl Write for HashedWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.out.write(bytes)?;
        self.hasher.update(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Writes content to `out`; returns its hash in hexadecimal digits.
#[cfg(feature = "export")]
pub(in crate::io) fn write_hashed(
    out: &mut dyn Write,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<String> {
    let hasher = Hasher::new();
    let mut writer = BufWriter::with_capacity(BLOCK, HashedWriter { out, hasher });
    content(&mut writer)?;
    let written = writer
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    Ok(written.hasher.finalize().to_hex().to_string())
}

/// The hash of a file in hexadecimal digits.
pub(super) fn hash_of(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let mut hasher = Hasher::new();
    let mut block = vec![0; BLOCK];
    loop {
        match file.read(&mut block)? {
            0 => return Ok(hasher.finalize().to_hex().to_string()),
            count => hasher.update(&block[..count]),
        };
    }
}
