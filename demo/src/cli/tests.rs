//! The command line is read as it is documented.

use super::*;
use crate::values::{BoxSpec, PixelsSpec, PlaceSpec};
use bevy_pangaea::overlay::Overlay;
use bevy_pangaea::planet::PlanetRecipe;
use clap::CommandFactory;

/// Reads a line of `pangaea`.
fn parse(args: &[&str]) -> Cli {
    Cli::try_parse_from([&["pangaea"], args].concat()).unwrap()
}

#[test]
fn the_command_line_is_consistent() {
    Cli::command().debug_assert();
}

#[test]
fn the_explorer_and_the_commands_take_the_same_recipe() {
    let options = [
        "--seed",
        "7",
        "--samples",
        "500",
        "--plates",
        "9",
        "--land",
        "0.5",
    ];
    let started = parse(&options).start;
    let line = [&["generate", "--until", "20"], &options[..]].concat();
    let Some(Command::Generate(args)) = parse(&line).command else {
        panic!()
    };
    let recipe = args.growth.recipe.checked().unwrap();
    assert_eq!(
        (recipe.seed, recipe.samples, recipe.plate_count, recipe.land),
        (7, 500, 9, 0.5)
    );
    assert_eq!(
        (started.recipe.checked().unwrap(), args.growth.until()),
        (recipe, 20.0)
    );
}

#[test]
fn a_file_and_a_recipe_exclude_each_other() {
    let line = ["pangaea", "--open", "a.pangaea", "--seed", "7"];
    assert!(Cli::try_parse_from(line).is_err());
}

#[test]
fn cameras_in_the_south_and_west_are_accepted() {
    for line in [
        ["render", "--camera=-33,-70,1e6", "--out=a.png"],
        ["render", "--out=a.png", "--camera=-33,-70,1e6"],
    ] {
        parse(&line);
    }
    let camera = "-33,-70,1000000,90,-10";
    let line = ["render", "--camera", camera, "--out", "a.png"];
    let Some(Command::Render(args)) = parse(&line).command else {
        panic!()
    };
    assert_eq!((args.camera.lat, args.camera.lon), (-33.0, -70.0));
}

const SOUTH_WEST: PlaceSpec = PlaceSpec {
    lat: -33.0,
    lon: -70.0,
};

#[test]
fn points_in_the_south_and_west_are_accepted_in_both_forms() {
    for at in [&["--at=-33,-70"][..], &["--at", "-33,-70"]] {
        let line = [&["query", "a.pangaea"], at].concat();
        let Some(Command::Query(args)) = parse(&line).command else {
            panic!()
        };
        assert_eq!((args.at, args.level), (Some(SOUTH_WEST), 17));
    }
}

#[test]
fn squares_in_the_south_and_west_are_accepted_in_both_forms() {
    for region in [&["--region=-33,-70,12"][..], &["--region", "-33,-70,12"]] {
        let line = [&["export", "a.pangaea", "--out", "a.tif"], region].concat();
        let Some(Command::Export(args)) = parse(&line).command else {
            panic!()
        };
        let region = args.region.unwrap();
        assert_eq!((region.middle, region.size_km), (SOUTH_WEST, 12.0));
        assert_eq!(args.pixels, PixelsSpec::Side(1024));
    }
}

#[test]
fn maps_are_asked_for_by_their_names() {
    let line = [
        "maps",
        "a.pangaea",
        "--out",
        "m",
        "--overlay",
        "plates,rain",
    ];
    let Some(Command::Maps(args)) = parse(&line).command else {
        panic!()
    };
    assert_eq!(args.overlay, [Overlay::Plates, Overlay::Rain]);
    assert_eq!(args.size, 2048);
}

#[test]
fn boxes_in_the_south_and_west_are_accepted_in_both_forms() {
    for degrees in [
        &["--box=-20,-70,-10,-60"][..],
        &["--box", "-20,-70,-10,-60"],
    ] {
        let line = [&["export", "a.pangaea", "--out", "a.tif"], degrees].concat();
        let Some(Command::Export(args)) = parse(&line).command else {
            panic!()
        };
        assert_eq!(args.degrees, Some(BoxSpec([-20.0, -70.0, -10.0, -60.0])));
    }
}

#[test]
fn an_export_has_one_area() {
    assert!(!exports(&[]));
    assert!(!exports(&["--region=0,0,5", "--box=0,0,5,5"]));
    assert!(!exports(&["--box=0,0,5,5", "--tiles=2x2"]));
    assert!(exports(&["--region=0,0,5", "--tiles=2x2"]));
}

/// Whether an export with these arguments is understood.
fn exports(more: &[&str]) -> bool {
    let line = [&["pangaea", "export", "a.pangaea", "--out", "a.tif"], more].concat();
    Cli::try_parse_from(line).is_ok()
}

#[test]
fn the_help_names_every_overlay_and_the_true_defaults() {
    let mut help = Cli::command();
    let render = help.find_subcommand_mut("render").unwrap();
    let render = render.render_long_help().to_string();
    for overlay in Overlay::ALL {
        assert!(render.contains(overlay.name()), "{render}");
    }
    let recipe = PlanetRecipe::default();
    for text in [
        format!("[default: {}]", recipe.seed),
        format!("[default: {}]", recipe.samples),
        format!("[default: {}]", recipe.plate_count),
        format!("[default: {}]", recipe.land),
        format!("[default: {}]", GrowthArgs::UNTIL),
    ] {
        assert!(render.contains(&text), "{text}");
    }
}
