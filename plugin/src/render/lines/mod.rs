//! Lines on a globe: plate boundaries by kind, the outline of the selected plate, arrows of
//! velocity, axes of folding and of ridges, rivers of a bake.

mod arrows;
mod boundaries;
mod ground;
mod list;

pub(super) use list::{COLOR, HEIGHTS, Lines, OTHER, SIDE};

use super::globe::Globe;
use crate::control::Bake;
use crate::overlay::{Overlay, OverlayInput, rivers};
use ground::LineGround;
use list::LineStyle;

/// Half width in pixels of a river of the lowest order that is drawn.
const RIVER_HALF_WIDTH: f32 = 0.45;
/// How much wider a river grows than on a map.
const RIVER_GROWTH: f32 = 1.6;

/// All lines that `globe` asks for, on ground of the `elevation` in km at which samples are drawn.
pub(super) fn collect(
    input: &OverlayInput,
    globe: &Globe,
    elevation: impl Fn(usize) -> f32,
) -> Lines {
    let mut lines = Lines::default();
    let ground = LineGround {
        input,
        globe,
        elevation: &elevation,
    };
    if globe.boundaries || globe.overlay == Overlay::Plates || globe.selected.is_some() {
        boundaries::add_boundaries(&mut lines, &ground);
    }
    let crust = &input.surface.crust;
    match globe.overlay {
        Overlay::Velocity => arrows::add_velocities(&mut lines, &ground),
        Overlay::FoldDirection => arrows::add_axes(&mut lines, &ground, &crust.fold),
        Overlay::RidgeDirection => arrows::add_axes(&mut lines, &ground, &crust.ridge),
        _ => {
            if let Some(bake) = input.bake {
                add_rivers(&mut lines, &ground, bake);
            }
        }
    }
    lines
}

/// Adds the rivers of the globe's overlay.
fn add_rivers(lines: &mut Lines, ground: &LineGround, bake: &Bake) {
    for reach in rivers::reaches(ground.globe.overlay, bake) {
        let [from, to] = reach.ends.map(|i| ground.end(bake.mesh().point(i)));
        let style = LineStyle {
            half_width: RIVER_HALF_WIDTH + RIVER_GROWTH * reach.half_width() as f32,
            color: reach.color,
        };
        lines.add(from, to, style);
    }
}

#[cfg(test)]
mod tests;
