//! Overlays of a bake: climate, rivers, basins and lakes, on the base mesh of the ground.
//!
//! Maps look at the base mesh itself, which may be finer than the crust's samples; rivers are lines along its
//! edges, as wide as their order, on maps as on globes. A colour per sample of the crust shows what lies at the sample.
//! Without a bake there is nothing to show, and all is grey.

use super::map::Raster;
use super::palette::{self, Rgba};
use super::{Overlay, field};
use crate::control::Bake;
use crate::hydrology::{NONE, Site};
use crate::math;
use crate::random::mix;
use crate::sphere::{Location, SphereMesh};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Temperatures at the ends of the ramp in °C.
pub(super) const TEMPERATURE: (f32, f32) = (-40.0, 35.0);
/// Rain at the end of the ramp in mm per year.
pub(super) const RAIN_MAX: f32 = 4000.0;
/// Lakes, by the number of their [`LakeKind`](crate::hydrology::LakeKind): blue is what drains to the sea.
pub(super) const LAKE: [Rgba; 3] = [[44, 112, 196, 255], [92, 98, 184, 255], [140, 84, 172, 255]];
/// The sea behind rivers, basins and lakes.
pub(super) const SEA: Rgba = [38, 48, 66, 255];
/// The land behind rivers and lakes.
pub(super) const LAND: Rgba = [206, 202, 190, 255];
/// Water that never reaches the sea darkens towards this.
const CLOSED: Rgba = [96, 40, 40, 255];

/// Lowest order of a river that is drawn.
const LOWEST_ORDER: u8 = 2;

/// Whether an overlay shows a bake.
pub(super) fn is_baked(overlay: Overlay) -> bool {
    use Overlay::{Basins, Lakes, Rain, Rivers, Temperature, Wetness};
    matches!(overlay, Temperature | Rain | Wetness | Rivers | Basins | Lakes)
}

/// The colour of a river's order: the higher, the deeper and the darker.
pub(crate) fn order_color(order: u8) -> Rgba {
    let t = (f32::from(order.max(1)) - 1.0) / 6.0;
    palette::mix([122, 170, 208, 255], [10, 40, 110, 255], t)
}

/// Colours of the samples of the crust.
pub(super) fn colors(overlay: Overlay, bake: &Bake, lattice: &SphereMesh) -> Vec<Rgba> {
    let base = bake.mesh();
    super::relief::per_sample(lattice, |i| color_at(overlay, bake, &base.locate(lattice.point(i))))
}

/// The map of an overlay.
pub(super) fn draw(overlay: Overlay, bake: &Bake, width: u32, height: u32) -> Raster {
    let base = bake.mesh();
    let mut rgb = vec![0; 3 * width as usize * height as usize];
    rgb.par_chunks_mut(3 * width as usize).enumerate().for_each(|(y, row)| {
        let mut hint = None;
        for (x, out) in row.chunks_exact_mut(3).enumerate() {
            let p = direction(x as f64 + 0.5, y as f64 + 0.5, width, height);
            let nearest = hint.map_or_else(|| base.nearest(p), |hint| base.nearest_from(p, hint));
            hint = Some(nearest);
            out.copy_from_slice(&color_at(overlay, bake, &base.locate_from(p, nearest))[..3]);
        }
    });
    let mut raster = Raster { width, height, rgb };
    if overlay == Overlay::Rivers {
        draw_rivers(bake, &mut raster);
    }
    raster
}

fn direction(x: f64, y: f64, width: u32, height: u32) -> DVec3 {
    let (lat, lon) = (90.0 - 180.0 * y / f64::from(height), 360.0 * x / f64::from(width) - 180.0);
    math::direction(lat, lon)
}

/// The colour at a place of the base mesh, rivers apart.
fn color_at(overlay: Overlay, bake: &Bake, at: &Location) -> Rgba {
    let (climate, drainage) = (&bake.climate, &bake.drainage);
    let mean = |column: &[f32]| at.interpolate(|i| f64::from(column[i as usize])) as f32;
    let i = at.nearest as usize;
    let ground = at.interpolate(|k| f64::from(drainage.ground[k as usize]));
    let backdrop = if ground < 0.0 && drainage.sites[i] != Site::Land { SEA } else { LAND };
    match overlay {
        Overlay::Temperature => {
            palette::TEMPERATURE.within(mean(&climate.temperature), TEMPERATURE.0, TEMPERATURE.1)
        }
        Overlay::Rain => palette::RAIN.at(mean(&climate.rain) / RAIN_MAX),
        Overlay::Wetness => palette::RAIN.at(mean(&climate.wetness)),
        Overlay::Basins if backdrop == LAND && drainage.basin[i] != NONE => {
            let color = palette::distinct(mix(u64::from(drainage.basin[i])) as u32);
            if drainage.is_endorheic(i) { palette::mix(color, CLOSED, 0.6) } else { color }
        }
        Overlay::Rivers | Overlay::Lakes => {
            drainage.lake_kind(i).map_or(backdrop, |kind| LAKE[kind as usize])
        }
        Overlay::Basins => backdrop,
        _ => field::NO_VALUE_LAND,
    }
}

/// Whether vertex `i` of the base mesh is a river on the map.
fn is_drawn(bake: &Bake, i: usize) -> bool {
    bake.drainage.strahler[i] >= LOWEST_ORDER && !bake.drainage.is_lake(i)
}

