//! The selected plate: what it is, how it moves, and how to break it.

use super::Outbox;
use super::draft::edit;
use crate::explorer::state::{Action, Tool};
use crate::explorer::style::BRIGHT;
use crate::explorer::text;
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{button, field, hint, primary_button, row, toggle_button};
use bevy::prelude::Resource;
use bevy_egui::egui::{Align, Button, DragValue, Layout, RichText, Ui};
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::plate::PlateRow;
use bevy_pangaea::prelude::*;

/// Smallest change of a number that is a wish: leaving a field unchanged rounds the number to the
/// one decimal that it shows.
const ROUNDING: f64 = 0.0501;

/// The choices that are being made.
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
    view: &ShownView,
    selected: Option<&PlateRow>,
    tool: &mut Tool,
    form: &mut PlateForm,
    out: &mut Outbox,
) {
    let Some(plate) = selected else {
        hint(ui, "Click a plate on the globe to select it.");
        hint(ui, "Drag it with Shift to set its motion.");
        return;
    };
    title(ui, plate, out);
    facts(ui, view, plate);
    ui.separator();
    motion(ui, view, plate, out);
    ui.separator();
    rift(ui, plate, tool, form, out);
    ui.separator();
    field(ui, "Make all of it", |ui| crust(ui, plate, out));
}

fn title(ui: &mut Ui, plate: &PlateRow, out: &mut Outbox) {
    let title = RichText::new(format!("Plate {}", plate.id.0)).heading();
    ui.horizontal(|ui| {
        ui.label(title.color(BRIGHT));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.small_button("Deselect").on_hover_text("Esc").clicked() {
                out.ask(Action::Select(None));
            }
        });
    });
}

fn facts(ui: &mut Ui, view: &ShownView, plate: &PlateRow) {
    let stats = &plate.stats;
    let age = view.clock.time - plate.born;
    let continental = format!("{:.0} %", stats.continental * 100.0);
    row(ui, "Area", text::area(stats.area));
    row(ui, "Continental", continental);
    row(ui, "Mean floor age", format!("{:.0} My", stats.ocean_age));
    row(ui, "Age of the plate", format!("{age:.0} My"));
}

fn crust(ui: &mut Ui, plate: &PlateRow, out: &mut Outbox) {
    for (kind, name) in [
        (CrustKind::Continental, "continental"),
        (CrustKind::Oceanic, "oceanic"),
    ] {
        if button(ui, name, "Switches the crust type of the whole plate") {
            let plate = plate.id;
            out.command(TectonicCommand::SetPlateCrust { plate, kind });
        }
    }
}

/// A number of a motion, as a field.
struct MotionField {
    label: &'static str,
    /// It ranges from minus to plus this.
    limit: f64,
    unit: &'static str,
    doc: &'static str,
}

impl MotionField {
    fn speed(limit: f64) -> Self {
        Self {
            label: "Speed",
            limit,
            unit: " km/My",
            doc: "Speed at 90 degrees from the pole; negative turns the other way. \
                  Drag, or click and type",
        }
    }

    fn angle(label: &'static str, limit: f64) -> Self {
        Self {
            label,
            limit,
            unit: "°",
            doc: "The plate turns anticlockwise about this pole, seen from above",
        }
    }

    /// Draws the field of a number that is `now` in the model. Returns a new one.
    fn show(&self, ui: &mut Ui, key: (u64, u32), now: f64) -> Option<f64> {
        let edited = field(ui, self.label, |ui| {
            edit(ui, (key, self.label), now, |ui, value| {
                let number = DragValue::new(value)
                    .range(-self.limit..=self.limit)
                    .speed(self.limit * 0.005)
                    .max_decimals(1)
                    .suffix(self.unit);
                ui.add(number).on_hover_text(self.doc)
            })
        });
        edited.filter(|value| (value - now).abs() > ROUNDING)
    }
}

fn motion(ui: &mut Ui, view: &ShownView, plate: &PlateRow, out: &mut Outbox) {
    let speed = plate.motion.speed * view.planet.radius;
    let pole @ (lat, lon) = lat_lon(plate.motion.axis);
    let key = (view.entity.to_bits(), plate.id.0);
    let speed_field = MotionField::speed(view.params.max_speed);
    if let Some(speed) = speed_field.show(ui, key, speed) {
        out.command(set_motion(plate, pole, speed));
    }
    if let Some(lat) = MotionField::angle("Pole latitude", 90.0).show(ui, key, lat) {
        out.command(set_motion(plate, (lat, lon), speed));
    }
    if let Some(lon) = MotionField::angle("Pole longitude", 180.0).show(ui, key, lon) {
        out.command(set_motion(plate, (lat, lon), speed));
    }
    ui.horizontal(|ui| {
        if button(ui, "Stop", "Speed 0") {
            out.command(set_motion(plate, pole, 0.0));
        }
        if button(ui, "Turn round", "The opposite motion") {
            out.command(set_motion(plate, antipode(pole), speed));
        }
    });
    hint(ui, "Or drag the plate over the globe with Shift.");
}

fn set_motion(plate: &PlateRow, pole: (f64, f64), speed: f64) -> TectonicCommand {
    TectonicCommand::SetPlateMotion {
        plate: plate.id,
        pole,
        speed,
    }
}

/// The opposite point of the globe, in degrees.
fn antipode((lat, lon): (f64, f64)) -> (f64, f64) {
    let opposite = if lon > 0.0 { lon - 180.0 } else { lon + 180.0 };
    (-lat, opposite)
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
        let tear = primary_button(ui, !drawing, "Tear apart");
        if tear.on_hover_text("Along a random fracture").clicked() {
            out.command(rift_along(plate, Vec::new(), form.fragments));
        }
        let draw = toggle_button(ui, drawing, "Draw a rift line");
        let draw = draw.on_hover_text("Click points across the plate on the globe");
        if draw.clicked() {
            *tool = if drawing {
                Tool::Select
            } else {
                let (plate, points) = (plate.id, Vec::new());
                Tool::RiftLine { plate, points }
            };
        }
    });
    rift_line(ui, plate, tool, out);
}

/// The rift line that is being drawn.
fn rift_line(ui: &mut Ui, plate: &PlateRow, tool: &mut Tool, out: &mut Outbox) {
    let Tool::RiftLine { points, .. } = tool else {
        return;
    };
    let count = points.len();
    hint(
        ui,
        format!("{count} points. Click on the globe, from one border to the other."),
    );
    let mut done = false;
    ui.horizontal(|ui| {
        let tear = ui.add_enabled(count >= 2, Button::new("Tear along the line"));
        if tear.clicked() {
            let line = points.iter().map(|&point| lat_lon(point)).collect();
            out.command(rift_along(plate, line, 2));
            done = true;
        }
        let undo = ui.add_enabled(count > 0, Button::new("Undo point"));
        if undo.clicked() {
            points.pop();
        }
    });
    if done {
        *tool = Tool::Select;
    }
}

fn rift_along(plate: &PlateRow, line: Vec<(f64, f64)>, fragments: u32) -> TectonicCommand {
    TectonicCommand::RiftPlate {
        plate: plate.id,
        line,
        fragments,
    }
}
