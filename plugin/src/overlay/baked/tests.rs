use super::{draw as draw_on, *};
use crate::climate::{ClimateMaps, EquirectMap};
use crate::control::{BakeFrame, BakeRules, BakeSource};
use crate::hydrology::{NO_VERTEX, TerrainMaps};
use crate::overlay::palette::classes;
use crate::overlay::raster::Raster;
use crate::overlay::rivers;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A planet whose northern half is a slope down to the equator.
pub(crate) fn bake() -> Bake {
    let crust = EquirectMap::from_fn(64, |lat, _| (lat / 30.0) as f32).unwrap();
    let maps = TerrainMaps {
        crust,
        age: None,
        plateau: None,
        hills: None,
    };
    let frame = Arc::new(BakeFrame::new(1, 0.04, None).unwrap());
    let (source, own) = (BakeSource::Maps(&maps), ClimateMaps::default());
    Bake::new(&frame, 6370.0, &source, &own, &BakeRules::default()).unwrap()
}

/// The map of one overlay.
fn draw(overlay: Overlay, bake: &Bake, width: u32, height: u32) -> Raster {
    let mut raster = [Raster::black(width, height)];
    draw_on(&[overlay], bake, &mut raster);
    let [raster] = raster;
    raster
}

/// The colour of a pixel.
fn pixel(raster: &Raster, x: u32, y: u32) -> Rgba {
    let k = 3 * (y * raster.width + x) as usize;
    [raster.rgb[k], raster.rgb[k + 1], raster.rgb[k + 2], 255]
}

/// The colours of the northern half of a map.
fn northern_colors(raster: &Raster) -> Vec<Rgba> {
    (0..raster.height / 2)
        .flat_map(|y| (0..raster.width).map(move |x| (x, y)))
        .map(|(x, y)| pixel(raster, x, y))
        .collect()
}

#[test]
fn maps_show_the_sea_and_the_rivers() {
    let rivers = draw(Overlay::Rivers, &bake(), 128, 64);
    assert_eq!(pixel(&rivers, 30, 50), classes::SEA);
    let is_river = |color: &Rgba| (2..8).any(|order| *color == rivers::order_color(order));
    let blue = northern_colors(&rivers).into_iter().filter(is_river);
    assert!(blue.count() > 100);
}

#[test]
fn maps_show_the_basins() {
    let basins = draw(Overlay::Basins, &bake(), 128, 64);
    let colors: BTreeSet<_> = northern_colors(&basins).into_iter().collect();
    assert!(colors.len() > 5, "{}", colors.len());
}

#[test]
fn the_equator_is_redder_than_the_pole() {
    let warmth = draw(Overlay::Temperature, &bake(), 128, 64);
    assert!(pixel(&warmth, 5, 32)[0] > pixel(&warmth, 5, 1)[0]);
}

#[test]
fn maps_drawn_together_are_those_drawn_alone() {
    let bake = bake();
    let overlays: Vec<_> = Overlay::ALL
        .into_iter()
        .filter(|o| o.needs_bake())
        .collect();
    let mut together = vec![Raster::black(96, 48); overlays.len()];
    draw_on(&overlays, &bake, &mut together);
    for (overlay, map) in overlays.into_iter().zip(together) {
        assert!(map == draw(overlay, &bake, 96, 48), "{overlay:?}");
    }
}

#[test]
fn pixels_have_the_colours_of_their_centres() {
    let bake = bake();
    let shown = Shown::new(Overlay::Temperature, &bake);
    let map = draw(Overlay::Temperature, &bake, 96, 48);
    for (x, y) in [(0, 0), (95, 47), (50, 13)] {
        let (lat, lon) = (
            90.0 - (f64::from(y) + 0.5) * 3.75,
            (f64::from(x) + 0.5) * 3.75 - 180.0,
        );
        let at = bake.mesh().locate(crate::math::direction(lat, lon));
        assert_eq!(pixel(&map, x, y), shown.at(&BasePlace::new(&bake, at)));
    }
}

/// How dark the map of discharge is at a vertex of the base mesh.
fn darkness(shown: &Shown, bake: &Bake, i: u32) -> i32 {
    let at = bake.mesh().locate(bake.mesh().point(i));
    let color = shown.at(&BasePlace::new(bake, at));
    -color[..3].iter().map(|&c| i32::from(c)).sum::<i32>()
}

#[test]
fn discharge_darkens_down_the_rivers() {
    let bake = bake();
    let routes = &bake.drainage.routes;
    let on_land = |i: u32| i != NO_VERTEX && bake.drainage.shore[i as usize] == ShoreClass::Land;
    let steps: Vec<(u32, u32)> = (routes.order.iter())
        .map(|&i| (i, routes.receiver[i as usize]))
        .filter(|&(i, to)| on_land(i) && on_land(to))
        .collect();
    assert!(steps.len() > 1000);
    let shown = Shown::new(Overlay::Drainage, &bake);
    for (i, to) in steps {
        assert!(
            darkness(&shown, &bake, i) <= darkness(&shown, &bake, to) + 1,
            "no water is lost on the way down"
        );
    }
}

#[test]
fn discharge_leaves_the_sea_plain() {
    let map = draw(Overlay::Drainage, &bake(), 128, 64);
    let south = &map.rgb[3 * 128 * 40..];
    assert!(south.chunks(3).all(|color| color == &classes::SEA[..3]));
    let colors: BTreeSet<_> = northern_colors(&map).into_iter().collect();
    assert!(colors.len() > 20, "{} colours", colors.len());
}

#[test]
fn samples_have_the_colours_of_their_places() {
    let bake = bake();
    let lattice = SphereMesh::fibonacci(500).unwrap();
    for overlay in Overlay::ALL.into_iter().filter(|o| o.needs_bake()) {
        let colors = colors(overlay, &bake, &lattice);
        assert_eq!(colors.len(), 500);
        let differs = colors.iter().any(|color| *color != colors[0]);
        assert!(differs, "{overlay:?}");
    }
}
