//! The keyboard. Letters and signs go by what is printed on the key, whatever the layout.

use super::HelpPage;
use super::panels::planet::PlanetForm;
use super::state::{Action, EXAGGERATION_LIMITS, Look, Selection, Tool};
use bevy::input::keyboard::{Key, KeyboardInput};
use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_pangaea::overlay::Overlay;

/// Reads the keys; none while text is being typed.
pub fn read(
    mut keys: MessageReader<KeyboardInput>,
    egui: Res<EguiWantsInput>,
    (mut look, mut tool, mut help): (ResMut<Look>, ResMut<Tool>, ResMut<HelpPage>),
    (selection, form): (Res<Selection>, Res<PlanetForm>),
    mut actions: MessageWriter<Action>,
) {
    if egui.wants_keyboard_input() {
        keys.clear();
        return;
    }
    for key in keys.read().filter(|key| key.state.is_pressed()) {
        match &key.logical_key {
            Key::Character(text) => letter(
                text,
                key.repeat,
                &mut look,
                &mut tool,
                &mut help,
                &form,
                &mut actions,
            ),
            _ if key.repeat => {}
            Key::Space => {
                actions.write(Action::TogglePlay);
            }
            Key::F1 => help.0 = !help.0,
            Key::F2 => {
                actions.write(Action::Screenshot(None));
            }
            Key::F5 => {
                actions.write(Action::Save(form.file()));
            }
            Key::F9 => {
                actions.write(Action::Load(form.file()));
            }
            Key::Escape if help.0 => help.0 = false,
            Key::Escape if *tool != Tool::Select => *tool = Tool::Select,
            Key::Escape if selection.0.is_some() => {
                actions.write(Action::Select(None));
            }
            _ => {}
        }
    }
}

fn letter(
    text: &str,
    repeat: bool,
    look: &mut Look,
    tool: &mut Tool,
    help: &mut HelpPage,
    form: &PlanetForm,
    actions: &mut MessageWriter<Action>,
) {
    match text.to_lowercase().as_str() {
        "+" | "=" => exaggerate(look, 1.15),
        "-" | "_" => exaggerate(look, 1.0 / 1.15),
        "s" => {
            actions.write(Action::SingleStep);
        }
        _ if repeat => {}
        "n" => {
            actions.write(Action::Grow(Box::new(form.recipe.clone())));
        }
        "h" | "?" => help.0 = !help.0,
        "w" => look.sea = !look.sea,
        "m" => look.wireframe = !look.wireframe,
        "p" => look.boundaries = !look.boundaries,
        "b" => {
            *tool = if *tool == Tool::Paint {
                Tool::Select
            } else {
                Tool::Paint
            }
        }
        "," => look.overlay = neighbour(look.overlay, Overlay::ALL.len() - 1),
        "." => look.overlay = neighbour(look.overlay, 1),
        digit => {
            if let Some(overlay) = digit.parse().ok().and_then(numbered) {
                look.overlay = overlay;
            }
        }
    }
}

fn exaggerate(look: &mut Look, factor: f32) {
    let (low, high) = EXAGGERATION_LIMITS;
    look.exaggeration = (look.exaggeration * factor).clamp(low, high);
}

/// The overlay that keys 1 to 9 and then 0 choose.
fn numbered(digit: usize) -> Option<Overlay> {
    Overlay::ALL
        .get((digit + 9) % 10)
        .copied()
        .filter(|_| digit < 10)
}

/// The overlay `by` places further down the list, which is a ring.
fn neighbour(overlay: Overlay, by: usize) -> Overlay {
    let here = Overlay::ALL
        .iter()
        .position(|&other| other == overlay)
        .unwrap_or(0);
    Overlay::ALL[(here + by) % Overlay::ALL.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_choose_the_first_ten_overlays() {
        assert_eq!(numbered(1), Some(Overlay::ALL[0]));
        assert_eq!(numbered(9), Some(Overlay::ALL[8]));
        assert_eq!(numbered(0), Some(Overlay::ALL[9]));
        assert_eq!(numbered(10), None);
    }

    #[test]
    fn overlays_form_a_ring() {
        let mut overlay = Overlay::Elevation;
        for _ in 0..Overlay::ALL.len() {
            overlay = neighbour(overlay, 1);
        }
        assert_eq!(overlay, Overlay::Elevation);
        assert_eq!(
            neighbour(neighbour(overlay, 1), Overlay::ALL.len() - 1),
            overlay
        );
    }
}
