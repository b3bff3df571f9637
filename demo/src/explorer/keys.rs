//! The keyboard. Letters and signs go by what is printed on the key, whatever the layout.

use super::panels::planet::PlanetForm;
use super::state::{Action, EXAGGERATION_LIMITS, HelpPage, Look, PlateDrag, Selection, Tool};
use bevy::ecs::system::SystemParam;
use bevy::input::keyboard::{Key, KeyboardInput};
use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_pangaea::overlay::Overlay;

/// Factor of the exaggeration of the relief per press.
const EXAGGERATION_STEP: f32 = 1.15;

/// The parts of the explorer that keys act on.
#[derive(SystemParam)]
pub struct KeyTargets<'w> {
    look: ResMut<'w, Look>,
    tool: ResMut<'w, Tool>,
    drag: ResMut<'w, PlateDrag>,
    help: ResMut<'w, HelpPage>,
    selection: Res<'w, Selection>,
    form: Res<'w, PlanetForm>,
    actions: MessageWriter<'w, Action>,
}

/// Reads the keys, unless text is being typed.
pub fn read(
    mut keys: MessageReader<KeyboardInput>,
    egui: Res<EguiWantsInput>,
    mut targets: KeyTargets,
) {
    if egui.wants_keyboard_input() {
        keys.clear();
        return;
    }
    for key in keys.read().filter(|key| key.state.is_pressed()) {
        match &key.logical_key {
            Key::Character(text) => targets.letter(&text.to_lowercase(), key.repeat),
            named if !key.repeat => targets.named(named),
            _ => {}
        }
    }
}

impl KeyTargets<'_> {
    /// A key that has a name instead of a sign.
    fn named(&mut self, key: &Key) {
        match key {
            Key::Space => self.ask(Action::TogglePlay),
            Key::F1 => self.help.0 = !self.help.0,
            Key::F2 => self.ask(Action::Screenshot(None)),
            Key::F5 => self.ask(Action::Save(self.form.file())),
            Key::F9 => self.ask(Action::Load(self.form.file())),
            Key::Escape => self.escape(),
            _ => {}
        }
    }

    /// Ends the innermost of the things that are open.
    fn escape(&mut self) {
        if self.help.0 {
            self.help.0 = false;
        } else if self.drag.0.is_some() {
            self.drag.0 = None;
        } else if *self.tool != Tool::Select {
            *self.tool = Tool::Select;
        } else if self.selection.0.is_some() {
            self.ask(Action::Select(None));
        }
    }

    /// A key with a sign; `repeat` while it is held down.
    fn letter(&mut self, sign: &str, repeat: bool) {
        match sign {
            "+" | "=" => exaggerate(&mut self.look, EXAGGERATION_STEP),
            "-" | "_" => exaggerate(&mut self.look, 1.0 / EXAGGERATION_STEP),
            "s" => self.ask(Action::SingleStep),
            // A key held down repeats the exaggeration and steps, and nothing below.
            _ if repeat => {}
            "n" => self.ask(Action::Grow(Box::new(self.form.recipe.clone()))),
            "h" | "?" => self.help.0 = !self.help.0,
            "w" => self.look.sea = !self.look.sea,
            "m" => self.look.wireframe = !self.look.wireframe,
            "p" => self.look.boundaries = !self.look.boundaries,
            "b" => self.toggle_brush(),
            "," => self.look.overlay = neighbour(self.look.overlay, Overlay::ALL.len() - 1),
            "." => self.look.overlay = neighbour(self.look.overlay, 1),
            digit => {
                if let Some(overlay) = digit.parse().ok().and_then(numbered) {
                    self.look.overlay = overlay;
                }
            }
        }
    }

    fn toggle_brush(&mut self) {
        *self.tool = match *self.tool {
            Tool::Paint => Tool::Select,
            _ => Tool::Paint,
        };
    }

    fn ask(&mut self, action: Action) {
        self.actions.write(action);
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
