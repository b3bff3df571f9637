//! Where the panels stand: sections on the left, the selection on the right, a bar at the bottom.

use super::camera::FreeArea;
use super::messages::MessageLog;
use super::panels::legend::LegendCache;
use super::panels::paint::PaintForm;
use super::panels::planet::PlanetForm;
use super::panels::plate::PlateForm;
use super::panels::timings::FrameTimes;
use super::panels::{self, Outbox};
use super::session::Session;
use super::state::{Action, HelpPage, Look, PlateDrag, Pointer, Selection, Tool};
use super::style;
use super::view::{PlanetReader, ShownView};
use super::widgets::section;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::EguiContexts;
use bevy_egui::egui::{
    Align2, Area, Context, Frame, LayerId, Margin, Order, Panel, Rect, RichText, ScrollArea,
    Spinner, Ui, UiBuilder,
};

/// Width of the left panel in points.
const LEFT_WIDTH: f32 = 272.0;
/// Width of the right panel in points.
const RIGHT_WIDTH: f32 = 258.0;
/// Height of the bar in points.
const BAR_HEIGHT: f32 = 27.0;

/// The state that the panels change.
#[derive(SystemParam)]
pub struct Forms<'w> {
    look: ResMut<'w, Look>,
    tool: ResMut<'w, Tool>,
    planet: ResMut<'w, PlanetForm>,
    plate: ResMut<'w, PlateForm>,
    paint: ResMut<'w, PaintForm>,
    legend: ResMut<'w, LegendCache>,
    messages: ResMut<'w, MessageLog>,
    help: ResMut<'w, HelpPage>,
}

/// The state that the panels read.
#[derive(SystemParam)]
pub struct Readings<'w> {
    session: Res<'w, Session>,
    selection: Res<'w, Selection>,
    drag: Res<'w, PlateDrag>,
    frames: Res<'w, FrameTimes>,
}

/// A frame of the panels.
struct Panels<'a, 'w> {
    view: Option<&'a ShownView<'a>>,
    readings: &'a Readings<'a>,
    forms: &'a mut Forms<'w>,
    pointer: &'a Pointer,
    out: Outbox,
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
    // Panels push their wishes into an outbox, and borrow nothing that carrying them out changes.
    let view = reader.view();
    let mut panels = Panels {
        view: view.as_ref(),
        readings: &readings,
        forms: &mut forms,
        pointer: &pointer,
        out: Outbox::default(),
    };
    let free = panels.draw(&ctx);
    actions.write_batch(panels.out.0);
    // Found after drawing: the camera and the pointer of the next frame use it.
    area.set_if_neq(FreeArea(Some(free)));
    pointer.on_globe = is_on_globe(&ctx, free);
    Ok(())
}

impl Panels<'_, '_> {
    /// Draws all panels. Returns the area that they leave free.
    fn draw(&mut self, ctx: &Context) -> Rect {
        let root = UiBuilder::new()
            .layer_id(LayerId::background())
            .max_rect(ctx.viewport_rect());
        let mut root = Ui::new(ctx.clone(), "root".into(), root);
        self.bar(&mut root);
        let left = Panel::left("left").exact_size(LEFT_WIDTH);
        side(left, &mut root, |ui| self.left(ui));
        let right = Panel::right("right").exact_size(RIGHT_WIDTH);
        side(right, &mut root, |ui| self.right(ui));
        let free = root.available_rect_before_wrap();
        self.float(ctx, free);
        free
    }

    fn bar(&self, root: &mut Ui) {
        let frame = Frame::new()
            .fill(style::RAISED)
            .inner_margin(Margin::symmetric(12, 3));
        Panel::bottom("bar")
            .exact_size(BAR_HEIGHT)
            .resizable(false)
            .frame(frame)
            .show(root, |ui| {
                let Readings {
                    session,
                    drag,
                    frames,
                    ..
                } = self.readings;
                let hint = panels::status::tool_hint(&self.forms.tool, drag);
                panels::status::show(ui, self.view, session, hint.as_deref(), frames.mean());
            });
    }

    fn left(&mut self, ui: &mut Ui) {
        let (forms, out) = (&mut *self.forms, &mut self.out);
        if let Some(view) = self.view {
            section(ui, "Time", true, |ui| panels::time::show(ui, view, out));
        }
        section(ui, "View", true, |ui| {
            panels::overlays::show(ui, &mut forms.look);
        });
        section(ui, "Planet", false, |ui| {
            let session = &self.readings.session;
            panels::planet::show(ui, self.view, session, &mut forms.planet, out);
        });
        let Some(view) = self.view else { return };
        section(ui, "Parameters", false, |ui| {
            panels::params::show(ui, view, out);
        });
        section(ui, "Timings", false, |ui| {
            panels::timings::show(ui, view, &self.readings.frames, out);
        });
    }

    fn right(&mut self, ui: &mut Ui) {
        let Some(view) = self.view else { return };
        let (forms, out) = (&mut *self.forms, &mut self.out);
        section(ui, "Plate", true, |ui| {
            let selected = self.readings.selection.0;
            let plate = selected.and_then(|id| view.plates.get(id));
            panels::plate::show(ui, view, plate, &mut forms.tool, &mut forms.plate, out);
        });
        section(ui, "Under the cursor", true, |ui| {
            panels::cursor::show(ui, view, self.pointer.ground);
        });
        section(ui, "Brush", false, |ui| {
            let radius = view.planet.radius;
            panels::paint::show(ui, radius, &mut forms.tool, &mut forms.paint, out);
        });
        section(ui, "Log", true, |ui| {
            panels::messages::show(ui, &mut forms.messages);
        });
    }

    /// Draws the things that float over the globe.
    fn float(&mut self, ctx: &Context, free: Rect) {
        let forms = &mut *self.forms;
        match self.view {
            Some(view) => {
                panels::legend::show(ctx, free, view, &forms.look, &mut forms.legend);
                panels::drag::show(ctx, free, view, &self.readings.drag, self.pointer);
            }
            None => waiting(ctx, free, &self.readings.session),
        }
        panels::messages::strip(ctx, free, &forms.messages);
        let mut open = forms.help.0;
        panels::help::show(ctx, &mut open);
        forms.help.set_if_neq(HelpPage(open));
    }
}

fn side(panel: Panel, root: &mut Ui, body: impl FnOnce(&mut Ui)) {
    // Keeps the scroll bar clear of the widgets.
    let inner = Frame::new().inner_margin(Margin {
        right: 8,
        ..Margin::ZERO
    });
    panel
        .resizable(false)
        .frame(style::panel_frame())
        .show(root, |ui| {
            ScrollArea::vertical()
                .auto_shrink([false, false])
                .show(ui, |ui| inner.show(ui, body));
        });
}

/// Says, before there is a planet, what is under way.
fn waiting(ctx: &Context, free: Rect, session: &Session) {
    Area::new("waiting".into())
        .interactable(false)
        .pivot(Align2::CENTER_CENTER)
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
    let layer = ctx.layer_id_at(at);
    free.contains(at)
        && layer.is_none_or(|layer| layer.order == Order::Background)
        && !ctx.egui_is_using_pointer()
        && !ctx.any_popup_open()
}
