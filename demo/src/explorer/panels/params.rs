//! The parameters of the model, drawn from their table: limits, unit, meaning, default.

use super::Outbox;
use super::draft::edit;
use crate::explorer::state::View;
use crate::explorer::style::{ACCENT, FAINT, TEXT, hint, subsection};
use crate::explorer::text;
use bevy_egui::egui::{Align, Button, Layout, RichText, Slider, Ui, vec2};
use bevy_pangaea::params::ParamInfo;
use bevy_pangaea::prelude::*;

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &View, out: &mut Outbox) {
    let changed = resets(view.params);
    ui.horizontal(|ui| {
        hint(ui, format!("{} changed from their defaults", changed.len()));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui
                .add_enabled(!changed.is_empty(), Button::new("Reset all").small())
                .clicked()
            {
                changed.into_iter().for_each(|command| out.command(command));
            }
        });
    });
    subsection(ui, "Processes", false, |ui| processes(ui, view, out));
    for group in TectonicParams::TABLE.chunk_by(|a, b| a.group == b.group) {
        subsection(ui, group[0].group, false, |ui| {
            for info in group {
                parameter(ui, view, info, out);
            }
        });
    }
}

/// Switches of the processes, in two columns.
fn processes(ui: &mut Ui, view: &View, out: &mut Outbox) {
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
    let mut printed = view.params.ocean_floor == OceanFloor::Paper;
    let printed_law = ui.checkbox(&mut printed, "Ocean floor sinks as printed");
    if printed_law
        .on_hover_text("The form of the paper, in which old floor ends in a trench")
        .changed()
    {
        let law = if printed {
            OceanFloor::Paper
        } else {
            OceanFloor::Relaxing
        };
        out.command(TectonicCommand::SetOceanFloor { law });
    }
}

fn parameter(ui: &mut Ui, view: &View, info: &'static ParamInfo, out: &mut Outbox) {
    let current = (info.get)(view.params);
    let changed = is_changed(info, view.params);
    let set = |value: f64| TectonicCommand::SetParam {
        name: info.name.into(),
        value,
    };
    ui.horizontal(|ui| {
        let color = if changed { ACCENT } else { TEXT };
        ui.label(RichText::new(text::words(info.name)).color(color))
            .on_hover_text(tooltip(info));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if changed {
                let reset =
                    ui.add(Button::new(RichText::new("reset").small().color(FAINT)).frame(false));
                let default = text::with_unit(info.default, info.unit);
                if reset.on_hover_text(format!("Back to {default}")).clicked() {
                    out.command(set(info.default));
                }
            }
        });
    });
    let chosen = ui
        .scope(|ui| {
            ui.spacing_mut().slider_width = ui.available_width() - 98.0;
            ui.spacing_mut().interact_size = vec2(90.0, 20.0);
            edit(
                ui,
                (view.entity.to_bits(), info.name),
                current,
                |ui, value| ui.add(slider(value, info)).on_hover_text(tooltip(info)),
            )
        })
        .inner;
    if let Some(value) = chosen {
        out.command(set(value.clamp(info.min, info.max)));
    }
    ui.add_space(2.0);
}

fn slider<'a>(value: &'a mut f64, info: &ParamInfo) -> Slider<'a> {
    let span = info.max - info.min;
    // Where the default is a small part of the range, even steps would leave no room below it.
    let logarithmic = info.min >= 0.0 && info.default > 0.0 && info.default < 0.1 * span;
    Slider::new(value, info.min..=info.max)
        .logarithmic(logarithmic)
        .smallest_positive(if info.default > 0.0 {
            info.default * 0.01
        } else {
            span * 1e-3
        })
        .custom_formatter(|value, _| text::number(value))
        .custom_parser(|text| text.trim().parse().ok())
        .suffix(if info.unit.is_empty() {
            String::new()
        } else {
            format!(" {}", info.unit)
        })
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
    let (mut now, mut default) = (params.processes, ProcessSwitches::default());
    let switches = ProcessSwitches::NAMES.into_iter().filter_map(|name| {
        let on = *default.get_mut(name).ok()?;
        let command = TectonicCommand::SetProcess {
            name: name.into(),
            on,
        };
        (*now.get_mut(name).ok()? != on).then_some(command)
    });
    let values = TectonicParams::TABLE
        .iter()
        .filter(|info| is_changed(info, params))
        .map(|info| TectonicCommand::SetParam {
            name: info.name.into(),
            value: info.default,
        });
    let law = OceanFloor::default();
    let floor = (params.ocean_floor != law).then_some(TectonicCommand::SetOceanFloor { law });
    switches.chain(values).chain(floor).collect()
}
