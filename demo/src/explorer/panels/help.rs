//! The page of keys.

use crate::explorer::style::{ACCENT, BRIGHT, FAINT, FIELD, TEXT, floating_frame};
use bevy_egui::egui::{Button, Context, Frame, Grid, Id, Margin, Modal, RichText, Ui, vec2};

/// Groups of keys, each with its meaning.
const KEYS: [(&str, &[(&str, &str)]); 4] = [
    (
        "Time",
        &[
            ("Space", "play or pause"),
            ("S", "single step"),
            ("N", "grow the planet of the form"),
        ],
    ),
    (
        "Globe",
        &[
            ("Drag, arrows", "turn the globe"),
            ("Wheel, Page up/down", "zoom, from orbit down to the ground"),
            ("Right drag, near the ground", "look around"),
            ("1 … 9, 0", "choose an overlay"),
            (",  .", "previous, next overlay"),
            ("+  -", "exaggerate the relief"),
            ("W", "sea on or off"),
            ("M", "triangles on or off"),
            ("P", "plate boundaries on or off"),
        ],
    ),
    (
        "Plates",
        &[
            ("Click", "select a plate"),
            ("Shift+drag", "set the motion of a plate"),
            ("B", "take the brush or put it down"),
            ("Esc", "end a tool, deselect"),
        ],
    ),
    (
        "Files",
        &[
            ("F2", "picture of the window"),
            ("F5", "save"),
            ("F9", "load"),
            ("F1, H", "this page"),
        ],
    ),
];

/// Draws the page over everything while `open`.
pub fn show(ctx: &Context, open: &mut bool) {
    if !*open {
        return;
    }
    let frame = floating_frame().inner_margin(Margin::same(20));
    let page = Modal::new(Id::new("help")).frame(frame).show(ctx, page);
    *open = !page.should_close();
}

fn page(ui: &mut Ui) {
    let subtitle = "A planet of drifting plates. Drag one with Shift to set its motion.";
    ui.label(RichText::new("Pangaea").size(20.0).strong().color(BRIGHT));
    ui.label(RichText::new(subtitle).color(FAINT));
    ui.add_space(8.0);
    ui.horizontal_top(|ui| {
        for column in KEYS.chunks(2) {
            ui.vertical(|ui| {
                for (title, keys) in column {
                    group(ui, title, keys);
                }
            });
            ui.add_space(18.0);
        }
    });
    ui.add_space(6.0);
    let close = ui.add_sized(vec2(70.0, 24.0), Button::new("Close"));
    if close.clicked() {
        ui.close();
    }
}

fn group(ui: &mut Ui, title: &str, keys: &[(&str, &str)]) {
    ui.label(RichText::new(title).strong().color(ACCENT));
    Grid::new(title)
        .num_columns(2)
        .spacing(vec2(14.0, 5.0))
        .show(ui, |ui| {
            for (key, meaning) in keys {
                Frame::new()
                    .fill(FIELD)
                    .corner_radius(3)
                    .inner_margin(Margin::symmetric(6, 1))
                    .show(ui, |ui| {
                        ui.label(RichText::new(*key).monospace().color(BRIGHT));
                    });
                ui.label(RichText::new(*meaning).color(TEXT));
                ui.end_row();
            }
        });
    ui.add_space(8.0);
}
