//! Archives of one .hgt file, as SRTM's are given out: NAME.hgt.zip and NAME.hgt.gz.

use super::error::{DemError, invalid};
use super::file::extension;
use super::hgt;
use super::tile::Dem;
use flate2::bufread::{DeflateDecoder, GzDecoder};
use rawzip::{CompressionMethod, ZipArchive};
use std::io::{self, Read};
use std::path::Path;

/// Most bytes of an archive, and of the file in it: more than those of any .hgt.
pub(super) const MOST_BYTES: u64 = 1 << 27;

/// Reads the .hgt file in an archive of this name.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Dem, DemError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if extension(path).as_deref() == Some("gz") {
        gzip(&name, bytes)
    } else {
        zipped(&name, bytes)
    }
}

fn zipped(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
    let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
    let mut models = Vec::new();
    for entry in archive.entries() {
        let entry = entry.map_err(damaged)?;
        let own = String::from_utf8_lossy(entry.file_path().as_ref()).into_owned();
        if is_model(&own) {
            models.push((own, entry.compression_method(), entry.wayfinder()));
        }
    }
    let [(own, method, place)] = models.as_slice() else {
        return Err(DemError::ArchiveContent(models.len()));
    };
    let entry = archive.get_entry(*place).map_err(damaged)?;
    let unpacked: Box<dyn Read> = match *method {
        CompressionMethod::STORE => Box::new(entry.data()),
        CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(entry.data())),
        _ => {
            return Err(invalid(
                "the archive is packed by a method that is not read",
            ));
        }
    };
    // The file's own name knows best.
    let name = if hgt::is_name(own) { own } else { name };
    let checked = entry.verifying_reader(unpacked);
    hgt::read(name, place.uncompressed_size_hint(), checked)
}

/// Is it the name of a model? Macs put a `._NAME` into an archive for every NAME.
fn is_model(name: &str) -> bool {
    let path = Path::new(name);
    let file = path.file_name().unwrap_or_default();
    let is_hidden = file.to_string_lossy().starts_with('.');
    extension(path).as_deref() == Some("hgt") && !is_hidden
}

/// The length stands at the end, if at all: it is counted first.
fn gzip(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
    let mut unpacked = GzDecoder::new(bytes).take(MOST_BYTES);
    let length = io::copy(&mut unpacked, &mut io::sink()).map_err(damaged)?;
    hgt::read(name, length, GzDecoder::new(bytes))
}

fn damaged(error: impl core::fmt::Display) -> DemError {
    invalid(format!("a damaged archive: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::{DeflateEncoder, GzEncoder};
    use std::io::Write;

    /// A tile of 1201 x 1201 heights of 300 m.
    fn tile() -> Vec<u8> {
        [1, 44].repeat(1201 * 1201)
    }

    /// An archive (PKWARE's APPNOTE 6.3): for each file a head and its deflated content, then the
    /// directory and its end.
    fn zip_of(files: &[(&str, &[u8])]) -> Vec<u8> {
        let (mut bytes, mut directory) = (Vec::new(), Vec::new());
        for (name, content) in files {
            let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
            encoder.write_all(content).unwrap();
            let packed = encoder.finish().unwrap();
            let mut sum = flate2::Crc::new();
            sum.update(content);
            let mut facts = [20_u16, 0, 8, 0, 0].map(u16::to_le_bytes).concat();
            for number in [sum.sum(), packed.len() as u32, content.len() as u32] {
                facts.extend(number.to_le_bytes());
            }
            facts.extend((name.len() as u32).to_le_bytes());
            directory.extend(b"PK\x01\x02\x14\x00");
            directory.extend(&facts);
            directory.extend([0; 10]);
            directory.extend((bytes.len() as u32).to_le_bytes());
            directory.extend(name.as_bytes());
            bytes.extend(b"PK\x03\x04");
            bytes.extend(&facts);
            bytes.extend(name.as_bytes());
            bytes.extend(packed);
        }
        let count = (files.len() as u16).to_le_bytes();
        let start = (bytes.len() as u32).to_le_bytes();
        let length = (directory.len() as u32).to_le_bytes();
        bytes.extend(&directory);
        let end = [
            b"PK\x05\x06\0\0\0\0",
            &count[..],
            &count,
            &length,
            &start,
            &[0; 2],
        ];
        bytes.extend(end.concat());
        bytes
    }

    fn read_named(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
        read(Path::new(name), bytes)
    }

    #[test]
    fn the_model_in_an_archive_is_read() {
        let tile = tile();
        let notes: (&str, &[u8]) = ("__MACOSX/._N44W072.hgt", b"Mac OS X");
        let archive = zip_of(&[("readme.txt", b"x"), notes, ("N44W072.hgt", &tile)]);
        let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(&tile).unwrap();
        let gzip = encoder.finish().unwrap();
        for (name, bytes) in [
            ("N44W072.SRTMGL1.hgt.zip", &archive),
            ("a.hgt.zip", &archive),
            ("N44W072.hgt.gz", &gzip),
        ] {
            let dem = read_named(name, bytes).unwrap();
            assert_eq!(dem.centre, Some((44.5, -71.5)), "{name}");
            assert_eq!(dem.grid.range(), Some([300.0; 2]), "{name}");
        }
    }

    #[test]
    fn archives_of_none_or_several_and_torn_ones_are_refused() {
        let tile = tile();
        let twice = zip_of(&[("N44W072.hgt", &tile), ("N45W072.hgt", &tile)]);
        let refused = |bytes: &[u8]| read_named("N44W072.hgt.zip", bytes).unwrap_err();
        assert_eq!(refused(&twice), DemError::ArchiveContent(2));
        assert_eq!(refused(&zip_of(&[])), DemError::ArchiveContent(0));
        let one = zip_of(&[("N44W072.hgt", &tile)]);
        for bytes in [&one[..one.len() / 2], b"PK"] {
            assert!(refused(bytes).to_string().contains("damaged archive"));
        }
        let cut = read_named("N44W072.hgt.gz", &[31, 139, 8]);
        assert!(cut.unwrap_err().to_string().contains("damaged archive"));
    }
}
