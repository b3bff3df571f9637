//! Maps of the climate come back to the last bit, and sizes that bytes do not bear out are refused.

use super::format::{file, has_section, replaced};
use super::*;
use crate::io::codec::Encoder;
use crate::io::digest;

const CLIMATE: SectionTag = *b"CLIM";

/// The bits of the values of a map.
fn bits(map: &EquirectMap) -> Vec<u32> {
    map.values().iter().map(|value| value.to_bits()).collect()
}

#[test]
fn voids_come_back_to_the_last_bit() {
    let odd = [f32::NAN, f32::from_bits(0x7fc0_1234), -0.0, 1e-40];
    let values = (0..32).map(|i| if i < 4 { odd[i] } else { 100.7 * i as f32 });
    let map = EquirectMap::new(8, 4, values.collect()).unwrap();
    let mut state = state();
    state.climate.rain = Some(map.clone());
    let back = read_from(&bytes(&state)).unwrap().climate;
    assert_eq!(bits(&back.rain.unwrap()), bits(&map));
    assert_eq!(back.temperature, state.climate.temperature);
}

#[test]
fn a_planet_without_maps_has_no_section_for_them() {
    let mut state = state();
    assert!(has_section(&state, CLIMATE));
    state.climate = ClimateMaps::default();
    assert!(!has_section(&state, CLIMATE));
    let back = read_from(&bytes(&state)).unwrap();
    assert_eq!(back.climate, ClimateMaps::default());
}

/// The digest of the state with these maps.
fn digest_with(climate: ClimateMaps) -> String {
    digest(&PlanetState { climate, ..state() })
}

#[test]
fn the_digest_sees_maps_and_their_last_bits() {
    let original = state();
    let only_rain = ClimateMaps {
        temperature: None,
        ..maps()
    };
    let moved = ClimateMaps {
        rain: None,
        wetness: uniform(0.5),
        ..maps()
    };
    let mut nearly = maps();
    let mut values = nearly.rain.as_ref().unwrap().values().to_vec();
    values[5] = f32::from_bits(values[5].to_bits() + 1);
    nearly.rain = EquirectMap::new(6, 3, values).ok();
    let mut digests = [maps(), only_rain, moved, nearly, ClimateMaps::default()].map(digest_with);
    assert_eq!(digests[0], digest(&original));
    digests.sort();
    assert!(digests.windows(2).all(|pair| pair[0] != pair[1]));
}

/// A section with one map of that size in so many bytes that say they are packed values.
fn map_section(name: &str, [width, height]: [u32; 2], packed: &[u8]) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(1);
    out.text(name);
    out.u32(width);
    out.u32(height);
    out.u64(packed.len() as u64);
    out.0.extend(packed);
    out.0
}

/// Why a file with this section of maps is refused.
fn refusal_of(section: Vec<u8>) -> String {
    let parts = replaced(&bytes(&state()), CLIMATE, section);
    refusal(&file(VERSION, &parts)).to_string()
}

#[test]
fn sizes_that_the_bytes_do_not_bear_out_are_refused() {
    // Half a gigabyte is claimed, in bytes that hold a few values and in none.
    let packed = crate::io::planes::pack(&[1.0; 1000]);
    for packed in [&packed[..], &[]] {
        let problem = refusal_of(map_section("rain", [16_384, 8192], packed));
        assert!(problem.contains("cannot be unpacked"), "{problem}");
    }
    // More than a save holds, whatever the bytes are.
    let largest = [EquirectMap::MAX_SIDE, EquirectMap::MAX_SIDE / 2];
    let problem = refusal_of(map_section("rain", largest, &packed));
    assert!(problem.contains("536870912 pixels"), "{problem}");
    // More values than the size says.
    let problem = refusal_of(map_section("rain", [4, 2], &packed));
    assert!(problem.contains("map of 8 pixels"), "{problem}");
    for size in [[u32::MAX; 2], [0, 0], [4, 4]] {
        let problem = refusal_of(map_section("rain", size, &packed));
        assert!(problem.contains(&size[0].to_string()), "{problem}");
    }
}

#[test]
fn maps_that_are_not_known_and_maps_that_are_there_twice_are_named() {
    let packed = crate::io::planes::pack(&[0.5; 8]);
    let section = map_section("cloudiness", [4, 2], &packed);
    assert!(refusal_of(section).contains("`cloudiness`"));
    let rain = map_section("rain", [4, 2], &packed);
    let twice = [&2_u32.to_le_bytes(), &rain[4..], &rain[4..]].concat();
    assert!(refusal_of(twice).contains("two maps of rain"));
}
