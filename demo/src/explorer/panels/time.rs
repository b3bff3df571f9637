//! Play, pause, single step and speed.

use super::Outbox;
use super::draft::edit;
use crate::explorer::state::{Action, SPEED_LIMITS};
use crate::explorer::text;
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{button, primary_button, row};
use bevy_egui::egui::{Slider, Ui, vec2};

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &ShownView, out: &mut Outbox) {
    let clock = view.clock;
    ui.horizontal(|ui| {
        let play = if view.controls.paused {
            "▶  Play"
        } else {
            "⏸  Pause"
        };
        let play = primary_button(ui, true, play).on_hover_text("Space");
        if play.clicked() {
            out.ask(Action::TogglePlay);
        }
        if button(ui, "⏭  Step", "One time step, then pause (S)") {
            out.ask(Action::SingleStep);
        }
    });
    if let Some(speed) = ui.scope(|ui| speed(ui, view.controls.speed)).inner {
        out.ask(Action::SetSpeed(speed));
    }
    let steps = text::count(clock.step as usize);
    let length = text::number(view.params.time_step);
    row(ui, "Time", format!("{:.1} My", clock.time));
    row(ui, "Steps", format!("{steps} × {length} My"));
    let since = format!("{} steps", clock.since_resample);
    row(ui, "Since resampling", since);
}

/// The slider of the speed. Returns a new speed once it is settled.
fn speed(ui: &mut Ui, now: f64) -> Option<f64> {
    ui.spacing_mut().slider_width = ui.available_width() - 84.0;
    ui.spacing_mut().interact_size = vec2(76.0, 21.0);
    edit(ui, "speed", now, |ui, speed| {
        let slider = Slider::new(speed, SPEED_LIMITS.0..=SPEED_LIMITS.1)
            .logarithmic(true)
            .max_decimals(1)
            .suffix(" My/s");
        ui.add(slider)
            .on_hover_text("Wanted speed; a slow machine lags behind instead of stuttering")
    })
}
