//! Milliseconds per stage and per frame.

use super::Outbox;
use crate::explorer::state::View;
use crate::explorer::style::{ACCENT, FIELD, hint, row};
use bevy::prelude::{Res, ResMut, Resource, Time};
use bevy_egui::egui::{Align2, CornerRadius, FontId, Rect, Sense, Ui, pos2, vec2};
use bevy_pangaea::prelude::*;
use egui_plot::{Line, Plot, PlotPoints};
use std::collections::VecDeque;

/// Frames that are remembered.
const FRAMES: usize = 180;

/// Wall-clock time of the last frames in ms.
#[derive(Resource, Default)]
pub struct FrameTimes(VecDeque<f64>);

impl FrameTimes {
    /// Mean of the last frames in ms.
    pub fn mean(&self) -> f64 {
        let recent = self.0.iter().rev().take(30);
        recent.clone().sum::<f64>() / recent.count().max(1) as f64
    }

    fn longest(&self) -> f64 {
        self.0.iter().copied().fold(0.0, f64::max)
    }
}

/// Remembers the time of the last frame.
pub fn watch(time: Res<Time<bevy::time::Real>>, mut frames: ResMut<FrameTimes>) {
    if frames.0.len() == FRAMES {
        frames.0.pop_front();
    }
    frames.0.push_back(time.delta_secs_f64() * 1e3);
}

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &View, frames: &FrameTimes, out: &mut Outbox) {
    let timings = view.timings;
    row(ui, "Frame, mean", format!("{:.1} ms", frames.mean()));
    row(
        ui,
        "Frame, longest of 180",
        format!("{:.1} ms", frames.longest()),
    );
    frame_plot(ui, frames);
    let longest = timings.last_ms.iter().copied().fold(0.1, f64::max);
    for (stage, &ms) in Stage::ALL.iter().zip(&timings.last_ms) {
        bar(ui, stage.name(), ms, longest);
    }
    ui.add_space(3.0);
    row(ui, "Last step", format!("{:.1} ms", timings.last_step_ms()));
    row(ui, "Mean step", format!("{:.1} ms", timings.step_mean_ms()));
    row(ui, "Longest step", format!("{:.1} ms", timings.step_max_ms));
    row(ui, "Resampling", mean_of(timings.resample));
    row(ui, "Rifting", mean_of(timings.rift));
    hint(ui, "Steps without resampling and rifting.");
    if ui
        .button("Resample now")
        .on_hover_text("Even samples and new ocean crust at the next step")
        .clicked()
    {
        out.command(TectonicCommand::Resample);
    }
}

fn mean_of((count, total): (u32, f64)) -> String {
    if count == 0 {
        "none yet".into()
    } else {
        format!("{:.1} ms × {count}", total / f64::from(count))
    }
}

/// The stage's name, its time, and a bar behind both.
fn bar(ui: &mut Ui, name: &str, ms: f64, longest: f64) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 15.0), Sense::hover());
    let share = (ms / longest).clamp(0.0, 1.0) as f32;
    let filled = Rect::from_min_max(
        rect.min,
        pos2(rect.left() + rect.width() * share, rect.bottom()),
    );
    let (painter, text) = (ui.painter(), ui.visuals().text_color());
    painter.rect_filled(rect, CornerRadius::same(2), ui.visuals().faint_bg_color);
    painter.rect_filled(filled, CornerRadius::same(2), FIELD);
    let font = FontId::proportional(11.0);
    painter.text(
        rect.left_center() + vec2(5.0, 0.0),
        Align2::LEFT_CENTER,
        name,
        font.clone(),
        text,
    );
    let label = format!("{ms:.2} ms");
    painter.text(
        rect.right_center() - vec2(5.0, 0.0),
        Align2::RIGHT_CENTER,
        label,
        font,
        text,
    );
}

fn frame_plot(ui: &mut Ui, frames: &FrameTimes) {
    let points: PlotPoints = frames
        .0
        .iter()
        .enumerate()
        .map(|(i, &ms)| [i as f64, ms])
        .collect();
    Plot::new("frames")
        .height(54.0)
        .show_x(false)
        .show_axes([false, true])
        .show_grid([false, true])
        .include_y(0.0)
        .include_x(FRAMES as f64)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .y_axis_min_width(26.0)
        .show(ui, |plot| plot.line(Line::new("ms", points).color(ACCENT)));
}
