//! The parameters of the model, drawn from their table: limits, unit, meaning, default.

use super::Outbox;
use super::draft::edit;
use crate::explorer::style::{ACCENT, FAINT, TEXT};
use crate::explorer::text;
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{hint, subsection};
use bevy_egui::egui::{Align, Button, Layout, RichText, Slider, Ui, vec2};
use bevy_pangaea::params::ParamInfo;
use bevy_pangaea::prelude::*;

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &ShownView, out: &mut Outbox) {
    reset_all(ui, resets(view.params), out);
    subsection(ui, "Processes", false, |ui| processes(ui, view, out));
    for group in TectonicParams::TABLE.chunk_by(|a, b| a.group == b.group) {
        subsection(ui, group[0].group, false, |ui| {
            for info in group {
                parameter(ui, view, info, out);
            }
        });
    }
}

/// How many values are changed, and a button that takes all changes back.
fn reset_all(ui: &mut Ui, resets: Vec<TectonicCommand>, out: &mut Outbox) {
    ui.horizontal(|ui| {
        hint(ui, format!("{} changed from their defaults", resets.len()));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let button = Button::new("Reset all").small();
            if ui.add_enabled(!resets.is_empty(), button).clicked() {
                resets.into_iter().for_each(|command| out.command(command));
            }
        });
    });
}

/// Switches of the processes, in two columns.
fn processes(ui: &mut Ui, view: &ShownView, out: &mut Outbox) {
    let mut switches = view.params.processes;
    ui.columns_const(|columns: &mut [Ui; 2]| {
        for (i, name) in ProcessSwitches::NAMES.into_iter().enumerate() {
            let Ok(on) = switches.get_mut(name) else {
                continue;
            };
            if columns[i % 2].checkbox(on, text::words(name)).changed() {
                out.command(TectonicCommand::SetProcess {
                    name: name.into(),
                    on: *on,
                });
            }
        }
    });
    ocean_floor(ui, view, out);
}

fn ocean_floor(ui: &mut Ui, view: &ShownView, out: &mut Outbox) {
    let mut printed = view.params.ocean_floor == OceanFloor::Paper;
    let switch = ui
        .checkbox(&mut printed, "Ocean floor sinks as printed")
        .on_hover_text("The form of the paper, in which old floor ends in a trench");
    if switch.changed() {
        let law = if printed {
            OceanFloor::Paper
        } else {
            OceanFloor::Relaxing
        };
        out.command(TectonicCommand::SetOceanFloor { law });
    }
}

fn parameter(ui: &mut Ui, view: &ShownView, info: &'static ParamInfo, out: &mut Outbox) {
    let changed = is_changed(info, view.params);
    ui.horizontal(|ui| {
        let color = if changed { ACCENT } else { TEXT };
        ui.label(RichText::new(text::words(info.name)).color(color))
            .on_hover_text(tooltip(info));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if changed && reset(ui, info) {
                out.command(set(info, info.default));
            }
        });
    });
    if let Some(value) = ui.scope(|ui| chosen(ui, view, info)).inner {
        out.command(set(info, value.clamp(info.min, info.max)));
    }
    ui.add_space(2.0);
}

/// A button that brings a parameter back to its default. Returns whether it was clicked.
fn reset(ui: &mut Ui, info: &ParamInfo) -> bool {
    let text = RichText::new("reset").small().color(FAINT);
    let default = text::with_unit(info.default, info.unit);
    ui.add(Button::new(text).frame(false))
        .on_hover_text(format!("Back to {default}"))
        .clicked()
}

/// The slider of a parameter. Returns a new value once it is settled.
fn chosen(ui: &mut Ui, view: &ShownView, info: &'static ParamInfo) -> Option<f64> {
    ui.spacing_mut().slider_width = ui.available_width() - 98.0;
    ui.spacing_mut().interact_size = vec2(90.0, 20.0);
    let key = (view.entity.to_bits(), info.name);
    edit(ui, key, (info.get)(view.params), |ui, value| {
        ui.add(slider(value, info)).on_hover_text(tooltip(info))
    })
}

fn set(info: &ParamInfo, value: f64) -> TectonicCommand {
    let name = info.name.into();
    TectonicCommand::SetParam { name, value }
}

fn slider<'a>(value: &'a mut f64, info: &ParamInfo) -> Slider<'a> {
    let span = info.max - info.min;
    // Where the default is a small part of the range, even steps would leave no room below it.
    let logarithmic = info.min >= 0.0 && info.default > 0.0 && info.default < 0.1 * span;
    let smallest = if info.default > 0.0 {
        info.default * 0.01
    } else {
        span * 1e-3
    };
    let suffix = if info.unit.is_empty() {
        String::new()
    } else {
        format!(" {}", info.unit)
    };
    Slider::new(value, info.min..=info.max)
        .logarithmic(logarithmic)
        .smallest_positive(smallest)
        .custom_formatter(|value, _| text::number(value))
        .custom_parser(|text| text.trim().parse().ok())
        .suffix(suffix)
}

fn tooltip(info: &ParamInfo) -> String {
    format!(
        "{}\n\n{} to {}, default {}\n{}",
        info.doc.trim(),
        text::number(info.min),
        text::with_unit(info.max, info.unit),
        text::with_unit(info.default, info.unit),
        info.name,
    )
}

fn is_changed(info: &ParamInfo, params: &TectonicParams) -> bool {
    (info.get)(params) != info.default
}

/// The commands that bring every changed switch and parameter back to its default.
fn resets(params: &TectonicParams) -> Vec<TectonicCommand> {
    let law = OceanFloor::default();
    let floor = (params.ocean_floor != law).then_some(TectonicCommand::SetOceanFloor { law });
    let values = TectonicParams::TABLE
        .iter()
        .filter(|info| is_changed(info, params))
        .map(|info| set(info, info.default));
    ProcessSwitches::NAMES
        .into_iter()
        .filter_map(|name| reset_switch(params.processes, name))
        .chain(values)
        .chain(floor)
        .collect()
}

/// The command that brings a switch back to its default, `None` if it is there.
fn reset_switch(mut switches: ProcessSwitches, name: &str) -> Option<TectonicCommand> {
    let on = *ProcessSwitches::default().get_mut(name).ok()?;
    let changed = *switches.get_mut(name).ok()? != on;
    changed.then(|| TectonicCommand::SetProcess {
        name: name.into(),
        on,
    })
}
