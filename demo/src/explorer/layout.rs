//! Where the panels stand: sections on the left, the selection on the right, a bar at the bottom.

use super::HelpPage;
use super::camera::FreeArea;
use super::messages::Messages;
use super::panels::legend::LegendCache;
use super::panels::paint::PaintForm;
use super::panels::planet::PlanetForm;
use super::panels::plate::PlateForm;
use super::panels::timings::FrameTimes;
use super::panels::{self, Outbox};
use super::session::Session;
use super::state::{Action, Look, PlanetReader, Pointer, Selection, Tool, View};
use super::style::{self, section};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::egui::{
    Context, Frame, LayerId, Margin, Order, Panel, Rect, RichText, ScrollArea, Spinner, Ui,
    UiBuilder,
};
use bevy_egui::{EguiContexts, egui};

/// Widths of the panels, in points.
const LEFT: f32 = 272.0;
const RIGHT: f32 = 258.0;
/// Height of the bar.
const BAR: f32 = 27.0;

/// What the panels keep while it is being typed or chosen.
#[derive(SystemParam)]
pub struct Forms<'w> {
    look: ResMut<'w, Look>,
    tool: ResMut<'w, Tool>,
    planet: ResMut<'w, PlanetForm>,
    plate: ResMut<'w, PlateForm>,
    paint: ResMut<'w, PaintForm>,
    legend: ResMut<'w, LegendCache>,
    messages: ResMut<'w, Messages>,
    help: ResMut<'w, HelpPage>,
}

/// What the panels read.
#[derive(SystemParam)]
pub struct Readings<'w> {
    session: Res<'w, Session>,
    selection: Res<'w, Selection>,
    frames: Res<'w, FrameTimes>,
}

/// Draws all panels and finds out what area they leave free.
pub fn draw(
    mut contexts: EguiContexts,
    reader: PlanetReader,
    readings: Readings,
    mut forms: Forms,
    (mut area, mut pointer): (ResMut<FreeArea>, ResMut<Pointer>),
    mut styled: Local<bool>,
    mut actions: MessageWriter<Action>,
) -> Result {
    let ctx = contexts.ctx_mut()?.clone();
    if !core::mem::replace(&mut *styled, true) {
        style::apply(&ctx);
    }
    let view = reader.view();
    let mut out = Outbox::default();
    let root = UiBuilder::new()
        .layer_id(LayerId::background())
        .max_rect(ctx.viewport_rect());
    let mut root = Ui::new(ctx.clone(), "root".into(), root);
    let frame_ms = readings.frames.mean();
    let bar = Frame::new()
        .fill(style::RAISED)
        .inner_margin(Margin::symmetric(12, 3));
    Panel::bottom("bar")
        .exact_size(BAR)
        .resizable(false)
        .frame(bar)
        .show(&mut root, |ui| {
            panels::status::show(ui, view.as_ref(), &readings.session, &forms.tool, frame_ms);
        });
    side(Panel::left("left").exact_size(LEFT), &mut root, |ui| {
        left(ui, view.as_ref(), &readings, &mut forms, &mut out);
    });
    side(Panel::right("right").exact_size(RIGHT), &mut root, |ui| {
        right(
            ui,
            view.as_ref(),
            &readings,
            pointer.ground,
            &mut forms,
            &mut out,
        );
    });
    let free = root.available_rect_before_wrap();
    float(&ctx, free, view.as_ref(), &readings, &mut forms);
    area.set_if_neq(FreeArea(Some(free)));
    pointer.on_globe = is_on_globe(&ctx, free);
    actions.write_batch(out.0);
    Ok(())
}

fn side(panel: Panel, root: &mut Ui, body: impl FnOnce(&mut Ui)) {
    panel
        .resizable(false)
        .frame(style::panel_frame())
        .show(root, |ui| {
            ScrollArea::vertical()
                .auto_shrink([false, false])
                .show(ui, |ui| {
                    // Keeps the scroll bar clear of the widgets.
                    Frame::new()
                        .inner_margin(Margin {
                            right: 8,
                            ..Margin::ZERO
                        })
                        .show(ui, body);
                });
        });
}

fn left(
    ui: &mut Ui,
    view: Option<&View>,
    readings: &Readings,
    forms: &mut Forms,
    out: &mut Outbox,
) {
    if let Some(view) = view {
        section(ui, "Time", true, |ui| panels::time::show(ui, view, out));
    }
    section(ui, "View", true, |ui| {
        panels::overlays::show(ui, &mut forms.look)
    });
    section(ui, "Planet", false, |ui| {
        panels::planet::show(ui, view, &readings.session, &mut forms.planet, out);
    });
    if let Some(view) = view {
        section(ui, "Parameters", false, |ui| {
            panels::params::show(ui, view, out)
        });
        section(ui, "Timings", false, |ui| {
            panels::timings::show(ui, view, &readings.frames, out)
        });
    }
}

fn right(
    ui: &mut Ui,
    view: Option<&View>,
    readings: &Readings,
    ground: Option<bevy::math::DVec3>,
    forms: &mut Forms,
    out: &mut Outbox,
) {
    let Some(view) = view else { return };
    section(ui, "Plate", true, |ui| {
        let form = (&*readings.selection, &mut *forms.tool, &mut *forms.plate);
        panels::plate::show(ui, view, form, out);
    });
    section(ui, "Under the cursor", true, |ui| {
        panels::cursor::show(ui, view, ground)
    });
    section(ui, "Brush", false, |ui| {
        panels::paint::show(
            ui,
            view.planet.radius,
            &mut forms.tool,
            &mut forms.paint,
            out,
        );
    });
    section(ui, "Log", true, |ui| {
        panels::messages::show(ui, &mut forms.messages)
    });
}

/// What floats over the globe.
fn float(ctx: &Context, free: Rect, view: Option<&View>, readings: &Readings, forms: &mut Forms) {
    match view {
        Some(view) => panels::legend::show(ctx, free, view, &forms.look, &mut forms.legend),
        None => waiting(ctx, free, &readings.session),
    }
    panels::messages::strip(ctx, free, &forms.messages);
    let mut open = forms.help.0;
    panels::help::show(ctx, &mut open);
    forms.help.set_if_neq(HelpPage(open));
}

/// What is shown before there is a planet.
fn waiting(ctx: &Context, free: Rect, session: &Session) {
    egui::Area::new("waiting".into())
        .interactable(false)
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(free.center())
        .show(ctx, |ui| {
            ui.vertical_centered(|ui| match session.busy() {
                Some(what) => {
                    ui.add(Spinner::new().size(28.0).color(style::ACCENT));
                    ui.label(RichText::new(format!("{what} …")).color(style::TEXT));
                }
                None => {
                    ui.label(RichText::new("No planet. Grow one on the left.").color(style::FAINT));
                }
            });
        });
}

/// Whether the pointer is over the free area and nothing of egui is in the way.
fn is_on_globe(ctx: &Context, free: Rect) -> bool {
    let Some(at) = ctx.input(|input| input.pointer.latest_pos()) else {
        return false;
    };
    free.contains(at)
        && ctx
            .layer_id_at(at)
            .is_none_or(|layer| layer.order == Order::Background)
        && !ctx.egui_is_using_pointer()
        && !ctx.any_popup_open()
}
