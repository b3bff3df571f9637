//! Rivers as lines along the edges of the base mesh, on maps as on globes: as wide as their order,
//! in the colour of their order or of their discharge.

use super::Overlay;
use super::discharge::discharge_color;
use super::palette::{self, Rgba};
use super::raster::Raster;
use crate::control::Bake;
use crate::hydrology::{Drainage, NO_VERTEX};
use crate::math;
use bevy::math::DVec3;

/// Lowest Horton–Strahler order of a river that is drawn.
const LOWEST_ORDER: u8 = 2;

/// Least discharge that has a line, m³/s as it would be on an Earth-sized planet: paler lines would
/// be lighter than the shaded ground of a globe.
const LEAST_DISCHARGE: f64 = 100.0;

/// Width in pixels of the map on which [`RiverReach::half_width`] is in pixels.
const REFERENCE_WIDTH: f64 = 2048.0;

/// The colour of a river's order: the higher, the deeper and the darker.
pub(crate) fn order_color(order: u8) -> Rgba {
    let t = (f32::from(order.max(1)) - 1.0) / 6.0;
    palette::mix([122, 170, 208, 255], [10, 40, 110, 255], t)
}

/// A reach of a river along an edge of the base mesh.
pub(crate) struct RiverReach {
    /// Horton–Strahler order.
    pub(crate) order: u8,
    /// Vertices of the base mesh, downstream.
    pub(crate) ends: [u32; 2],
    /// Colour of its order or its discharge.
    pub(crate) color: Rgba,
}

impl RiverReach {
    /// The reach that begins at vertex `i`; `None` where water goes no further.
    fn from_vertex(drainage: &Drainage, i: u32, color: Rgba) -> Option<Self> {
        let to = drainage.routes.receiver[i as usize];
        (to != NO_VERTEX).then_some(Self {
            order: drainage.strahler[i as usize],
            ends: [i, to],
            color,
        })
    }

    /// How much half its width exceeds that of the lowest order.
    pub(crate) fn half_width(&self) -> f64 {
        0.2 * f64::from(self.order - LOWEST_ORDER)
    }
}

/// The rivers that an overlay draws, low orders first; empty for overlays without rivers.
pub(crate) fn reaches(overlay: Overlay, bake: &Bake) -> Vec<RiverReach> {
    let drainage = &bake.drainage;
    let upstream_first = drainage.routes.order.iter().copied();
    let mut reaches: Vec<_> = upstream_first
        .filter(|&i| is_drawn(drainage, i as usize))
        .filter_map(|i| {
            let color = river_color(overlay, drainage, i as usize)?;
            RiverReach::from_vertex(drainage, i, color)
        })
        .collect();
    // Large rivers lie on top. A stable sort: reaches of one order stay upstream first.
    reaches.sort_by_key(|reach| reach.order);
    reaches
}

/// Whether vertex `i` of the base mesh lies on a river of the map.
fn is_drawn(drainage: &Drainage, i: usize) -> bool {
    drainage.strahler[i] >= LOWEST_ORDER && !drainage.is_lake(i)
}

/// The colour in which an overlay draws the river at vertex `i`, if it does.
fn river_color(overlay: Overlay, drainage: &Drainage, i: usize) -> Option<Rgba> {
    match overlay {
        Overlay::Rivers => Some(order_color(drainage.strahler[i])),
        Overlay::Drainage => {
            let discharge = drainage.earth_like_discharge(i);
            (discharge >= LEAST_DISCHARGE).then(|| discharge_color(discharge))
        }
        _ => None,
    }
}

/// Draws the rivers of an overlay as lines.
pub(super) fn draw(overlay: Overlay, bake: &Bake, raster: &mut Raster) {
    let size = [raster.width, raster.height].map(f64::from);
    for reach in reaches(overlay, bake) {
        let [from, to] = reach.ends.map(|i| pixel(bake.mesh().point(i), size));
        let half = reach.half_width() * size[0] / REFERENCE_WIDTH;
        line(raster, from, to, half, reach.color);
    }
}

/// The place of a direction on a map of this size, in pixels.
fn pixel(direction: DVec3, [width, height]: [f64; 2]) -> (f64, f64) {
    let (lat, lon) = math::lat_lon(direction);
    ((lon + 180.0) / 360.0 * width, (90.0 - lat) / 180.0 * height)
}

/// A line between two points in pixels, the short way around the date line.
fn line(raster: &mut Raster, from: (f64, f64), to: (f64, f64), half: f64, color: Rgba) {
    let width = f64::from(raster.width);
    // A line that spans more than half of the map goes the other way.
    let turn = ((to.0 - from.0) / width).round() * width;
    let (dx, dy) = (to.0 - turn - from.0, to.1 - from.1);
    // Two squares a pixel leave no gaps.
    let steps = (2.0 * dx.abs().max(dy.abs())).ceil().max(1.0);
    for step in 0..=steps as u32 {
        let t = f64::from(step) / steps;
        fill_square(raster, (from.0 + t * dx, from.1 + t * dy), half, color);
    }
}

/// Fills the pixels up to `half` from a point. Columns go on around the date line, rows end at the
/// poles.
fn fill_square(raster: &mut Raster, (x, y): (f64, f64), half: f64, color: Rgba) {
    let (width, height) = (i64::from(raster.width), i64::from(raster.height));
    let rows = (y - half).floor() as i64..=(y + half).floor() as i64;
    for row in rows.filter(|row| (0..height).contains(row)) {
        for column in (x - half).floor() as i64..=(x + half).floor() as i64 {
            let place = 3 * (row * width + column.rem_euclid(width)) as usize;
            raster.rgb[place..place + 3].copy_from_slice(&color[..3]);
        }
    }
}
