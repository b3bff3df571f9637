//! The bar at the bottom: what runs, what is under way, how fast.

use crate::explorer::session::Session;
use crate::explorer::state::{Tool, View};
use crate::explorer::style::{ACCENT, BRIGHT, FAINT, GOOD};
use crate::explorer::text;
use bevy_egui::egui::{Align, Color32, Layout, RichText, Spinner, Ui};

/// Draws the bar.
pub fn show(ui: &mut Ui, view: Option<&View>, session: &Session, tool: &Tool, frame_ms: f64) {
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 14.0;
        if let Some(view) = view {
            let (state, color) = if view.controls.paused {
                ("⏸ paused", FAINT)
            } else {
                ("▶ running", GOOD)
            };
            part(ui, state, color);
            part(ui, &format!("{:.1} My", view.clock.time), BRIGHT);
            part(ui, &format!("{} plates", view.plates.rows().len()), FAINT);
            part(
                ui,
                &format!("{} samples", text::count(view.mesh.len())),
                FAINT,
            );
        }
        if let Some(what) = session.busy() {
            ui.add(Spinner::new().size(13.0).color(ACCENT));
            part(ui, &format!("{what} …"), ACCENT);
        }
        match tool {
            Tool::Select => {}
            Tool::Paint => part(ui, "Click paints · Esc ends", ACCENT),
            Tool::RiftLine { points, .. } => {
                part(
                    ui,
                    &format!(
                        "Click adds a point to the rift line ({}) · Esc ends",
                        points.len()
                    ),
                    ACCENT,
                );
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            part(ui, "F1 help", FAINT);
            part(ui, &format!("{:.0} fps", 1000.0 / frame_ms.max(0.1)), FAINT);
            part(ui, &format!("{frame_ms:.1} ms per frame"), FAINT);
        });
    });
}

fn part(ui: &mut Ui, text: &str, color: Color32) {
    ui.label(RichText::new(text).size(11.5).color(color));
}
