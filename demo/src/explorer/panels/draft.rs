//! Numbers while they are being edited.
//!
//! Every command is recorded, so a slider that is being dragged must not send one each frame: the
//! value waits here until the mouse lets go, and shows until the planet has taken it over.

use bevy_egui::egui::{Id, Response, Ui};

/// How long a sent value is shown while the planet has not taken it, in s.
const PATIENCE: f64 = 1.5;

#[derive(Clone, Copy)]
struct Draft {
    value: f64,
    sent_at: Option<f64>,
}

/// Shows a widget for a number that is `current` in the model. Returns the new number once it is
/// settled.
pub fn edit(
    ui: &mut Ui,
    key: impl core::hash::Hash + core::fmt::Debug + Copy,
    current: f64,
    widget: impl FnOnce(&mut Ui, &mut f64) -> Response,
) -> Option<f64> {
    let id = Id::new(("draft", key));
    let now = ui.input(|input| input.time);
    let stored = ui.data(|data| data.get_temp::<Draft>(id)).filter(|draft| {
        draft
            .sent_at
            .is_none_or(|sent| draft.value != current && now < sent + PATIENCE)
    });
    let mut value = stored.map_or(current, |draft| draft.value);
    let response = widget(ui, &mut value);
    let busy = response.dragged() || response.has_focus();
    let settled = response.drag_stopped() || response.lost_focus() || (response.changed() && !busy);
    let draft = if settled && value != current {
        Some(Draft {
            value,
            sent_at: Some(now),
        })
    } else if busy || response.changed() {
        Some(Draft {
            value,
            sent_at: None,
        })
    } else {
        stored.filter(|draft| draft.sent_at.is_some())
    };
    ui.data_mut(|data| {
        if let Some(draft) = draft {
            data.insert_temp(id, draft);
        } else {
            data.remove::<Draft>(id);
        }
    });
    let sent = stored.is_some_and(|old| old.sent_at.is_some() && old.value == value);
    (settled && value != current && !sent).then_some(value)
}
