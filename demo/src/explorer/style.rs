//! The look of the explorer: colours, spacing and the small widgets that every panel is made of.

use bevy_egui::egui::collapsing_header::CollapsingState;
use bevy_egui::egui::style::HandleShape;
use bevy_egui::egui::{
    Align, Button, Color32, Context, CornerRadius, FontFamily, FontId, Frame, Label, Layout,
    Margin, Response, RichText, Sense, Shape, Stroke, TextStyle, Theme, Ui, Visuals, vec2,
};

/// What can be acted upon, and what is active: molten rock.
pub const ACCENT: Color32 = Color32::from_rgb(240, 160, 84);
/// Text on the accent.
pub const ON_ACCENT: Color32 = Color32::from_rgb(24, 15, 6);
/// Text.
pub const TEXT: Color32 = Color32::from_rgb(206, 213, 224);
/// Titles and values.
pub const BRIGHT: Color32 = Color32::from_rgb(242, 245, 250);
/// Labels and hints.
pub const FAINT: Color32 = Color32::from_rgb(132, 143, 161);
/// Behind the panels.
pub const PANEL: Color32 = Color32::from_rgb(17, 21, 29);
/// Behind section titles.
pub const RAISED: Color32 = Color32::from_rgb(27, 33, 44);
/// Fields and buttons.
pub const FIELD: Color32 = Color32::from_rgb(40, 48, 63);
/// Fine lines.
pub const LINE: Color32 = Color32::from_rgb(46, 55, 72);
/// Errors.
pub const ERROR: Color32 = Color32::from_rgb(255, 118, 104);
/// Good news.
pub const GOOD: Color32 = Color32::from_rgb(122, 204, 150);

const ROUND: CornerRadius = CornerRadius::same(4);

/// Gives the context the look of the explorer.
pub fn apply(ctx: &Context) {
    ctx.set_theme(Theme::Dark);
    ctx.all_styles_mut(|style| {
        style.text_styles = [
            (TextStyle::Heading, 15.0, FontFamily::Proportional),
            (TextStyle::Body, 12.5, FontFamily::Proportional),
            (TextStyle::Button, 12.5, FontFamily::Proportional),
            (TextStyle::Small, 10.5, FontFamily::Proportional),
            (TextStyle::Monospace, 11.5, FontFamily::Monospace),
        ]
        .map(|(text, size, family)| (text, FontId::new(size, family)))
        .into();
        style.spacing.item_spacing = vec2(6.0, 5.0);
        style.spacing.button_padding = vec2(8.0, 3.0);
        style.spacing.interact_size = vec2(30.0, 21.0);
        style.spacing.slider_rail_height = 4.0;
        style.spacing.icon_width = 15.0;
        style.spacing.tooltip_width = 320.0;
        style.spacing.scroll.bar_width = 7.0;
        style.interaction.selectable_labels = false;
        style.interaction.tooltip_delay = 0.35;
        style.visuals = visuals();
    });
}

fn visuals() -> Visuals {
    let mut look = Visuals::dark();
    look.panel_fill = PANEL;
    look.window_fill = PANEL;
    look.window_stroke = Stroke::new(1.0, LINE);
    look.window_corner_radius = CornerRadius::same(8);
    look.menu_corner_radius = CornerRadius::same(6);
    look.extreme_bg_color = Color32::from_rgb(10, 13, 18);
    look.faint_bg_color = Color32::from_rgb(22, 27, 36);
    look.weak_text_color = Some(FAINT);
    look.hyperlink_color = ACCENT;
    look.warn_fg_color = ACCENT;
    look.error_fg_color = ERROR;
    look.selection.bg_fill = Color32::from_rgb(196, 122, 56);
    look.selection.stroke = Stroke::new(1.0, BRIGHT);
    look.slider_trailing_fill = true;
    look.handle_shape = HandleShape::Circle;
    look.indent_has_left_vline = false;
    let states = [
        (&mut look.widgets.noninteractive, PANEL, LINE, TEXT),
        (
            &mut look.widgets.inactive,
            FIELD,
            Color32::TRANSPARENT,
            TEXT,
        ),
        (
            &mut look.widgets.hovered,
            Color32::from_rgb(54, 64, 83),
            Color32::from_rgb(92, 105, 130),
            BRIGHT,
        ),
        (
            &mut look.widgets.active,
            Color32::from_rgb(66, 78, 101),
            ACCENT,
            BRIGHT,
        ),
        (&mut look.widgets.open, RAISED, LINE, BRIGHT),
    ];
    for (widget, fill, line, text) in states {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = Stroke::new(1.0, line);
        widget.fg_stroke = Stroke::new(1.2, text);
        widget.corner_radius = ROUND;
        widget.expansion = 0.0;
    }
    look
}

/// The frame of a side panel.
pub fn panel_frame() -> Frame {
    Frame::new().fill(PANEL).inner_margin(Margin {
        left: 10,
        right: 4,
        top: 8,
        bottom: 8,
    })
}

/// The frame of things that float over the globe.
pub fn floating_frame() -> Frame {
    Frame::new()
        .fill(Color32::from_rgba_unmultiplied(17, 21, 29, 242))
        .stroke(Stroke::new(1.0, LINE))
        .corner_radius(CornerRadius::same(8))
        .inner_margin(Margin::symmetric(12, 8))
}

/// A part of a panel that folds away when its title is clicked.
pub fn section(ui: &mut Ui, title: &str, open: bool, body: impl FnOnce(&mut Ui)) {
    fold(ui, title, open, true, body);
    ui.add_space(3.0);
}

/// A part of a section that folds away.
pub fn subsection(ui: &mut Ui, title: &str, open: bool, body: impl FnOnce(&mut Ui)) {
    fold(ui, title, open, false, body);
}

fn fold(ui: &mut Ui, title: &str, open: bool, main: bool, body: impl FnOnce(&mut Ui)) {
    let id = ui.make_persistent_id(("fold", title));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, open);
    let height = if main { 25.0 } else { 21.0 };
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let response = ui.interact(rect, id.with("title"), Sense::click());
    if response.clicked() {
        state.toggle(ui);
    }
    let hovered = response.hovered();
    if main || hovered {
        ui.painter()
            .rect_filled(rect, ROUND, if hovered { FIELD } else { RAISED });
    }
    let openness = state.openness(ui.ctx());
    let center = rect.left_center() + vec2(12.0, 0.0);
    let color = if main { ACCENT } else { FAINT };
    ui.painter().add(triangle(center, openness, color));
    let font = if main {
        FontId::proportional(13.0)
    } else {
        FontId::proportional(12.0)
    };
    let text = if main || hovered { BRIGHT } else { TEXT };
    let at = rect.left_center() + vec2(24.0, 0.0);
    ui.painter()
        .text(at, bevy_egui::egui::Align2::LEFT_CENTER, title, font, text);
    state.show_body_unindented(ui, |ui| {
        Frame::new()
            .inner_margin(Margin {
                left: 4,
                right: 2,
                top: 3,
                bottom: 4,
            })
            .show(ui, body);
    });
}

fn triangle(center: bevy_egui::egui::Pos2, openness: f32, color: Color32) -> Shape {
    let angle = openness * core::f32::consts::FRAC_PI_2;
    let turn = bevy_egui::egui::emath::Rot2::from_angle(angle);
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
