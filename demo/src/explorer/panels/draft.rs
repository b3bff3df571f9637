//! Numbers while they are being edited.
//!
//! Every command is recorded, so a slider that is being dragged must not send one each frame: the
//! value waits here until the mouse lets go, and shows until the planet has taken it over.

use bevy_egui::egui::{Id, Response, Ui};
use core::fmt::Debug;
use core::hash::Hash;

/// How long a sent value is shown while the planet has not taken it, in s.
const LONGEST_WAIT: f64 = 1.5;

#[derive(Clone, Copy)]
struct Draft {
    value: f64,
    /// When it was sent, in s; `None` while it is being edited.
    sent_at: Option<f64>,
}

impl Draft {
    /// Whether the draft is shown instead of the value `current` of the model.
    fn is_shown(&self, current: f64, now: f64) -> bool {
        self.sent_at
            .is_none_or(|sent| self.value != current && now < sent + LONGEST_WAIT)
    }
}

/// Shows a widget for a number that is `current` in the model. Returns the new number once it is
/// settled.
pub fn edit(
    ui: &mut Ui,
    key: impl Hash + Debug + Copy,
    current: f64,
    widget: impl FnOnce(&mut Ui, &mut f64) -> Response,
) -> Option<f64> {
    let id = Id::new(("draft", key));
    let now = ui.input(|input| input.time);
    let stored = ui
        .data(|data| data.get_temp::<Draft>(id))
        .filter(|draft| draft.is_shown(current, now));
    let mut value = stored.map_or(current, |draft| draft.value);
    let response = widget(ui, &mut value);
    // A slider settles when the mouse lets go, a text field when the focus leaves it, a click at
    // once.
    let busy = response.dragged() || response.has_focus();
    let settled = response.drag_stopped() || response.lost_focus() || (response.changed() && !busy);
    let is_new = settled && value != current;
    let sent = stored.filter(|draft| draft.sent_at.is_some());
    let sent_at = is_new.then_some(now);
    let draft = if is_new || busy || response.changed() {
        Some(Draft { value, sent_at })
    } else {
        sent
    };
    keep(ui, id, draft);
    // Losing the focus after Enter would send the same number a second time.
    let sent_before = sent.is_some_and(|draft| draft.value == value);
    (is_new && !sent_before).then_some(value)
}

/// Keeps a draft until the next frame, or forgets it.
fn keep(ui: &Ui, id: Id, draft: Option<Draft>) {
    ui.data_mut(|data| {
        if let Some(draft) = draft {
            data.insert_temp(id, draft);
        } else {
            data.remove::<Draft>(id);
        }
    });
}
