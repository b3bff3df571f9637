//! The selected plate: what it is, how it moves, and how to break it.

use super::Outbox;
use super::draft::edit;
use crate::explorer::state::{Action, Selection, Tool, View};
use crate::explorer::style::{BRIGHT, field, hint, primary_button, row, toggle_button};
use crate::explorer::text;
use bevy::prelude::Resource;
use bevy_egui::egui::{Button, DragValue, RichText, Ui};
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::plate::PlateRow;
use bevy_pangaea::prelude::*;

/// What is being chosen.
#[derive(Resource, Clone, Debug)]
pub struct PlateForm {
    fragments: u32,
}

impl Default for PlateForm {
    fn default() -> Self {
        Self { fragments: 2 }
    }
}

/// Draws the panel.
pub fn show(
    ui: &mut Ui,
    view: &View,
    (selection, tool, form): (&Selection, &mut Tool, &mut PlateForm),
    out: &mut Outbox,
) {
    let Some(plate) = selection.0.and_then(|id| view.plates.get(id)) else {
        hint(ui, "Click a plate on the globe to take it by the hand.");
        return;
    };
    ui.horizontal(|ui| {
        ui.label(
            RichText::new(format!("Plate {}", plate.id.0))
                .heading()
                .color(BRIGHT),
        );
        ui.with_layout(
            bevy_egui::egui::Layout::right_to_left(bevy_egui::egui::Align::Center),
            |ui| {
                if ui.small_button("Deselect").on_hover_text("Esc").clicked() {
                    out.ask(Action::Select(None));
                }
            },
        );
    });
    row(ui, "Area", text::area(plate.stats.area));
    row(
        ui,
        "Continental",
        format!("{:.0} %", plate.stats.continental * 100.0),
    );
    row(
        ui,
        "Mean floor age",
        format!("{:.0} My", plate.stats.ocean_age),
    );
    row(
        ui,
        "Age of the plate",
        format!("{:.0} My", view.clock.time - plate.born),
    );
    ui.separator();
    motion(ui, view, plate, out);
    ui.separator();
    rift(ui, plate, tool, form, out);
    ui.separator();
    field(ui, "Make all of it", |ui| {
        for (kind, name) in [
            (CrustKind::Continental, "continental"),
            (CrustKind::Oceanic, "oceanic"),
        ] {
            if ui
                .button(name)
                .on_hover_text("Switches the crust type of the whole plate")
                .clicked()
            {
                out.command(TectonicCommand::SetPlateCrust {
                    plate: plate.id,
                    kind,
                });
            }
        }
    });
}

fn motion(ui: &mut Ui, view: &View, plate: &PlateRow, out: &mut Outbox) {
    let speed = plate.motion.speed * view.planet.radius;
    let (lat, lon) = lat_lon(plate.motion.axis);
    let limit = view.params.max_speed;
    let key = |what| (view.entity.to_bits(), plate.id.0, what);
    let send = |pole, speed, out: &mut Outbox| {
        out.command(TectonicCommand::SetPlateMotion {
            plate: plate.id,
            pole,
            speed,
        });
    };
    let number = |ui: &mut Ui,
                  label: &str,
                  what: &'static str,
                  now: f64,
                  limit: f64,
                  unit: &str,
                  doc: &str| {
        field(ui, label, |ui| {
            edit(ui, key(what), now, |ui, value| {
                let drag = DragValue::new(value)
                    .range(-limit..=limit)
                    .speed(limit * 0.005);
                ui.add(drag.max_decimals(1).suffix(unit)).on_hover_text(doc)
            })
            // Leaving the field unchanged rounds to what it shows; that is no wish.
            .filter(|value| (value - now).abs() > 0.0501)
        })
    };
    let doc =
        "Speed at 90 degrees from the pole; negative turns the other way. Drag, or click and type";
    if let Some(value) = number(ui, "Speed", "speed", speed, limit, " km/My", doc) {
        send((lat, lon), value, out);
    }
    let doc = "The plate turns anticlockwise about this pole, seen from above";
    if let Some(value) = number(ui, "Pole latitude", "lat", lat, 90.0, "°", doc) {
        send((value, lon), speed, out);
    }
    if let Some(value) = number(ui, "Pole longitude", "lon", lon, 180.0, "°", doc) {
        send((lat, value), speed, out);
    }
    ui.horizontal(|ui| {
        if ui.button("Stop").on_hover_text("Speed 0").clicked() {
            send((lat, lon), 0.0, out);
        }
        if ui
            .button("Turn round")
            .on_hover_text("The opposite motion")
            .clicked()
        {
            send(
                (-lat, if lon > 0.0 { lon - 180.0 } else { lon + 180.0 }),
                speed,
                out,
            );
        }
    });
}

fn rift(ui: &mut Ui, plate: &PlateRow, tool: &mut Tool, form: &mut PlateForm, out: &mut Outbox) {
    field(ui, "Fragments", |ui| {
        for n in (2..=4).rev() {
            if toggle_button(ui, form.fragments == n, &n.to_string()).clicked() {
                form.fragments = n;
            }
        }
    });
    let drawing = matches!(tool, Tool::RiftLine { .. });
    ui.horizontal(|ui| {
        if primary_button(ui, !drawing, "Tear apart")
            .on_hover_text("Along a random fracture")
            .clicked()
        {
            let fragments = form.fragments;
            out.command(TectonicCommand::RiftPlate {
                plate: plate.id,
                line: Vec::new(),
                fragments,
            });
        }
        let draw = toggle_button(ui, drawing, "Draw a rift line");
        if draw
            .on_hover_text("Click points across the plate on the globe")
            .clicked()
        {
            *tool = if drawing {
                Tool::Select
            } else {
                Tool::RiftLine {
                    plate: plate.id,
                    points: Vec::new(),
                }
            };
        }
    });
    let mut done = false;
    if let Tool::RiftLine { points, .. } = tool {
        hint(
            ui,
            format!(
                "{} points. Click on the globe, from one border to the other.",
                points.len()
            ),
        );
        ui.horizontal(|ui| {
            if ui
                .add_enabled(points.len() >= 2, Button::new("Tear along the line"))
                .clicked()
            {
                let line = points.iter().map(|&p| lat_lon(p)).collect();
                out.command(TectonicCommand::RiftPlate {
                    plate: plate.id,
                    line,
                    fragments: 2,
                });
                done = true;
            }
            if ui
                .add_enabled(!points.is_empty(), Button::new("Undo point"))
                .clicked()
            {
                points.pop();
            }
        });
    }
    if done {
        *tool = Tool::Select;
    }
}
