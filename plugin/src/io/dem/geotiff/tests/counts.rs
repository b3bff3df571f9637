//! Lengths of blocks that are wrong or missing, and blocks that are left out.

use super::writer::{Image, PLAIN, Values, tiff};
use super::{RasterFile, SideFiles, fields, plain, refusal, short, values, with};
use crate::io::dem::error::DemError;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::{Cursor, Write};

const STRIP: [u16; 2] = [279, 8];
const TILE: [u16; 2] = [325, 1];

/// 16 x 16 numbers in one block, a strip or a tile, that have these counts.
fn file([tag, compression]: [u16; 2], counts: Vec<u64>, block: Vec<u8>) -> Vec<u8> {
    let tags = fields([16, 16], 8, 1, compression);
    let mut tags = with(tags, [(tag, Values::Long(counts))]);
    if tag == TILE[0] {
        tags.retain(|(tag, _)| *tag != 278);
        tags.extend([(322, short(16)), (323, short(16))]);
    }
    plain(tags, block)
}

fn numbers() -> Vec<u8> {
    (0..=255).collect()
}

fn deflated() -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(&numbers()).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn counts_of_plain_blocks_are_computed() {
    let right: Vec<f32> = numbers().into_iter().map(f32::from).collect();
    for tag in [STRIP[0], TILE[0]] {
        for counts in [vec![256], vec![0], vec![], vec![7], vec![99_999]] {
            let bytes = file([tag, 1], counts.clone(), numbers());
            assert_eq!(values(&bytes), Ok(right.clone()), "{tag} {counts:?}");
        }
    }
}

#[test]
fn counts_of_compressed_blocks_are_named_where_they_are_wrong() {
    let block = deflated();
    for (tag, name) in [(STRIP[0], "StripByteCounts"), (TILE[0], "TileByteCounts")] {
        let length = block.len() as u64;
        assert!(values(&file([tag, 8], vec![length], block.clone())).is_ok());
        for counts in [vec![0], vec![], vec![length / 2]] {
            let text = refusal(&file([tag, 8], counts.clone(), block.clone()));
            assert!(text.contains(name), "{counts:?}: {text}");
        }
    }
}

#[test]
fn a_block_without_a_place_and_a_count_is_left_out() {
    for tag in [STRIP[0], TILE[0]] {
        for compression in [1, 8] {
            let bytes = file([tag, compression], vec![0], Vec::new());
            assert_eq!(values(&bytes), Ok(vec![0.0; 256]));
        }
    }
}

/// Blocks that are left out hold as many pixels as they like.
#[test]
fn a_small_file_may_have_many_pixels() {
    let mut fields = fields([60_000, 60_000], 8, 1, 50_000);
    fields.retain(|(tag, _)| *tag != 278);
    fields.extend([(322, short(32_768)), (323, short(32_768))]);
    let blocks = vec![Vec::new(); 4];
    let bytes = tiff(PLAIN, vec![Image { fields, blocks }]);
    let open = RasterFile::open(Cursor::new(&bytes[..]), SideFiles::default(), |_, _| {
        Ok::<(), DemError>(())
    });
    assert_eq!(open.unwrap().size(), [60_000; 2]);
}
