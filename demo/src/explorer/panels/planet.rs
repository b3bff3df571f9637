//! A new planet, save, load, and pictures.

use super::Outbox;
use crate::explorer::session::Session;
use crate::explorer::state::{Action, PresetRead};
use crate::explorer::style::ACCENT;
use crate::explorer::text;
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{
    button, field, hint, primary_button, row, subsection, whole_number,
};
use bevy::prelude::{MessageReader, ResMut, Resource};
use bevy_egui::egui::{Button, DragValue, RichText, Slider, TextEdit, Ui};
use bevy_pangaea::prelude::*;
use std::path::PathBuf;

/// The values that are being typed.
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

    /// The file to save to and load from.
    pub fn file(&self) -> PathBuf {
        PathBuf::from(self.file.trim())
    }

    /// A new file beside it for the commands of the planet: nobody has named one that may be
    /// replaced.
    fn scenario_file(&self) -> PathBuf {
        let mut file = self.file().with_extension("scenario.ron");
        let mut number = 1;
        while file.exists() {
            number += 1;
            file = self.file().with_extension(format!("{number}.scenario.ron"));
        }
        file
    }

    /// Forgets the plates, continents and parameters of a preset.
    fn forget_preset(&mut self) {
        let PlanetRecipe { seed, samples, .. } = self.recipe;
        self.preset = None;
        self.recipe = PlanetRecipe {
            seed,
            samples,
            ..Default::default()
        };
    }
}

/// Takes a preset that has been read into the form.
pub fn take_preset(mut presets: MessageReader<PresetRead>, mut form: ResMut<PlanetForm>) {
    for preset in presets.read() {
        let name = preset.path.file_name();
        form.preset = name.map(|name| name.to_string_lossy().into_owned());
        form.recipe = preset.recipe.clone();
    }
}

/// Draws the panel.
pub fn show(
    ui: &mut Ui,
    view: Option<&ShownView>,
    session: &Session,
    form: &mut PlanetForm,
    out: &mut Outbox,
) {
    if let Some(view) = view {
        facts(ui, view);
    }
    subsection(ui, "New planet", true, |ui| {
        new_planet(ui, session, form, out);
    });
    subsection(ui, "Save and load", false, |ui| {
        files(ui, view.is_some(), session, form, out);
    });
    subsection(ui, "Picture", false, |ui| picture(ui, form, out));
}

fn facts(ui: &mut Ui, view: &ShownView) {
    let radius = view.planet.radius;
    let spacing = view.mesh.spacing() * radius;
    let samples = text::count(view.mesh.len());
    row(ui, "Seed", view.planet.seed.to_string());
    row(ui, "Radius", format!("{} km", text::number(radius)));
    row(ui, "Samples", format!("{samples}, {spacing:.0} km apart"));
    row(ui, "Plates", view.plates.rows().len().to_string());
}

fn new_planet(ui: &mut Ui, session: &Session, form: &mut PlanetForm, out: &mut Outbox) {
    let recipe = &mut form.recipe;
    field(ui, "Seed", |ui| seed(ui, &mut recipe.seed));
    whole_number(ui, "Samples", &mut recipe.samples, 100..=2_000_000);
    if recipe.plates.is_empty() {
        let most = PlanetRecipe::MAX_PLATES as u32;
        whole_number(ui, "Plates", &mut recipe.plate_count, 2..=most);
    } else {
        let count = recipe.plates.len();
        row(ui, "Plates", format!("{count} in the preset"));
    }
    if recipe.continents.is_empty() {
        field(ui, "Land", |ui| land(ui, &mut recipe.land));
    } else {
        let count = recipe.continents.len();
        row(ui, "Land", format!("{count} continents in the preset"));
    }
    preset(ui, session, form, out);
    let grow = primary_button(ui, !session.is_growing(), "Grow this planet");
    let grow = grow.on_hover_text("N. The present planet stays until the new one is there");
    if grow.clicked() {
        out.ask(Action::Grow(Box::new(form.recipe.clone())));
    }
}

fn seed(ui: &mut Ui, seed: &mut u64) {
    let another = ui.small_button("🎲").on_hover_text("Another seed");
    if another.clicked() {
        *seed = another_seed(*seed);
    }
    ui.add(DragValue::new(seed).speed(0.1));
}

