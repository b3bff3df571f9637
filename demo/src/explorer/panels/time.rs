//! Play, pause, single step and speed.

use super::Outbox;
use super::draft::edit;
use crate::explorer::state::{Action, SPEED_LIMITS, View};
use crate::explorer::style::{field, primary_button, row};
use crate::explorer::text;
use bevy_egui::egui::{DragValue, Slider, Ui, vec2};

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &View, out: &mut Outbox) {
    ui.horizontal(|ui| {
        let label = if view.controls.paused {
            "▶  Play"
        } else {
            "⏸  Pause"
        };
        if primary_button(ui, true, label)
            .on_hover_text("Space")
            .clicked()
        {
            out.ask(Action::TogglePlay);
        }
        if ui
            .button("⏭  Step")
            .on_hover_text("One time step, then pause (S)")
            .clicked()
        {
            out.ask(Action::SingleStep);
        }
    });
    ui.scope(|ui| {
        ui.spacing_mut().slider_width = ui.available_width() - 84.0;
        ui.spacing_mut().interact_size = vec2(76.0, 21.0);
        let speed = edit(ui, "speed", view.controls.speed, |ui, speed| {
            ui.add(
                Slider::new(speed, SPEED_LIMITS.0..=SPEED_LIMITS.1)
                    .logarithmic(true)
                    .max_decimals(1)
                    .suffix(" My/s"),
            )
            .on_hover_text("Wanted speed; a slow machine lags behind instead of stuttering")
        });
        if let Some(speed) = speed {
            out.ask(Action::SetSpeed(speed));
        }
    });
    row(ui, "Time", format!("{:.1} My", view.clock.time));
    row(
        ui,
        "Steps",
        format!(
            "{} × {} My",
            text::count(view.clock.step as usize),
            text::number(view.params.time_step)
        ),
    );
    row(
        ui,
        "Since resampling",
        format!("{} steps", view.clock.since_resample),
    );
}

/// Draws a whole number with limits.
pub fn whole(ui: &mut Ui, label: &str, value: &mut u32, range: core::ops::RangeInclusive<u32>) {
    let speed = (f64::from(*value) * 0.01).max(0.2);
    field(ui, label, |ui| {
        ui.add(DragValue::new(value).range(range).speed(speed))
    });
}
