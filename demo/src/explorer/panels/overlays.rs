//! The overlay, and how the globe is drawn.

use crate::explorer::state::{EXAGGERATION_LIMITS, Look};
use crate::explorer::widgets::{field, toggle_button};
use bevy_egui::egui::{Align, Layout, Slider, Ui, vec2};
use bevy_pangaea::overlay::Overlay;

/// Draws the panel.
pub fn show(ui: &mut Ui, look: &mut Look) {
    ui.spacing_mut().item_spacing.y = 4.0;
    for (line, pair) in Overlay::ALL.chunks(2).enumerate() {
        overlay_line(ui, 2 * line + 1, pair, &mut look.overlay);
    }
    ui.add_space(4.0);
    field(ui, "Relief", |ui| {
        exaggeration(ui, &mut look.exaggeration);
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

/// Two overlays beside each other, of which the left one has the number `first`.
fn overlay_line(ui: &mut Ui, first: usize, pair: &[Overlay], chosen: &mut Overlay) {
    let width = (ui.available_width() - ui.spacing().item_spacing.x) / 2.0;
    let layout = Layout::top_down_justified(Align::LEFT);
    ui.horizontal(|ui| {
        for (number, &overlay) in (first..).zip(pair) {
            ui.allocate_ui_with_layout(vec2(width, 21.0), layout, |ui| {
                let button = toggle_button(ui, *chosen == overlay, overlay.label());
                if button.on_hover_text(key_hint(number)).clicked() {
                    *chosen = overlay;
                }
            });
        }
    });
}

/// The keys that choose overlay `number`, counted from 1.
fn key_hint(number: usize) -> String {
    match number {
        1..=10 => format!("Key {}", number % 10),
        _ => "Comma and full stop step through all".into(),
    }
}

fn exaggeration(ui: &mut Ui, exaggeration: &mut f32) {
    ui.spacing_mut().slider_width = 100.0;
    let (least, most) = EXAGGERATION_LIMITS;
    let slider = Slider::new(exaggeration, least..=most)
        .max_decimals(0)
        .suffix(" ×");
    ui.add(slider)
        .on_hover_text("Exaggeration of the relief (+ and -); 1 is true to scale");
}
