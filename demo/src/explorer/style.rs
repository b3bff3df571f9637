//! The look of the explorer: colours, spacing and frames.

use bevy_egui::egui::style::{HandleShape, Spacing, WidgetVisuals, Widgets};
use bevy_egui::egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Frame, Margin, Stroke, TextStyle, Theme,
    Visuals, vec2,
};

/// Things that can be acted upon, and things that are active.
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
/// Fields and buttons under the pointer.
const HOVERED: Color32 = Color32::from_rgb(54, 64, 83);
/// Fine lines.
pub const LINE: Color32 = Color32::from_rgb(46, 55, 72);
/// Errors.
pub const ERROR: Color32 = Color32::from_rgb(255, 118, 104);
/// Good news.
pub const GOOD: Color32 = Color32::from_rgb(122, 204, 150);

/// Corners of fields, buttons and titles.
pub const CORNERS: CornerRadius = CornerRadius::same(4);

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
        set_spacing(&mut style.spacing);
        style.interaction.selectable_labels = false;
        style.interaction.tooltip_delay = 0.35;
        style.visuals = visuals();
    });
}

fn set_spacing(spacing: &mut Spacing) {
    spacing.item_spacing = vec2(6.0, 5.0);
    spacing.button_padding = vec2(8.0, 3.0);
    spacing.interact_size = vec2(30.0, 21.0);
    spacing.slider_rail_height = 4.0;
    spacing.icon_width = 15.0;
    spacing.tooltip_width = 320.0;
    spacing.scroll.bar_width = 7.0;
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
    look.widgets = widgets();
    look
}

/// The look of widgets in each of their states.
fn widgets() -> Widgets {
    Widgets {
        noninteractive: widget(PANEL, LINE, TEXT),
        inactive: widget(FIELD, Color32::TRANSPARENT, TEXT),
        hovered: widget(HOVERED, Color32::from_rgb(92, 105, 130), BRIGHT),
        active: widget(Color32::from_rgb(66, 78, 101), ACCENT, BRIGHT),
        open: widget(RAISED, LINE, BRIGHT),
    }
}

fn widget(fill: Color32, line: Color32, text: Color32) -> WidgetVisuals {
    WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(1.0, line),
        fg_stroke: Stroke::new(1.2, text),
        corner_radius: CORNERS,
        expansion: 0.0,
    }
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