/// A stretch of a river along an edge of the base mesh.
pub(crate) struct Stretch {
    /// Horton–Strahler order.
    pub(crate) order: u8,
    /// Vertices of the base mesh, downstream.
    pub(crate) ends: [u32; 2],
}

impl Stretch {
    /// Half its width relative to that of the lowest order.
    pub(crate) fn half_width(&self) -> f64 {
        0.2 * f64::from(self.order - LOWEST_ORDER)
    }
}

/// All rivers that are drawn, low orders first.
pub(crate) fn rivers(bake: &Bake) -> Vec<Stretch> {
    let drainage = &bake.drainage;
    let drawn = drainage.routes.order.iter().filter(|&&i| is_drawn(bake, i as usize));
    let stretch = |&i: &u32| {
        let to = drainage.routes.receiver[i as usize];
        (to != NONE).then_some(Stretch { order: drainage.strahler[i as usize], ends: [i, to] })
    };
    let mut rivers: Vec<_> = drawn.filter_map(stretch).collect();
    rivers.sort_by_key(|stretch| stretch.order);
    rivers
}

/// Draws rivers as lines.
fn draw_rivers(bake: &Bake, raster: &mut Raster) {
    let (width, height) = (f64::from(raster.width), f64::from(raster.height));
    let pixel = |i: u32| {
        let (lat, lon) = math::lat_lon(bake.mesh().point(i));
        ((lon + 180.0) / 360.0 * width, (90.0 - lat) / 180.0 * height)
    };
    for stretch in rivers(bake) {
        let [from, to] = stretch.ends.map(pixel);
        let half = stretch.half_width() * width / 2048.0;
        line(raster, from, to, half, order_color(stretch.order));
    }
}

/// A line between two points in pixels, the short way around the date line.
fn line(raster: &mut Raster, from: (f64, f64), to: (f64, f64), half: f64, color: Rgba) {
    let width = f64::from(raster.width);
    let turn = ((to.0 - from.0) / width).round() * width;
    let (dx, dy) = (to.0 - turn - from.0, to.1 - from.1);
    let steps = (2.0 * dx.abs().max(dy.abs())).ceil().max(1.0);
    for step in 0..=steps as u32 {
        let t = f64::from(step) / steps;
        let (x, y) = (from.0 + t * dx, from.1 + t * dy);
        for row in (y - half).floor() as i64..=(y + half).floor() as i64 {
            for column in (x - half).floor() as i64..=(x + half).floor() as i64 {
                if (0..i64::from(raster.height)).contains(&row) {
                    let column = column.rem_euclid(i64::from(raster.width));
                    let place = 3 * (row * i64::from(raster.width) + column) as usize;
                    raster.rgb[place..place + 3].copy_from_slice(&color[..3]);
                }
            }
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::climate::EquirectMap;
    use crate::control::{BakeFrame, BakeRules, BakeSource};
    use crate::hydrology::TerrainMaps;
    use std::sync::Arc;

    /// A planet whose northern half is a slope down to the equator.
    pub(crate) fn bake() -> Bake {
        let crust = EquirectMap::from_fn(64, |lat, _| (lat / 30.0) as f32).unwrap();
        let maps = TerrainMaps { crust, age: None, plateau: None, hills: None };
        let frame = Arc::new(BakeFrame::new(1, 0.04, None).unwrap());
        Bake::new(&frame, 6370.0, &BakeSource::Maps(&maps), &BakeRules::default()).unwrap()
    }

    #[test]
    fn maps_show_the_sea_the_rivers_and_the_basins() {
        let bake = bake();
        let at = |raster: &Raster, x: u32, y: u32| {
            let k = 3 * (y * raster.width + x) as usize;
            [raster.rgb[k], raster.rgb[k + 1], raster.rgb[k + 2], 255]
        };
        let rivers = draw(Overlay::Rivers, &bake, 128, 64);
        assert_eq!(at(&rivers, 30, 50), SEA);
        let blue = (0..128).flat_map(|x| (0..32).map(move |y| (x, y))).filter(|&(x, y)| {
            let color = at(&rivers, x, y);
            (2..8).any(|order| color == order_color(order))
        });
        assert!(blue.count() > 100);
        let basins = draw(Overlay::Basins, &bake, 128, 64);
        let land = (0..128).flat_map(|x| (0..32).map(move |y| (x, y)));
        let colors: std::collections::BTreeSet<_> = land.map(|(x, y)| at(&basins, x, y)).collect();
        assert!(colors.len() > 5, "{}", colors.len());
        let warm = draw(Overlay::Temperature, &bake, 128, 64);
        assert!(at(&warm, 5, 32)[0] > at(&warm, 5, 1)[0], "the equator is redder than the pole");
    }

    #[test]
    fn samples_have_the_colours_of_their_places() {
        let bake = bake();
        let lattice = SphereMesh::fibonacci(500).unwrap();
        for overlay in Overlay::ALL.into_iter().filter(|overlay| is_baked(*overlay)) {
            let colors = colors(overlay, &bake, &lattice);
            assert_eq!(colors.len(), 500);
            assert!(colors.iter().any(|color| *color != colors[0]), "{overlay:?}");
        }
    }
}
