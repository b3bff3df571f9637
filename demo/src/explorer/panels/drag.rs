//! The motion that a plate gets by the drag under way, beside the pointer.

use crate::explorer::drag::{DraggedMotion, motion_at};
use crate::explorer::state::{PlateDrag, Pointer};
use crate::explorer::style::{BRIGHT, FAINT, floating_frame};
use crate::explorer::text;
use crate::explorer::view::ShownView;
use bevy_egui::egui::{Align2, Area, Context, Id, Order, Pos2, Rect, RichText, Ui, vec2};

/// How far below the pointer the text stands, in points.
const TEXT_OFFSET: f32 = 18.0;
/// Room for the text below the pointer, in points; with less it stands above.
const TEXT_HEIGHT: f32 = 64.0;

/// Draws the text while a plate is dragged.
pub fn show(ctx: &Context, free: Rect, view: &ShownView, drag: &PlateDrag, pointer: &Pointer) {
    let Some(dragged) = drag.0 else { return };
    let Some(at) = ctx.input(|input| input.pointer.latest_pos()) else {
        return;
    };
    let motion = pointer
        .ground
        .and_then(|ground| motion_at(dragged, ground, view));
    let (pivot, corner) = place(at, free);
    Area::new(Id::new("drag"))
        .order(Order::Tooltip)
        .interactable(false)
        .pivot(pivot)
        .fixed_pos(corner)
        .constrain_to(free)
        .show(ctx, |ui| {
            floating_frame().show(ui, |ui| describe(ui, view, motion));
        });
}

/// The edge of the text that stands near the pointer, and where.
fn place(at: Pos2, free: Rect) -> (Align2, Pos2) {
    if at.y + TEXT_OFFSET + TEXT_HEIGHT < free.bottom() {
        (Align2::CENTER_TOP, at + vec2(0.0, TEXT_OFFSET))
    } else {
        (Align2::CENTER_BOTTOM, at - vec2(0.0, TEXT_OFFSET))
    }
}

fn describe(ui: &mut Ui, view: &ShownView, motion: Option<DraggedMotion>) {
    let Some(DraggedMotion { pole, speed }) = motion else {
        ui.label(RichText::new("Release to leave the motion as it is").color(FAINT));
        return;
    };
    let limit = if speed < view.params.max_speed {
        ""
    } else {
        ", the fastest"
    };
    let speed = format!("{speed:.1} km/My{limit}");
    ui.label(RichText::new(speed).monospace().color(BRIGHT));
    let pole = format!("about {}", text::place(pole));
    ui.label(RichText::new(pole).monospace().color(FAINT));
}
