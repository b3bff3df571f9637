//! The ranges of a grown planet's belts run along the axes of their folds.

use bevy::math::{DVec2, DVec3};
use bevy_pangaea::math::{acos, atan2, east_north, lat_lon};
use bevy_pangaea::query::{AzimuthalEquidistant, Ground, HeightGrid, MapSquare, PlanetGround};
use bevy_pangaea::relief_stats::{ReliefClass, sites};
use pangaea_tests::grown::GrownPlanet;

/// Side of a window in m, and its pixels to a side: of ranges 10 to 40 km apart.
const WINDOW: (f64, usize) = (40_000.0, 64);

/// Level of the heights: edges of 1.6 km.
const LEVEL: u8 = 5;

/// Most that ridges may differ from the axis in the median, degrees; by chance they would by 45.
const MOST_DEG: f64 = 25.0;

/// The direction of a tile's ridges, from east towards north: that in which its gradient, less its
/// mean, is least.
fn ridges(tile: &HeightGrid) -> f64 {
    let at = |x: usize, y: usize| f64::from(tile.row(y)[x]);
    let inner = |side: usize| 1..side - 1;
    let gradients: Vec<DVec2> = inner(tile.height)
        .flat_map(|y| inner(tile.width).map(move |x| (x, y)))
        .map(|(x, y)| DVec2::new(at(x + 1, y) - at(x - 1, y), at(x, y - 1) - at(x, y + 1)))
        .collect();
    let mean = gradients.iter().sum::<DVec2>() / gradients.len() as f64;
    // Twice the angle, so that opposite directions are one.
    let steepest: DVec2 = gradients.iter().map(|g| doubled(*g - mean)).sum();
    0.5 * (atan2(steepest.y, steepest.x) + core::f64::consts::PI)
}

/// A vector of twice the angle: the square of the complex number.
fn doubled(g: DVec2) -> DVec2 {
    DVec2::new(g.x * g.x - g.y * g.y, 2.0 * g.x * g.y)
}

/// Angle between the ridges of a tile about a place and the axis of its folds, 0 to 90 degrees.
fn deviation(ground: &PlanetGround, at: DVec3, fold: DVec3) -> f64 {
    let (lat, lon) = lat_lon(at);
    let about = AzimuthalEquidistant::new(lat, lon, ground.radius_m()).unwrap();
    let square = MapSquare::new(about, WINDOW.0, WINDOW.1).unwrap();
    let ridges = ridges(&square.heights(ground, LEVEL).unwrap());
    let (east, north) = east_north(at);
    let ridge = ridges.cos() * east + ridges.sin() * north;
    acos(ridge.dot(fold.normalize()).abs().min(1.0)).to_degrees()
}

/// Places in belts with the direction of their folds, where they are folded well.
fn folded_places(planet: &GrownPlanet) -> Vec<(DVec3, DVec3)> {
    let input = planet.site_input();
    let fold = |site: u32| planet.surface.crust.fold[site as usize].as_dvec3();
    let belts = [
        ReliefClass::YoungHimalayan,
        ReliefClass::YoungAndean,
        ReliefClass::OldBelts,
    ];
    belts
        .into_iter()
        .flat_map(|class| sites(&input, class))
        .map(|site| (input.mesh.point(site), fold(site)))
        .filter(|(_, fold)| fold.length() > 0.1)
        .collect()
}

#[test]
fn ranges_of_young_and_old_belts_run_along_their_folds() {
    let planet = GrownPlanet::new(1, 60_000, 125);
    let folded = folded_places(&planet).into_iter();
    let mut angles: Vec<f64> = folded
        .map(|(at, fold)| deviation(&planet.ground, at, fold))
        .collect();
    assert!(angles.len() >= 30, "{} sites with folds", angles.len());
    angles.sort_by(f64::total_cmp);
    let median = angles[angles.len() / 2];
    assert!(median < MOST_DEG, "{median} degrees off: {angles:?}");
}
