//! The small widgets that every panel is made of.

use super::style::{ACCENT, BRIGHT, CORNERS, FAINT, FIELD, ON_ACCENT, RAISED, TEXT};
use bevy_egui::egui::collapsing_header::CollapsingState;
use bevy_egui::egui::emath::Rot2;
use bevy_egui::egui::{
    Align, Align2, Button, Color32, DragValue, FontId, Frame, Label, Layout, Margin, Pos2, Rect,
    Response, RichText, Sense, Shape, Stroke, Ui, vec2,
};
use core::ops::RangeInclusive;

/// The look of the title of a part that folds away.
#[derive(Clone, Copy)]
struct TitleStyle {
    height: f32,
    font_size: f32,
    /// Behind the title while the pointer is elsewhere.
    fill: Color32,
    triangle: Color32,
    text: Color32,
}

const SECTION: TitleStyle = TitleStyle {
    height: 25.0,
    font_size: 13.0,
    fill: RAISED,
    triangle: ACCENT,
    text: BRIGHT,
};

const SUBSECTION: TitleStyle = TitleStyle {
    height: 21.0,
    font_size: 12.0,
    fill: Color32::TRANSPARENT,
    triangle: FAINT,
    text: TEXT,
};

/// A part of a panel that folds away when its title is clicked.
pub fn section(ui: &mut Ui, title: &str, open: bool, body: impl FnOnce(&mut Ui)) {
    fold(ui, title, open, SECTION, body);
    ui.add_space(3.0);
}

/// A part of a section that folds away.
pub fn subsection(ui: &mut Ui, title: &str, open: bool, body: impl FnOnce(&mut Ui)) {
    fold(ui, title, open, SUBSECTION, body);
}

fn fold(ui: &mut Ui, title: &str, open: bool, look: TitleStyle, body: impl FnOnce(&mut Ui)) {
    let id = ui.make_persistent_id(("fold", title));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, open);
    let size = vec2(ui.available_width(), look.height);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let response = ui.interact(rect, id.with("title"), Sense::click());
    if response.clicked() {
        state.toggle(ui);
    }
    let openness = state.openness(ui.ctx());
    fold_title(ui, rect, title, look, response.hovered(), openness);
    let inner = Frame::new().inner_margin(Margin {
        left: 4,
        right: 2,
        top: 3,
        bottom: 4,
    });
    state.show_body_unindented(ui, |ui| {
        inner.show(ui, body);
    });
}

fn fold_title(ui: &Ui, rect: Rect, title: &str, look: TitleStyle, hovered: bool, openness: f32) {
    let (fill, text) = if hovered {
        (FIELD, BRIGHT)
    } else {
        (look.fill, look.text)
    };
    let painter = ui.painter();
    painter.rect_filled(rect, CORNERS, fill);
    let center = rect.left_center() + vec2(12.0, 0.0);
    painter.add(triangle(center, openness, look.triangle));
    let at = rect.left_center() + vec2(24.0, 0.0);
    let font = FontId::proportional(look.font_size);
    painter.text(at, Align2::LEFT_CENTER, title, font, text);
}

/// A triangle that points to the right where `openness` is 0, and down where it is 1.
fn triangle(center: Pos2, openness: f32, color: Color32) -> Shape {
    let turn = Rot2::from_angle(openness * core::f32::consts::FRAC_PI_2);
    let points = [vec2(-2.5, -4.0), vec2(3.5, 0.0), vec2(-2.5, 4.0)].map(|p| center + turn * p);
    Shape::convex_polygon(points.to_vec(), color, Stroke::NONE)
}

/// A label on the left and a value on the right.
pub fn row(ui: &mut Ui, label: &str, value: impl Into<String>) -> Response {
    let value = RichText::new(value).monospace().color(BRIGHT);
    field(ui, label, |ui| ui.add(Label::new(value).truncate()))
}

/// A label on the left and a widget on the right.
pub fn field<R>(ui: &mut Ui, label: &str, widget: impl FnOnce(&mut Ui) -> R) -> R {
    ui.horizontal(|ui| {
        ui.label(RichText::new(label).color(FAINT));
        ui.with_layout(Layout::right_to_left(Align::Center), widget)
            .inner
    })
    .inner
}

/// A button that stands out.
pub fn primary_button(ui: &mut Ui, enabled: bool, text: &str) -> Response {
    let text = RichText::new(text).color(ON_ACCENT).strong();
    ui.add_enabled(enabled, Button::new(text).fill(ACCENT))
}

/// A button that is on or off.
pub fn toggle_button(ui: &mut Ui, on: bool, text: &str) -> Response {
    let (fill, color) = if on {
        (ACCENT, ON_ACCENT)
    } else {
        (FIELD, TEXT)
    };
    ui.add(Button::new(RichText::new(text).color(color)).fill(fill))
}

/// A short remark in small letters.
pub fn hint(ui: &mut Ui, text: impl Into<String>) -> Response {
    ui.add(Label::new(RichText::new(text).small().color(FAINT)).wrap())
}

/// A whole number with limits, its label on the left.
pub fn whole_number(ui: &mut Ui, label: &str, value: &mut u32, range: RangeInclusive<u32>) {
    let speed = (f64::from(*value) * 0.01).max(0.2);
    field(ui, label, |ui| {
        ui.add(DragValue::new(value).range(range).speed(speed))
    });
}

/// A button without anything around it, with a tooltip. Returns whether it was clicked.
pub fn button(ui: &mut Ui, text: &str, tooltip: &str) -> bool {
    ui.button(text).on_hover_text(tooltip).clicked()
}
