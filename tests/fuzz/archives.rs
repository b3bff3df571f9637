//! Archives of SRTM's tiles.

use super::elevations::{read, tile};
use flate2::write::{DeflateEncoder, GzEncoder};
use flate2::{Compression, Crc};
use pangaea_tests::fuzz::{Format, fuzz};
use std::fs;
use std::io::Write;

/// The name of the tile in an archive.
const NAME: &[u8] = b"N44W072.hgt";

/// One input in so many is an archive of a whole tile with the damaged bytes in its heights.
const WHOLE: usize = 500;

const WORDS: &[&str] = &[
    "PK\u{1}\u{2}",
    "PK\u{3}\u{4}",
    "PK\u{5}\u{6}",
    "PK\u{6}\u{6}",
    "PK\u{7}\u{8}",
    "\u{1f}",
    "\u{8}\0",
    ".hgt",
    "../",
    "\0\0\0\0",
];

fn gzip(content: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(content).unwrap();
    encoder.finish().unwrap()
}

/// An archive of one file (PKWARE's APPNOTE 6.3): a head, the deflated content, the directory and
/// where that is.
fn zip(content: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(content).unwrap();
    let packed = encoder.finish().unwrap();
    let mut crc = Crc::new();
    crc.update(content);
    let mut about = vec![20, 0, 0, 0, 8, 0, 0, 0, 0, 0];
    for number in [crc.sum(), packed.len() as u32, content.len() as u32] {
        about.extend(number.to_le_bytes());
    }
    about.extend([NAME.len() as u8, 0, 0, 0]);
    let head = [b"PK\x03\x04", &about[..], NAME, &packed].concat();
    let entry = [b"PK\x01\x02\x14\x00", &about[..], &[0; 14], NAME].concat();
    let mut end = b"PK\x05\x06\0\0\0\0\x01\0\x01\0".to_vec();
    for number in [entry.len() as u32, head.len() as u32] {
        end.extend(number.to_le_bytes());
    }
    end.extend([0, 0]);
    [head, entry, end].concat()
}

/// Tries damaged archives. Good ones hold a few heights, which is too few for a tile, and soon read.
fn archives(name: &str, ending: &str, pack: fn(&[u8]) -> Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(format!("N44W072.hgt{ending}"));
    let few: Vec<u8> = (0..200).collect();
    let format = Format {
        name,
        good: vec![pack(&few), pack(&[7; 3000])],
        words: WORDS,
    };
    let mut count = 0;
    fuzz(&format, |bytes| {
        count += 1;
        let is_whole = count % WHOLE == 0;
        let content = if is_whole {
            pack(&tile(bytes))
        } else {
            bytes.to_vec()
        };
        fs::write(&path, content).unwrap();
        read(&path);
    });
}

#[test]
fn damaged_zip_archives_are_refused_or_have_heights() {
    archives("zip archives", ".zip", zip);
}

#[test]
fn damaged_gzip_archives_are_refused_or_have_heights() {
    archives("gzip archives", ".gz", gzip);
}

#[test]
fn whole_archives_are_read() {
    let folder = tempfile::tempdir().unwrap();
    for (ending, pack) in [(".zip", zip as fn(&[u8]) -> Vec<u8>), (".gz", gzip)] {
        let path = folder.path().join(format!("N44W072.hgt{ending}"));
        fs::write(&path, pack(&tile(&[1, 2]))).unwrap();
        bevy_pangaea::io::load_dem(&path).expect("a whole tile");
    }
}
