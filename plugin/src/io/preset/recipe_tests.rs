use super::*;

#[test]
fn an_empty_preset_is_the_default_planet() {
    assert_eq!(parse_recipe("()"), Ok(PlanetRecipe::default()));
}

#[test]
fn fields_are_read() {
    let recipe = parse_recipe(
        "(samples: 5000, plates: [(centroid: (10, -60), pole: (55, 20), speed: 40),
          (centroid: (-20, 120))], continents: [(center: (0, 0), radius: 900)],
          params: (erosion: 0.5, processes: (noise: false), ocean_floor: Paper))",
    )
    .unwrap();
    assert_eq!(recipe.plates[0].pole, Some((55.0, 20.0)));
    assert_eq!(recipe.plates[1].pole, None);
    assert_eq!(recipe.params.erosion, 0.5);
    assert!(!recipe.params.processes.noise && recipe.params.processes.drift);
}

#[test]
fn what_is_written_is_read() {
    let recipe = PlanetRecipe {
        seed: u64::MAX,
        land: 0.123_456_789,
        ..PlanetRecipe::default()
    };
    assert_eq!(parse_recipe(&ron::to_string(&recipe).unwrap()), Ok(recipe));
}

#[test]
fn a_byte_order_mark_and_line_ends_of_any_system_are_passed_over() {
    let text = "\u{feff}(\r\n  seed: 7, // seven\r\n  samples: 500,\r\n)\r\n";
    let recipe = parse_recipe(text).unwrap();
    assert_eq!((recipe.seed, recipe.samples), (7, 500));
    assert_eq!(
        line_of_error("\u{feff}(\r\n  seed: 7,\r\n  samples: 1,\r\n)"),
        3
    );
}

fn line_of_error(text: &str) -> usize {
    parse_recipe(text).unwrap_err().line
}

#[test]
fn errors_name_the_line() {
    assert_eq!(line_of_error("(\n  seed: 1,\n  sampels: 5,\n)"), 3);
    assert_eq!(line_of_error("(\n  samples: 1000000000000,\n)"), 2);
    assert_eq!(line_of_error("(\n  seed: 1,\n  samples: 99,\n)"), 3);
    assert_eq!(line_of_error("(\n  params: (\n    erosion: 9,\n  ),\n)"), 3);
    assert_eq!(line_of_error("(\n  land: NaN,\n)"), 2);
    assert_eq!(line_of_error("(\n\n  radius: -inf\n)"), 3);
    let error = parse_recipe("(\n  samples: 5000,\n  plate_count: 100000\n)").unwrap_err();
    assert!(error.problem.contains("100000"), "{error}");
    assert!(
        !parse_recipe("(seed: \"a\nb\")")
            .unwrap_err()
            .to_string()
            .contains('\n')
    );
}

const BAD_NUMBERS: [&str; 5] = ["NaN", "inf", "-inf", "1e300", "-1e300"];

fn assert_refused(text: &str) {
    assert!(parse_recipe(text).is_err(), "{text}");
}

#[test]
fn every_number_of_a_preset_is_checked() {
    for bad in BAD_NUMBERS {
        for field in ["radius", "land"] {
            assert_refused(&format!("({field}: {bad})"));
        }
        for info in crate::params::TectonicParams::TABLE {
            assert_refused(&format!("(params: ({}: {bad}))", info.name));
        }
    }
}

#[test]
fn every_number_of_a_plate_and_a_continent_is_checked() {
    for bad in BAD_NUMBERS {
        for plate in [
            format!("(centroid: ({bad}, 0))"),
            format!("(centroid: (0, {bad}))"),
            format!("(centroid: (0, 0), speed: {bad})"),
            format!("(centroid: (0, 0), pole: ({bad}, 0))"),
            format!("(centroid: (0, 0), pole: (0, {bad}))"),
        ] {
            assert_refused(&format!("(plates: [(centroid: (1, 1)), {plate}])"));
        }
        for disc in [
            format!("(center: ({bad}, 0), radius: 100)"),
            format!("(center: (0, {bad}), radius: 100)"),
            format!("(center: (0, 0), radius: {bad})"),
        ] {
            assert_refused(&format!("(continents: [{disc}])"));
        }
    }
}
