//! The ground of a grown planet: its belts and plains have the relief of real ones.

use bevy_pangaea::math::lat_lon;
use bevy_pangaea::query::{AzimuthalEquidistant, Ground, MapSquare, PlanetGround};
use bevy_pangaea::relief_stats::{
    ReliefClass, ReliefStats, SiteInput, TILE_M, TILE_PIXELS, medians, sites,
};
use pangaea_tests::grown::GrownPlanet;

/// Sites of a class: as many as a test has time for.
const SITES: usize = 6;

/// Median relief in 10 km in m, 90th percentile of the slope in degrees and spectral exponent of a
/// class, measured on SRTM tiles of the Himalaya, the Andes, the Appalachians, the Scottish
/// Highlands, the White Mountains and the Amazon.
fn measured(class: ReliefClass) -> [[f64; 2]; 3] {
    let [relief, slope] = match class {
        ReliefClass::YoungHimalayan => [[2200.0, 3400.0], [42.0, 52.0]],
        ReliefClass::YoungAndean => [[1200.0, 2300.0], [20.0, 40.0]],
        ReliefClass::OldBelts => [[600.0, 900.0], [16.0, 27.0]],
        ReliefClass::Plains => [[0.0, 200.0], [0.0, 8.0]],
    };
    [relief, slope, [2.6, 4.0]]
}

/// The relief of the middle quarter of a site's tile, at its resolution.
fn middle(ground: &PlanetGround, (lat, lon): (f64, f64)) -> ReliefStats {
    let about = AzimuthalEquidistant::new(lat, lon, ground.radius_m()).unwrap();
    let square = MapSquare::new(about, TILE_M / 2.0, TILE_PIXELS / 2).unwrap();
    ReliefStats::of(&square.heights(ground, square.level()).unwrap()).unwrap()
}

#[test]
fn a_grown_planet_has_the_relief_of_real_belts_and_plains() {
    let planet = GrownPlanet::new(1, 60_000, 125);
    let input = planet.site_input();
    let wrong: Vec<String> = ReliefClass::ALL
        .into_iter()
        .flat_map(|class| wrong_figures(&planet.ground, &input, class))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The relief about the sites of a class.
fn reliefs(ground: &PlanetGround, input: &SiteInput, class: ReliefClass) -> Vec<ReliefStats> {
    let drawn = sites(input, class);
    assert!(drawn.len() >= SITES, "{} {}", drawn.len(), class.name());
    let places = drawn[..SITES]
        .iter()
        .map(|&site| lat_lon(input.mesh.point(site)));
    places.map(|place| middle(ground, place)).collect()
}

/// The figures of a class that are not those of measured tiles.
fn wrong_figures(ground: &PlanetGround, input: &SiteInput, class: ReliefClass) -> Vec<String> {
    let name = class.name();
    let reliefs = reliefs(ground, input, class);
    let figures = medians(&reliefs).into_iter().zip(measured(class));
    figures
        .filter(|(found, [low, high])| !found.is_some_and(|x| (*low..=*high).contains(&x)))
        .map(|(found, [low, high])| format!("{name}: {found:?}, not {low}..{high}"))
        .collect()
}
