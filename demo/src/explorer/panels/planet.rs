//! A new planet, save, load, and pictures.

use super::Outbox;
use super::time::whole;
use crate::explorer::session::Session;
use crate::explorer::state::{Action, View};
use crate::explorer::style::{self, field, hint, primary_button, row, subsection};
use crate::explorer::text;
use bevy::prelude::Resource;
use bevy_egui::egui::{DragValue, Slider, TextEdit, Ui};
use bevy_pangaea::prelude::*;
use std::path::{Path, PathBuf};

/// What is being typed.
#[derive(Resource, Clone, Debug)]
pub struct PlanetForm {
    /// The next planet.
    pub recipe: PlanetRecipe,
    /// Name of the preset that the recipe came from.
    preset: Option<String>,
    preset_path: String,
    file: String,
    picture: String,
}

impl Default for PlanetForm {
    fn default() -> Self {
        Self {
            recipe: PlanetRecipe::default(),
            preset: None,
            preset_path: String::new(),
            file: "planet.pangaea".into(),
            picture: String::new(),
        }
    }
}

impl PlanetForm {
    /// A form that starts from `recipe`.
    pub fn new(recipe: PlanetRecipe) -> Self {
        Self {
            recipe,
            ..Self::default()
        }
    }

    /// Takes over a preset.
    pub fn take_preset(&mut self, recipe: PlanetRecipe, path: &Path) {
        self.preset = path
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        self.recipe = recipe;
    }

    /// The file to save to and load from.
    pub fn file(&self) -> PathBuf {
        PathBuf::from(self.file.trim())
    }
}

/// Draws the panel.
pub fn show(
    ui: &mut Ui,
    view: Option<&View>,
    session: &Session,
    form: &mut PlanetForm,
    out: &mut Outbox,
) {
    if let Some(view) = view {
        row(ui, "Seed", view.planet.seed.to_string());
        row(
            ui,
            "Radius",
            format!("{} km", text::number(view.planet.radius)),
        );
        let spacing = view.mesh.spacing() * view.planet.radius;
        let samples = format!("{}, {spacing:.0} km apart", text::count(view.mesh.len()));
        row(ui, "Samples", samples);
        row(ui, "Plates", view.plates.rows().len().to_string());
    }
    subsection(ui, "New planet", true, |ui| {
        new_planet(ui, session, form, out)
    });
    subsection(ui, "Save and load", false, |ui| {
        files(ui, view.is_some(), session, form, out)
    });
    subsection(ui, "Picture", false, |ui| {
        let edit = TextEdit::singleline(&mut form.picture).hint_text("pangaea-001.png");
        ui.add(edit.desired_width(f32::INFINITY));
        if ui.button("Save picture").on_hover_text("F2").clicked() {
            let name = form.picture.trim();
            out.ask(Action::Screenshot(
                (!name.is_empty()).then(|| with_extension(name, "png")),
            ));
        }
    });
}

fn new_planet(ui: &mut Ui, session: &Session, form: &mut PlanetForm, out: &mut Outbox) {
    let recipe = &mut form.recipe;
    field(ui, "Seed", |ui| {
        if ui
            .small_button("🎲")
            .on_hover_text("Another seed")
            .clicked()
        {
            recipe.seed = another(recipe.seed);
        }
        ui.add(DragValue::new(&mut recipe.seed).speed(0.1))
    });
    whole(ui, "Samples", &mut recipe.samples, 100..=2_000_000);
    if recipe.plates.is_empty() {
        whole(
            ui,
            "Plates",
            &mut recipe.plate_count,
            2..=PlanetRecipe::MAX_PLATES as u32,
        );
    } else {
        row(
            ui,
            "Plates",
            format!("{} in the preset", recipe.plates.len()),
        );
    }
    if recipe.continents.is_empty() {
        field(ui, "Land", |ui| {
            ui.spacing_mut().slider_width = 86.0;
            let percent = |v: f64, _| format!("{:.0} %", v * 100.0);
            let parse = |s: &str| {
                s.trim_end_matches(['%', ' '])
                    .parse::<f64>()
                    .ok()
                    .map(|v| v / 100.0)
            };
            let slider = Slider::new(&mut recipe.land, 0.0..=0.9);
            ui.add(slider.custom_formatter(percent).custom_parser(parse))
        });
    } else {
        row(
            ui,
            "Land",
            format!("{} continents in the preset", recipe.continents.len()),
        );
    }
    preset(ui, session, form, out);
    let free = !session.is_growing();
    let grow = primary_button(ui, free, "Grow this planet");
    if grow
        .on_hover_text("N. The present planet stays until the new one is there")
        .clicked()
    {
        out.ask(Action::Grow(Box::new(form.recipe.clone())));
    }
}

fn preset(ui: &mut Ui, session: &Session, form: &mut PlanetForm, out: &mut Outbox) {
    ui.horizontal(|ui| {
        let edit = TextEdit::singleline(&mut form.preset_path).hint_text("preset.planet.ron");
        ui.add(edit.desired_width(ui.available_width() - 58.0));
        let ready = !session.is_growing() && !form.preset_path.trim().is_empty();
        let read = ui.add_enabled(ready, bevy_egui::egui::Button::new("Read"));
        if read
            .on_hover_text("Takes plates, continents and parameters from the file")
            .clicked()
        {
            out.ask(Action::ReadPreset(PathBuf::from(form.preset_path.trim())));
        }
    });
    let mut forget = false;
    if let Some(name) = &form.preset {
        ui.horizontal(|ui| {
            hint(ui, format!("from {name}"));
            forget = ui.small_button("Forget").clicked();
        });
    }
    if forget {
        let PlanetRecipe { seed, samples, .. } = form.recipe;
        form.recipe = PlanetRecipe {
            seed,
            samples,
            ..Default::default()
        };
        form.preset = None;
    }
}

fn files(
    ui: &mut Ui,
    has_planet: bool,
    session: &Session,
    form: &mut PlanetForm,
    out: &mut Outbox,
) {
    ui.add(TextEdit::singleline(&mut form.file).desired_width(f32::INFINITY));
    ui.horizontal(|ui| {
        let save = ui.add_enabled(has_planet, bevy_egui::egui::Button::new("Save"));
        if save
            .on_hover_text("F5. Written in the background")
            .clicked()
        {
            out.ask(Action::Save(form.file()));
        }
        let load = ui.add_enabled(!session.is_growing(), bevy_egui::egui::Button::new("Load"));
        if load.on_hover_text("F9").clicked() {
            out.ask(Action::Load(form.file()));
        }
        if let Some(what) = session.busy() {
            ui.label(
                bevy_egui::egui::RichText::new(format!("{what} …"))
                    .small()
                    .color(style::ACCENT),
            );
        }
    });
}

fn with_extension(name: &str, extension: &str) -> PathBuf {
    let mut path = PathBuf::from(name);
    if path.extension().is_none() {
        path.set_extension(extension);
    }
    path
}

/// The next seed of a scrambled row: a planet that looks nothing like this one.
fn another(seed: u64) -> u64 {
    (seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407)
        >> 33)
        % 100_000
}
