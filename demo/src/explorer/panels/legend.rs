//! The key of the overlay, floating over the lower edge of the globe.

use crate::explorer::state::{Look, View};
use crate::explorer::style::{BRIGHT, FAINT, LINE, TEXT, floating_frame};
use crate::explorer::text;
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
    fn get(&mut self, view: &View, overlay: Overlay) -> Option<&Legend> {
        let of = Some((view.entity, overlay, view.surface.version));
        if self.of != of {
            self.of = of;
            self.legend = Some(overlay.legend(&view.overlay_input()));
        }
        self.legend.as_ref()
    }
}

/// Draws the legend at the lower edge of the free area.
pub fn show(ctx: &Context, free: Rect, view: &View, look: &Look, cache: &mut LegendCache) {
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
                match &legend.entries {
                    LegendEntries::Gradient { stops } => gradient(ui, stops),
                    LegendEntries::Classes(classes) => {
                        chips(ui, classes.iter().map(|(n, c)| (n.as_str(), *c)))
                    }
                }
                if look.boundaries && look.overlay != Overlay::Plates {
                    chips(
                        ui,
                        BoundaryKind::ALL
                            .iter()
                            .map(|kind| (kind.label(), kind.color())),
                    );
                }
            });
        });
}

fn title(ui: &mut Ui, legend: &Legend) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(legend.title).color(BRIGHT).strong());
        if !legend.unit.is_empty() {
            ui.label(RichText::new(legend.unit).color(FAINT));
        }
    });
}

/// A bar of colours over a scale of round numbers.
fn gradient(ui: &mut Ui, stops: &[(f32, [u8; 4])]) {
    let (Some(first), Some(last)) = (stops.first(), stops.last()) else {
        return;
    };
    let (low, high) = (first.0, last.0);
    let (area, _) = ui.allocate_exact_size(vec2(340.0, 30.0), Sense::hover());
    let bar = Rect::from_min_size(area.min, vec2(area.width(), 12.0));
    let x = |value: f32| bar.left() + bar.width() * (value - low) / (high - low).max(1e-6);
    let mut mesh = Mesh::default();
    for (value, color) in stops {
        let k = mesh.vertices.len() as u32;
        mesh.colored_vertex(pos2(x(*value), bar.top()), opaque(*color));
        mesh.colored_vertex(pos2(x(*value), bar.bottom()), opaque(*color));
        if k > 0 {
            mesh.add_triangle(k - 2, k - 1, k);
            mesh.add_triangle(k - 1, k, k + 1);
        }
    }
    let painter = ui.painter();
    painter.add(Shape::mesh(mesh));
    painter.rect_stroke(
        bar,
        CornerRadius::ZERO,
        Stroke::new(1.0, LINE),
        StrokeKind::Outside,
    );
    scale(painter, bar, low, high, x);
}

fn scale(painter: &Painter, bar: Rect, low: f32, high: f32, x: impl Fn(f32) -> f32) {
    let step = round_step((high - low) / 6.0);
    let mut tick = (low / step).ceil() * step;
    while tick <= high + step * 1e-3 {
        let at = pos2(x(tick), bar.bottom());
        painter.line_segment([at, at + vec2(0.0, 4.0)], Stroke::new(1.0, FAINT));
        let label = text::number(f64::from(tick));
        painter.text(
            at + vec2(0.0, 5.0),
            Align2::CENTER_TOP,
            label,
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
