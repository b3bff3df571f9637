//! What the globe shows.

use crate::explorer::state::{EXAGGERATION_LIMITS, Look};
use crate::explorer::style::{field, toggle_button};
use bevy_egui::egui::{Slider, Ui};
use bevy_pangaea::overlay::Overlay;

/// Draws the panel.
pub fn show(ui: &mut Ui, look: &mut Look) {
    ui.spacing_mut().item_spacing.y = 4.0;
    let width = (ui.available_width() - ui.spacing().item_spacing.x) / 2.0;
    for (line, pair) in Overlay::ALL.chunks(2).enumerate() {
        ui.horizontal(|ui| {
            for (column, &overlay) in pair.iter().enumerate() {
                let number = 2 * line + column + 1;
                ui.allocate_ui_with_layout(
                    bevy_egui::egui::vec2(width, 21.0),
                    bevy_egui::egui::Layout::top_down_justified(bevy_egui::egui::Align::LEFT),
                    |ui| {
                        let button = toggle_button(ui, look.overlay == overlay, overlay.label());
                        let button = match key_of(number) {
                            Some(key) => button.on_hover_text(format!("Key {key}")),
                            None => button.on_hover_text("Comma and full stop step through all"),
                        };
                        if button.clicked() {
                            look.overlay = overlay;
                        }
                    },
                );
            }
        });
    }
    ui.add_space(4.0);
    field(ui, "Relief", |ui| {
        ui.spacing_mut().slider_width = 100.0;
        let slider = Slider::new(
            &mut look.exaggeration,
            EXAGGERATION_LIMITS.0..=EXAGGERATION_LIMITS.1,
        );
        ui.add(slider.max_decimals(0).suffix(" ×"))
            .on_hover_text("Exaggeration of the relief (+ and -); 1 is true to scale")
    });
    ui.columns_const(|[left, right]| {
        left.checkbox(&mut look.sea, "Sea");
        left.checkbox(&mut look.boundaries, "Boundaries");
        left.checkbox(&mut look.wireframe, "Triangles");
        right.checkbox(&mut look.air, "Air");
        right
            .checkbox(&mut look.sun_follows, "Sun follows")
            .on_hover_text("The sun stays behind you; off, it stands still");
    });
}

/// The key that chooses overlay `number`, counted from 1.
fn key_of(number: usize) -> Option<usize> {
    match number {
        1..=9 => Some(number),
        10 => Some(0),
        _ => None,
    }
}
