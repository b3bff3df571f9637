//! The key of the overlay, floating over the lower edge of the globe.

use crate::explorer::state::Look;
use crate::explorer::style::{BRIGHT, FAINT, LINE, TEXT, floating_frame};
use crate::explorer::text;
use crate::explorer::view::ShownView;
use bevy::prelude::{Entity, Resource};
use bevy_egui::egui::{
    Align2, Area, Color32, Context, CornerRadius, FontId, Id, Mesh, Order, Painter, Rect, RichText,
    Sense, Shape, Stroke, StrokeKind, Ui, pos2, vec2,
};
use bevy_pangaea::overlay::{BoundaryKind, Legend, LegendEntries, Overlay};

/// The legend of the present picture, renewed when the picture is.
#[derive(Resource, Default)]
pub struct LegendCache {
    of: Option<(Entity, Overlay, u64)>,
    legend: Option<Legend>,
}

impl LegendCache {
    fn get(&mut self, view: &ShownView, overlay: Overlay) -> Option<&Legend> {
        let of = Some((view.entity, overlay, view.surface.version));
        if self.of != of {
            self.of = of;
            self.legend = Some(overlay.legend(&view.overlay_input()));
        }
        self.legend.as_ref()
    }
}

/// Draws the legend at the lower edge of the free area.
pub fn show(ctx: &Context, free: Rect, view: &ShownView, look: &Look, cache: &mut LegendCache) {
    let Some(legend) = cache.get(view, look.overlay) else {
        return;
    };
    Area::new(Id::new("legend"))
        .order(Order::Middle)
        .interactable(false)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(free.center_bottom() - vec2(0.0, 14.0))
        .show(ctx, |ui| {
            floating_frame().show(ui, |ui| {
                title(ui, legend);
                entries(ui, &legend.entries);
                if look.boundaries && look.overlay != Overlay::Plates {
                    boundaries(ui);
                }
            });
        });
}

fn entries(ui: &mut Ui, entries: &LegendEntries) {
    match entries {
        LegendEntries::Gradient { stops } => gradient(ui, stops),
        LegendEntries::Classes(classes) => {
            chips(ui, classes.iter().map(|(n, c)| (n.as_str(), *c)));
        }
    }
}

fn boundaries(ui: &mut Ui) {
    let kinds = BoundaryKind::DRAWN.iter();
    chips(ui, kinds.map(|kind| (kind.name(), kind.color())));
}

fn title(ui: &mut Ui, legend: &Legend) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(legend.title).color(BRIGHT).strong());
        if !legend.unit.is_empty() {
            ui.label(RichText::new(legend.unit).color(FAINT));
        }
    });
}

/// A bar whose left and right edge stand for two values.
#[derive(Clone, Copy)]
struct ScaleBar {
    rect: Rect,
    low: f32,
    high: f32,
}

impl ScaleBar {
    /// Where a value stands.
    fn x(&self, value: f32) -> f32 {
        let share = self.rect.width() * (value - self.low);
        self.rect.left() + share / (self.high - self.low).max(1e-6)
    }
}

/// A bar of colours over a scale of round numbers.
fn gradient(ui: &mut Ui, stops: &[(f32, [u8; 4])]) {
    let (Some(first), Some(last)) = (stops.first(), stops.last()) else {
        return;
    };
    let (area, _) = ui.allocate_exact_size(vec2(340.0, 30.0), Sense::hover());
    let bar = ScaleBar {
        rect: Rect::from_min_size(area.min, vec2(area.width(), 12.0)),
        low: first.0,
        high: last.0,
    };
    let painter = ui.painter();
    painter.add(Shape::mesh(colors(bar, stops)));
    painter.rect_stroke(
        bar.rect,
        CornerRadius::ZERO,
        Stroke::new(1.0, LINE),
        StrokeKind::Outside,
    );
    scale(painter, bar);
}

/// The colours of a bar: two vertices for each stop, two triangles between two stops.
fn colors(bar: ScaleBar, stops: &[(f32, [u8; 4])]) -> Mesh {
    let mut mesh = Mesh::default();
    for &(value, color) in stops {
        let k = mesh.vertices.len() as u32;
        let (x, color) = (bar.x(value), opaque(color));
        mesh.colored_vertex(pos2(x, bar.rect.top()), color);
        mesh.colored_vertex(pos2(x, bar.rect.bottom()), color);
        if k > 0 {
            mesh.add_triangle(k - 2, k - 1, k);
            mesh.add_triangle(k - 1, k, k + 1);
        }
    }
    mesh
}

/// Round numbers below a bar.
fn scale(painter: &Painter, bar: ScaleBar) {
    // At most seven numbers fit side by side.
    let step = round_step((bar.high - bar.low) / 6.0);
    let mut tick = (bar.low / step).ceil() * step;
    while tick <= bar.high + step * 1e-3 {
        let at = pos2(bar.x(tick), bar.rect.bottom());
        painter.line_segment([at, at + vec2(0.0, 4.0)], Stroke::new(1.0, FAINT));
        painter.text(
            at + vec2(0.0, 5.0),
            Align2::CENTER_TOP,
            text::number(f64::from(tick)),
            FontId::proportional(10.5),
            TEXT,
        );
        tick += step;
    }
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
fn round_step(least: f32) -> f32 {
    let mut power = 1e-6;
    while power * 10.0 < least.max(1e-6) {
        power *= 10.0;
    }
    [1.0, 2.0, 5.0, 10.0]
        .map(|k| k * power)
        .into_iter()
        .find(|&s| s >= least)
        .unwrap_or(1.0)
}

/// Names with their colours, three in a line.
fn chips<'a>(ui: &mut Ui, classes: impl Iterator<Item = (&'a str, [u8; 4])>) {
    let classes: Vec<_> = classes.collect();
    for line in classes.chunks(3) {
        ui.horizontal(|ui| {
            for (name, color) in line {
                let (chip, _) = ui.allocate_exact_size(vec2(11.0, 11.0), Sense::hover());
                ui.painter()
                    .rect_filled(chip, CornerRadius::same(2), opaque(*color));
                ui.label(RichText::new(*name).size(11.0).color(TEXT));
                ui.add_space(4.0);
            }
        });
    }
}

fn opaque([r, g, b, _]: [u8; 4]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_have_round_steps() {
        for (least, step) in [
            (3.1, 5.0),
            (0.9, 1.0),
            (16.7, 20.0),
            (60.0, 100.0),
            (0.03, 0.05),
        ] {
            assert!((round_step(least) - step).abs() < 1e-4 * step, "{least}");
        }
    }
}
