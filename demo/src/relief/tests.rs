use super::*;
use bevy_pangaea::query::HeightGrid;
use bevy_pangaea::relief_stats::{Geomorphon, ReliefStats};

/// Figures of a tile of 100 x 100 pixels of 92.6 m.
fn tile(name: &str, height: impl Fn(usize, usize) -> f32) -> ReliefFigures {
    let values = (0..10_000).map(|i| height(i % 100, i / 100)).collect();
    let grid = HeightGrid {
        width: 100,
        height: 100,
        values,
        pixel_m: [92.6; 2],
    };
    ReliefFigures::new(name.into(), &[ReliefStats::of(&grid).unwrap()])
}

fn level(name: &str) -> ReliefFigures {
    tile(name, |_, _| 100.0)
}

fn hillside(name: &str) -> ReliefFigures {
    tile(name, |x, _| 20.0 * x as f32)
}

fn no_sites() -> ReliefFigures {
    ReliefFigures::new("plains".into(), &[])
}

#[test]
fn figures_have_the_documented_form() {
    let tile = ReliefFigures {
        relief10_median_m: Some(653.4),
        coherence_p90: Some(0.45),
        ..hillside("N44W072")
    };
    let json = all_figures(&[no_sites()], &[tile]);
    assert_eq!(json["plains"]["sites"], 0);
    assert_eq!(json["plains"].as_object().unwrap().len(), 9);
    let figures = json["plains"].as_object().unwrap();
    assert!(
        figures
            .iter()
            .all(|(key, value)| key == "sites" || value.is_null())
    );
    let tile = &json["tiles"]["N44W072"];
    assert_eq!(tile["relief10_median_m"], 653.4);
    assert_eq!(tile["coherence_p90"], 0.45);
    assert_eq!(tile["pits_percent"], 0.0);
    let shares = &json["geomorphons"]["N44W072"];
    assert_eq!(shares["slope"], 1.0);
    assert_eq!(shares.as_object().unwrap().len(), Geomorphon::COUNT);
    assert!(json["geomorphons"]["plains"].is_null());
}

fn near(figures: &ReliefFigures) -> Option<(String, f64)> {
    let near = figures.nearest.clone();
    near.map(|near| (near.name, near.distance))
}

#[test]
fn the_nearest_tile_is_named() {
    let mut classes = [hillside("old_belts"), no_sites()];
    let mut tiles = [level("A"), hillside("B"), level("C")];
    compare(&mut classes, &mut tiles);
    assert_eq!(near(&classes[0]), Some(("B".into(), 0.0)));
    assert_eq!(near(&classes[1]), None);
    // A tile is not compared with itself; slopes and level ground have no form in common.
    assert_eq!(near(&tiles[0]), Some(("C".into(), 0.0)));
    assert_eq!(near(&tiles[1]), Some(("A".into(), 1.0)));
    let json = all_figures(&classes, &tiles);
    assert_eq!(json["nearest_tile"]["old_belts"], "B");
    assert_eq!(json["old_belts"]["geomorphon_distance"], 0.0);
}

#[test]
fn a_class_without_sites_has_a_line_in_every_table() {
    let text = tables(&[no_sites()], &[]);
    assert_eq!(
        text.lines()
            .filter(|line| line.starts_with("plains"))
            .count(),
        3
    );
    assert_eq!(text.lines().count(), 8);
    assert!(text.contains("geomorphons, %            flat  peak ridge shoul"));
}

#[test]
fn lines_are_narrow() {
    let mut tiles = [level("A"), hillside("himalaya-annapurna")];
    compare(&mut [], &mut tiles);
    let text = tables(&[no_sites()], &tiles);
    assert!(text.lines().all(|line| line.len() <= 90), "{text}");
    assert!(text.contains("1.000 A"), "{text}");
}
