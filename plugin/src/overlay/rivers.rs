//! Rivers as lines along the edges of the base mesh, on maps as on globes: as wide as their order,
//! in the colour of their order or of their discharge.

use super::map::Raster;
use super::palette::{self, Rgba};
use super::{Overlay, ground};
use crate::control::Bake;
use crate::hydrology::{Drainage, NO_VERTEX};
use crate::math;

/// Lowest order of a river that is drawn.
const LOWEST_ORDER: u8 = 2;

/// Least discharge that has a line, m³/s as it would be on an Earth-sized planet: paler lines would
/// be lighter than the shaded ground of a globe.
const SMALLEST_LINE: f64 = 100.0;

/// The colour of a river's order: the higher, the deeper and the darker.
pub(crate) fn order_color(order: u8) -> Rgba {
    let t = (f32::from(order.max(1)) - 1.0) / 6.0;
    palette::mix([122, 170, 208, 255], [10, 40, 110, 255], t)
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
    /// Colour of its order or its discharge.
    pub(crate) color: Rgba,
}

impl Stretch {
    /// Half its width relative to that of the lowest order.
    pub(crate) fn half_width(&self) -> f64 {
        0.2 * f64::from(self.order - LOWEST_ORDER)
    }
}

/// The rivers that an overlay draws, low orders first; none on overlays that show none.
pub(crate) fn stretches(overlay: Overlay, bake: &Bake) -> Vec<Stretch> {
    let drainage = &bake.drainage;
    let (color, least): (fn(&Drainage, usize) -> Rgba, f64) = match overlay {
        Overlay::Rivers => (|drainage, i| order_color(drainage.strahler[i]), 0.0),
        Overlay::Drainage => (
            |drainage, i| ground::discharge_color(drainage.earth_like_discharge(i)),
            SMALLEST_LINE,
        ),
        _ => return Vec::new(),
    };
    let large = |i: usize| drainage.earth_like_discharge(i) >= least;
    let drawn = drainage
        .routes
        .order
        .iter()
        .filter(|&&i| is_drawn(bake, i as usize) && large(i as usize));
    let stretch = |&i: &u32| {
        let (to, order) = (
            drainage.routes.receiver[i as usize],
            drainage.strahler[i as usize],
        );
        let color = color(drainage, i as usize);
        (to != NO_VERTEX).then_some(Stretch {
            order,
            ends: [i, to],
            color,
        })
    };
    let mut stretches: Vec<_> = drawn.filter_map(stretch).collect();
    stretches.sort_by_key(|stretch| stretch.order);
    stretches
}

/// Draws the rivers of an overlay as lines.
pub(super) fn draw(overlay: Overlay, bake: &Bake, raster: &mut Raster) {
    let (width, height) = (f64::from(raster.width), f64::from(raster.height));
    let pixel = |i: u32| {
        let (lat, lon) = math::lat_lon(bake.mesh().point(i));
        ((lon + 180.0) / 360.0 * width, (90.0 - lat) / 180.0 * height)
    };
    for stretch in stretches(overlay, bake) {
        let [from, to] = stretch.ends.map(pixel);
        let half = stretch.half_width() * width / 2048.0;
        line(raster, from, to, half, stretch.color);
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