fn land(ui: &mut Ui, share: &mut f64) {
    ui.spacing_mut().slider_width = 86.0;
    let slider = Slider::new(share, 0.0..=0.9)
        .custom_formatter(|share, _| format!("{:.0} %", share * 100.0))
        .custom_parser(share_of_percent);
    ui.add(slider);
}

fn share_of_percent(text: &str) -> Option<f64> {
    let percent: f64 = text.trim_end_matches(['%', ' ']).parse().ok()?;
    Some(percent / 100.0)
}

fn preset(ui: &mut Ui, session: &Session, form: &mut PlanetForm, out: &mut Outbox) {
    ui.horizontal(|ui| {
        let edit = TextEdit::singleline(&mut form.preset_path).hint_text("preset.planet.ron");
        ui.add(edit.desired_width(ui.available_width() - 58.0));
        let path = form.preset_path.trim();
        let ready = !session.is_growing() && !path.is_empty();
        let read = ui
            .add_enabled(ready, Button::new("Read"))
            .on_hover_text("Takes plates, continents and parameters from the file");
        if read.clicked() {
            out.ask(Action::ReadPreset(path.into()));
        }
    });
    let Some(name) = &form.preset else { return };
    let source = format!("from {name}");
    ui.horizontal(|ui| {
        hint(ui, source);
        if ui.small_button("Forget").clicked() {
            form.forget_preset();
        }
    });
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
        let save = ui.add_enabled(has_planet, Button::new("Save"));
        let save = save.on_hover_text("F5. Written in the background");
        if save.clicked() {
            out.ask(Action::Save(form.file()));
        }
        let load = ui.add_enabled(!session.is_growing(), Button::new("Load"));
        if load.on_hover_text("F9").clicked() {
            out.ask(Action::Load(form.file()));
        }
        if let Some(what) = session.busy() {
            let busy = RichText::new(format!("{what} …")).small();
            ui.label(busy.color(ACCENT));
        }
    });
    let button = Button::new("Save as scenario");
    let button = ui.add_enabled(has_planet, button).on_hover_text(
        "Writes the commands so far to a new file .scenario.ron beside the planet's; played on the \
         same recipe, they give the same planet",
    );
    if button.clicked() {
        // Only now: looking for a free name asks the disk.
        out.ask(Action::SaveScenario(form.scenario_file()));
    }
}

fn picture(ui: &mut Ui, form: &mut PlanetForm, out: &mut Outbox) {
    let edit = TextEdit::singleline(&mut form.picture).hint_text("pangaea-001.png");
    ui.add(edit.desired_width(f32::INFINITY));
    if button(ui, "Save picture", "F2") {
        let name = form.picture.trim();
        let path = (!name.is_empty()).then(|| with_extension(name, "png"));
        out.ask(Action::Screenshot(path));
    }
}

fn with_extension(name: &str, extension: &str) -> PathBuf {
    let mut path = PathBuf::from(name);
    if path.extension().is_none() {
        path.set_extension(extension);
    }
    path
}

/// The next seed of a scrambled row: a planet that looks nothing like this one.
fn another_seed(seed: u64) -> u64 {
    (seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407)
        >> 33)
        % 100_000
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy::prelude::*;

    #[test]
    fn a_preset_that_was_read_fills_the_form_until_it_is_forgotten() {
        let mut app = App::new();
        app.add_message::<PresetRead>()
            .init_resource::<PlanetForm>()
            .add_systems(Update, take_preset);
        let recipe = PlanetRecipe {
            seed: 5,
            land: 0.1,
            ..default()
        };
        let path = "presets/a.planet.ron".into();
        app.world_mut().write_message(PresetRead { recipe, path });
        app.update();
        let mut form = app.world_mut().resource_mut::<PlanetForm>();
        assert_eq!((form.recipe.seed, form.recipe.land), (5, 0.1));
        assert_eq!(form.preset.as_deref(), Some("a.planet.ron"));
        form.forget_preset();
        let defaults = PlanetRecipe::default();
        assert_eq!((form.recipe.seed, form.recipe.land), (5, defaults.land));
        assert_eq!(form.preset, None);
    }
}
