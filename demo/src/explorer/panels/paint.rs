//! The brush: raises, lowers and changes crust in a disc, or everywhere.

use super::Outbox;
use crate::explorer::state::Tool;
use crate::explorer::widgets::{button, field, hint, toggle_button};
use bevy::math::DVec3;
use bevy::prelude::Resource;
use bevy_egui::egui::{DragValue, Slider, Ui};
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::prelude::*;

/// The effect of the brush.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Mode {
    #[default]
    Raise,
    Lower,
    Level,
    Continent,
    Ocean,
}

/// The brush.
#[derive(Resource, Clone, Debug)]
pub struct PaintForm {
    mode: Mode,
    /// By how much it raises or lowers, in km.
    amount: f64,
    /// The elevation that it sets, in km.
    level: f64,
    /// Radius in km.
    pub radius: f64,
}

impl Default for PaintForm {
    fn default() -> Self {
        Self {
            mode: Mode::Raise,
            amount: 1.0,
            level: 0.5,
            radius: 600.0,
        }
    }
}

impl PaintForm {
    fn brush(&self) -> Brush {
        match self.mode {
            Mode::Raise => Brush::Raise(self.amount),
            Mode::Lower => Brush::Raise(-self.amount),
            Mode::Level => Brush::Elevation(self.level),
            Mode::Continent => Brush::Kind(CrustKind::Continental),
            Mode::Ocean => Brush::Kind(CrustKind::Oceanic),
        }
    }

    /// The command of a click at this place.
    pub fn stroke(&self, at: DVec3) -> TectonicCommand {
        let target = PaintTarget::Disc {
            center: lat_lon(at),
            radius: self.radius,
        };
        TectonicCommand::PaintCrust {
            target,
            brush: self.brush(),
        }
    }
}

/// Draws the panel, for a planet of `radius` km.
pub fn show(ui: &mut Ui, radius: f64, tool: &mut Tool, form: &mut PaintForm, out: &mut Outbox) {
    ui.horizontal_wrapped(|ui| modes(ui, form));
    strength(ui, form);
    let largest = (radius * 0.8).max(100.0);
    form.radius = form.radius.min(largest);
    field(ui, "Radius", |ui| {
        let slider = Slider::new(&mut form.radius, 20.0..=largest)
            .max_decimals(0)
            .logarithmic(true)
            .suffix(" km");
        ui.add(slider)
    });
    ui.horizontal(|ui| {
        pick_up(ui, tool);
        if button(ui, "Everywhere", "Applies the brush to the whole planet") {
            let (target, brush) = (PaintTarget::Everywhere, form.brush());
            out.command(TectonicCommand::PaintCrust { target, brush });
        }
    });
    if *tool == Tool::Paint {
        hint(ui, "Each click on the globe applies the brush once.");
    }
}

fn modes(ui: &mut Ui, form: &mut PaintForm) {
    for (mode, name) in [
        (Mode::Raise, "Raise"),
        (Mode::Lower, "Lower"),
        (Mode::Level, "Set height"),
        (Mode::Continent, "Continent"),
        (Mode::Ocean, "Ocean floor"),
    ] {
        if toggle_button(ui, form.mode == mode, name).clicked() {
            form.mode = mode;
        }
    }
}

/// The number that the mode needs.
fn strength(ui: &mut Ui, form: &mut PaintForm) {
    match form.mode {
        Mode::Raise | Mode::Lower => {
            let slider = Slider::new(&mut form.amount, 0.1..=8.0).suffix(" km");
            field(ui, "By", |ui| ui.add(slider));
        }
        Mode::Level => {
            let drag = DragValue::new(&mut form.level)
                .range(-11.0..=10.0)
                .speed(0.05)
                .suffix(" km");
            field(ui, "Height above the sea", |ui| ui.add(drag));
        }
        Mode::Continent | Mode::Ocean => {}
    }
}

fn pick_up(ui: &mut Ui, tool: &mut Tool) {
    let painting = *tool == Tool::Paint;
    let name = if painting {
        "Put the brush down"
    } else {
        "Take the brush"
    };
    let toggle = toggle_button(ui, painting, name);
    if toggle
        .on_hover_text("Then click on the globe (B)")
        .clicked()
    {
        *tool = if painting { Tool::Select } else { Tool::Paint };
    }
}
