//! Milliseconds per stage and per frame.

use super::Outbox;
use crate::explorer::style::{ACCENT, FIELD};
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{button, hint, row};
use bevy::prelude::{Res, ResMut, Resource, Time};
use bevy_egui::egui::{Align2, CornerRadius, FontId, Sense, Ui, vec2};
use bevy_pangaea::prelude::*;
use egui_plot::{Line, Plot, PlotPoints};
use std::collections::VecDeque;

/// Frames whose times are kept.
const KEPT_FRAMES: usize = 180;
/// Frames over which the mean is taken.
const MEAN_FRAMES: usize = 30;

/// Wall-clock time of the last frames in ms.
#[derive(Resource, Default)]
pub struct FrameTimes(VecDeque<f64>);

impl FrameTimes {
    /// Mean of the last frames in ms.
    pub fn mean(&self) -> f64 {
        let recent = self.0.iter().rev().take(MEAN_FRAMES);
        recent.clone().sum::<f64>() / recent.count().max(1) as f64
    }

    fn longest(&self) -> f64 {
        self.0.iter().copied().fold(0.0, f64::max)
    }
}

/// Remembers the time of the last frame.
pub fn watch(time: Res<Time<bevy::time::Real>>, mut frames: ResMut<FrameTimes>) {
    // The oldest frame makes room.
    if frames.0.len() == KEPT_FRAMES {
        frames.0.pop_front();
    }
    frames.0.push_back(time.delta_secs_f64() * 1e3);
}

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &ShownView, frames: &FrameTimes, out: &mut Outbox) {
    let timings = view.timings;
    row(ui, "Frame, mean", milliseconds(frames.mean()));
    row(ui, "Frame, longest of 180", milliseconds(frames.longest()));
    frame_plot(ui, frames);
    let longest = timings.last_ms.iter().copied().fold(0.1, f64::max);
    for (stage, &ms) in Stage::ALL.iter().zip(&timings.last_ms) {
        bar(ui, stage.name(), ms, longest);
    }
    ui.add_space(3.0);
    row(ui, "Last step", milliseconds(timings.last_step_ms()));
    row(ui, "Mean step", milliseconds(timings.step_mean_ms()));
    row(ui, "Longest step", milliseconds(timings.step_max_ms));
    row(ui, "Resampling", mean_of(timings.resample));
    row(ui, "Rifting", mean_of(timings.rift));
    hint(ui, "Steps without resampling and rifting.");
    let doc = "Even samples and new ocean crust at the next step";
    if button(ui, "Resample now", doc) {
        out.command(TectonicCommand::Resample);
    }
}

fn milliseconds(ms: f64) -> String {
    format!("{ms:.1} ms")
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
    let filled = rect.with_max_x(rect.left() + rect.width() * share);
    let (painter, text) = (ui.painter(), ui.visuals().text_color());
    painter.rect_filled(rect, CornerRadius::same(2), ui.visuals().faint_bg_color);
    painter.rect_filled(filled, CornerRadius::same(2), FIELD);
    let font = FontId::proportional(11.0);
    let left = rect.left_center() + vec2(5.0, 0.0);
    painter.text(left, Align2::LEFT_CENTER, name, font.clone(), text);
    let right = rect.right_center() - vec2(5.0, 0.0);
    let label = format!("{ms:.2} ms");
    painter.text(right, Align2::RIGHT_CENTER, label, font, text);
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
        .include_x(KEPT_FRAMES as f64)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .y_axis_min_width(26.0)
        .show(ui, |plot| plot.line(Line::new("ms", points).color(ACCENT)));
}
