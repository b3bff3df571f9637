//! The log, and the strip of its latest entries over the globe.

use crate::explorer::messages::{Entry, MessageLog, Tone};
use crate::explorer::style::{BRIGHT, ERROR, FAINT, TEXT, floating_frame};
use crate::explorer::widgets::hint;
use bevy_egui::egui::{
    Align2, Area, Color32, Context, Id, Label, Order, Rect, RichText, ScrollArea, Stroke, Ui, vec2,
};

/// Draws the log.
pub fn show(ui: &mut Ui, messages: &mut MessageLog) {
    if messages.entries().next().is_none() {
        hint(ui, "Collisions, rifts and errors will be listed here.");
        return;
    }
    ScrollArea::vertical()
        .max_height(190.0)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            for entry in messages.entries() {
                line(ui, entry);
            }
        });
    if ui.small_button("Clear").clicked() {
        messages.clear();
    }
}

fn line(ui: &mut Ui, entry: &Entry) {
    let time = entry
        .time
        .map_or(String::new(), |time| format!("{time:.0} My  "));
    let times = if entry.times > 1 {
        format!("  ×{}", entry.times)
    } else {
        String::new()
    };
    let text = RichText::new(format!("{time}{}{times}", entry.text)).size(11.0);
    ui.add(Label::new(text.color(color(entry.tone))).wrap());
}

fn color(tone: Tone) -> Color32 {
    match tone {
        Tone::Event => FAINT,
        Tone::Note => TEXT,
        Tone::Error => ERROR,
    }
}

/// Draws the latest notes and errors at the upper edge of the free area.
pub fn strip(ctx: &Context, free: Rect, messages: &MessageLog) {
    if messages.strip().next().is_none() {
        return;
    }
    Area::new(Id::new("strip"))
        .order(Order::Foreground)
        .interactable(false)
        .pivot(Align2::CENTER_TOP)
        .fixed_pos(free.center_top() + vec2(0.0, 12.0))
        .show(ctx, |ui| {
            ui.set_max_width(free.width() - 60.0);
            ui.vertical_centered(|ui| {
                for entry in messages.strip() {
                    notice(ui, entry);
                }
            });
        });
}

fn notice(ui: &mut Ui, entry: &Entry) {
    let (color, frame) = match entry.tone {
        Tone::Error => (ERROR, floating_frame().stroke(Stroke::new(1.0, ERROR))),
        _ => (BRIGHT, floating_frame()),
    };
    frame.show(ui, |ui| {
        ui.add(Label::new(RichText::new(&entry.text).color(color)).wrap())
    });
}
