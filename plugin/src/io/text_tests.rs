use super::*;

/// A text as UTF-16 with a byte order mark, whose units `bytes` writes.
fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}")
        .encode_utf16()
        .flat_map(bytes)
        .collect()
}

#[test]
fn texts_are_read_whatever_their_byte_order_mark() {
    let text = "(name: \"Ätna 𝄞\",\r\n height: 3357)\r\n";
    let marked = [&b"\xef\xbb\xbf"[..], text.as_bytes()].concat();
    for bytes in [
        text.as_bytes().to_vec(),
        marked,
        utf16(text, u16::to_le_bytes),
        utf16(text, u16::to_be_bytes),
    ] {
        assert_eq!(without_mark(&decode(&bytes).unwrap()), text);
    }
}

#[test]
fn bytes_that_are_no_text_are_refused_in_one_line() {
    let odd = utf16("()", u16::to_le_bytes);
    let half_a_pair = [0xff, 0xfe, 0x34, 0xd8];
    for bytes in [&b"\xff"[..], b"(\xe4)", &odd[..5], &half_a_pair] {
        let problem = decode(bytes).unwrap_err().to_string();
        assert!(
            problem.contains("UTF-8") && !problem.contains('\n'),
            "{problem}"
        );
    }
}

#[test]
fn ron_is_read_behind_a_byte_order_mark_and_with_any_line_ends() {
    for text in ["[1,\n2]", "\u{feff}[1,\r\n2]\r\n", "\u{feff}\r\n[1,\r2]"] {
        assert_eq!(parse::<Vec<u8>>(text), Ok(vec![1, 2]), "{text:?}");
    }
    let refused = parse::<Vec<u8>>("\u{feff}[1,\r\n2,\r\nx]").unwrap_err();
    assert_eq!(refused.line, 3, "lines are counted as without a mark");
}

#[cfg(feature = "dem")]
#[test]
fn json_is_read_behind_a_byte_order_mark() {
    let text = "[1,\r\n2]\r\n";
    let marked = [&b"\xef\xbb\xbf"[..], text.as_bytes()].concat();
    for bytes in [
        text.as_bytes().to_vec(),
        marked,
        utf16(text, u16::to_le_bytes),
    ] {
        assert_eq!(parse_json(&bytes), Ok(vec![1, 2]));
    }
    assert!(parse_json::<Vec<u8>>(b"\xff").is_err());
}
