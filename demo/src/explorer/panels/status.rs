//! The bar at the bottom: the clock, the work under way, the use of the mouse, the frame rate.

use crate::explorer::session::Session;
use crate::explorer::state::{PlateDrag, Tool};
use crate::explorer::style::{ACCENT, BRIGHT, FAINT, GOOD};
use crate::explorer::text;
use crate::explorer::view::ShownView;
use bevy_egui::egui::{Align, Color32, Layout, RichText, Spinner, Ui};

/// Draws the bar.
pub fn show(
    ui: &mut Ui,
    view: Option<&ShownView>,
    session: &Session,
    tool_hint: Option<&str>,
    frame_ms: f64,
) {
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 14.0;
        if let Some(view) = view {
            planet(ui, view);
        }
        if let Some(what) = session.busy() {
            ui.add(Spinner::new().size(13.0).color(ACCENT));
            part(ui, &format!("{what} …"), ACCENT);
        }
        if let Some(hint) = tool_hint {
            part(ui, hint, ACCENT);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let rate = 1000.0 / frame_ms.max(0.1);
            part(ui, "F1 help", FAINT);
            part(ui, &format!("{rate:.0} fps"), FAINT);
            part(ui, &format!("{frame_ms:.1} ms per frame"), FAINT);
        });
    });
}

fn planet(ui: &mut Ui, view: &ShownView) {
    let (state, color) = if view.controls.paused {
        ("⏸ paused", FAINT)
    } else {
        ("▶ running", GOOD)
    };
    let plates = view.plates.rows().len();
    let samples = text::count(view.mesh.len());
    part(ui, state, color);
    part(ui, &format!("{:.1} My", view.clock.time), BRIGHT);
    part(ui, &format!("{plates} plates"), FAINT);
    part(ui, &format!("{samples} samples"), FAINT);
}

/// The use of the mouse in words, where it is not to select.
pub fn tool_hint(tool: &Tool, drag: &PlateDrag) -> Option<String> {
    match tool {
        Tool::Select if drag.0.is_some() => {
            Some("Release sets the motion of the plate · Esc leaves it".into())
        }
        Tool::Select => None,
        Tool::Paint => Some("Click paints · Esc ends".into()),
        Tool::RiftLine { points, .. } => {
            let count = points.len();
            Some(format!(
                "Click adds a point to the rift line ({count}) · Esc ends"
            ))
        }
    }
}

fn part(ui: &mut Ui, text: &str, color: Color32) {
    ui.label(RichText::new(text).size(11.5).color(color));
}
