//! OpenEXR, by the layout of its specification.

use super::*;

/// The bytes of an attribute's value.
fn attribute<'a>(bytes: &'a [u8], name: &str, kind: &str) -> &'a [u8] {
    let head = [name, "\0", kind, "\0"].concat();
    let start = bytes
        .windows(head.len())
        .position(|window| window == head.as_bytes());
    let at = start.unwrap() + head.len();
    let length = u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    &bytes[at + 4..at + 4 + length as usize]
}

#[test]
fn an_exr_has_its_size_and_one_channel_of_floats() {
    let (_folder, files) = exported("a.exr", 30);
    let bytes = fs::read(&files[0]).unwrap();
    assert_eq!(bytes[..8], [0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0]);
    let window = [0_i32, 0, 29, 29].map(i32::to_le_bytes).concat();
    assert_eq!(attribute(&bytes, "dataWindow", "box2i"), window);
    assert_eq!(attribute(&bytes, "displayWindow", "box2i"), window);
    assert_eq!(attribute(&bytes, "compression", "compression"), [0]);
    // Float, linear, every pixel.
    let channel = b"Y\0\x02\0\0\0\0\0\0\0\x01\0\0\0\x01\0\0\0\0";
    assert_eq!(attribute(&bytes, "channels", "chlist"), channel);
}

#[test]
fn an_exr_holds_metres_where_its_offsets_say() {
    let (_folder, files) = exported("a.exr", 30);
    let bytes = fs::read(&files[0]).unwrap();
    let line = 8 + 4 * 30;
    let table = bytes.len() - 30 * line - 30 * 8;
    for (y, row) in heights(30).values.chunks(30).enumerate() {
        let entry = bytes[table + 8 * y..][..8].try_into().unwrap();
        let at = u64::from_le_bytes(entry) as usize;
        let head = [y as u32, 120].map(u32::to_le_bytes).concat();
        assert_eq!(bytes[at..at + 8], head);
        let floats: Vec<u8> = row.iter().flat_map(|z| z.to_le_bytes()).collect();
        assert_eq!(bytes[at + 8..at + line], floats);
    }
}
