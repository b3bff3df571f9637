//! OpenEXR (Academy Software Foundation, "OpenEXR File Layout", version 2): one channel `Y` of f32
//! in m, in scan lines, uncompressed. Readers show a single channel of this name as grey.

use super::encoding::Encoding;
use std::io::{self, Write};

/// Magic number and version 2 without flags: scan lines in a single part.
const START: [u8; 8] = [0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];

/// The file of a grid.
pub(super) fn write(source: &Encoding, out: &mut dyn Write) -> io::Result<()> {
    let (columns, rows) = (source.grid.columns(), source.grid.rows());
    let header = header(columns, rows);
    out.write_all(&header)?;
    out.write_all(&offsets(header.len(), columns, rows))?;
    let mut y = 0_i32;
    source.for_each_band(|band| {
        for row in band.chunks_exact(columns) {
            out.write_all(&scan_line(y, row))?;
            y += 1;
        }
        Ok(())
    })
}

/// Where each scan line begins.
fn offsets(header: usize, columns: usize, rows: usize) -> Vec<u8> {
    let first = header + 8 * rows;
    let line = 8 + 4 * columns;
    let offsets = (0..rows).map(|y| (first + y * line) as u64);
    offsets.flat_map(u64::to_le_bytes).collect()
}

/// A row with its number and length.
fn scan_line(y: i32, row: &[f32]) -> Vec<u8> {
    let mut bytes = y.to_le_bytes().to_vec();
    bytes.extend((4 * row.len() as u32).to_le_bytes());
    bytes.extend(row.iter().flat_map(|z| z.to_le_bytes()));
    bytes
}

fn header(columns: usize, rows: usize) -> Vec<u8> {
    let window = [0, 0, columns as i32 - 1, rows as i32 - 1];
    let window: Vec<u8> = window.into_iter().flat_map(i32::to_le_bytes).collect();
    let one = 1.0_f32.to_le_bytes();
    let mut header = START.to_vec();
    let mut add = |name: &str, kind: &str, value: &[u8]| add(&mut header, name, kind, value);
    add("channels", "chlist", &channels());
    add("compression", "compression", &[0]);
    add("dataWindow", "box2i", &window);
    add("displayWindow", "box2i", &window);
    // Increasing y.
    add("lineOrder", "lineOrder", &[0]);
    add("pixelAspectRatio", "float", &one);
    add("screenWindowCenter", "v2f", &[0; 8]);
    add("screenWindowWidth", "float", &one);
    add("software", "string", b"Pangaea");
    header.push(0);
    header
}

/// An attribute: name, type, length, value.
fn add(header: &mut Vec<u8>, name: &str, kind: &str, value: &[u8]) {
    for text in [name, kind] {
        header.extend(text.as_bytes());
        header.push(0);
    }
    header.extend((value.len() as u32).to_le_bytes());
    header.extend(value);
}

/// The list of channels: `Y` of type float (2), not perceptual, every pixel in both directions.
fn channels() -> Vec<u8> {
    let mut list = b"Y\0".to_vec();
    list.extend([2, 0, 1, 1].into_iter().flat_map(u32::to_le_bytes));
    list.push(0);
    list
}
