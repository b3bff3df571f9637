//! The ground under the cursor, as numbers.

use crate::explorer::text;
use crate::explorer::view::ShownView;
use crate::explorer::widgets::{hint, row};
use bevy::math::DVec3;
use bevy_egui::egui::Ui;
use bevy_pangaea::control::Bake;
use bevy_pangaea::hydrology::{Drainage, LakeKind, flow};
use bevy_pangaea::math::azimuth;
use bevy_pangaea::prelude::*;

/// Shallowest bend of subducting crust that is shown, in km.
const LEAST_BEND: f32 = 0.01;

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &ShownView, ground: Option<DVec3>) {
    let Some(direction) = ground else {
        hint(ui, "Move the pointer over the globe.");
        return;
    };
    let sample = view.surface.at(view.mesh, direction).sample as usize;
    crust(ui, view, direction);
    velocity(ui, view, sample, direction);
    let bend = view.surface.trench[sample];
    if bend < -LEAST_BEND {
        row(ui, "Trench bend", format!("{bend:.2} km"));
    }
    row(ui, "Sample", sample.to_string());
    if let Some(bake) = view.bake {
        weather(ui, bake, direction);
    }
}

fn crust(ui: &mut Ui, view: &ShownView, direction: DVec3) {
    let point = view.surface.at(view.mesh, direction);
    let i = point.sample as usize;
    let crust = &view.surface.crust;
    let continental = crust.is_continental(i);
    let kind = if continental {
        "continental"
    } else {
        "oceanic"
    };
    row(ui, "Place", text::place(direction));
    row(ui, "Elevation", format!("{:.2} km", point.elevation));
    row(ui, "Plate", view.surface.plate[i].0.to_string());
    row(ui, "Crust", kind);
    row(ui, "Thickness", format!("{:.1} km", point.thickness));
    if continental {
        orogeny(ui, crust, i, f64::from(point.orogeny_age), direction);
    } else {
        let ridge = heading(direction, crust.ridge[i].as_dvec3());
        row(ui, "Floor age", format!("{:.0} My", point.ocean_age));
        row(ui, "Ridge direction", ridge);
    }
}

fn orogeny(ui: &mut Ui, crust: &Crust, i: usize, age: f64, direction: DVec3) {
    let name = match crust.orogeny[i] {
        Orogeny::None => "none",
        Orogeny::Andean => "Andean",
        Orogeny::Himalayan => "Himalayan",
    };
    row(ui, "Orogeny", name);
    if crust.orogeny[i] != Orogeny::None {
        let fold = heading(direction, crust.fold[i].as_dvec3());
        row(ui, "Folded", format!("{age:.0} My ago"));
        row(ui, "Fold direction", fold);
    }
}

fn velocity(ui: &mut Ui, view: &ShownView, sample: usize, direction: DVec3) {
    let plate = view.surface.plate[sample];
    let velocity = view.plates.angular_velocity(plate).cross(direction);
    let speed = velocity.length() * view.planet.radius;
    let heading = heading(direction, velocity);
    row(ui, "Speed", format!("{speed:.1} km/My  {heading}"));
}

/// Climate and water at the nearest vertex of the base mesh.
fn weather(ui: &mut Ui, bake: &Bake, direction: DVec3) {
    let i = bake.mesh().nearest(direction) as usize;
    let climate = &bake.climate;
    let temperature = format!("{:.1} °C", climate.temperature[i]);
    row(ui, "Temperature", temperature);
    row(ui, "Rain", format!("{:.0} mm/y", climate.rain[i]));
    row(ui, "Wetness", format!("{:.2}", climate.wetness[i]));
    water(ui, &bake.drainage, i);
}

fn water(ui: &mut Ui, drainage: &Drainage, i: usize) {
    let order = drainage.strahler[i];
    if order > 0 {
        let discharge = flow::per_second(drainage.discharge[i]);
        row(ui, "River, order", order.to_string());
        row(ui, "Discharge", format!("{discharge:.0} m³/s"));
    }
    if let Some(kind) = drainage.lake_kind(i) {
        let end = match kind {
            LakeKind::Draining => "drains to the sea",
            LakeKind::Passing => "drains to a closed one",
            LakeKind::Closed => "without an outlet",
        };
        row(ui, "Lake", end);
    }
}

/// The heading of a tangent vector in degrees from north, or a dash where it is zero.
fn heading(at: DVec3, v: DVec3) -> String {
    if v.length_squared() < 1e-18 {
        "–".into()
    } else {
        format!("{:.0}°", azimuth(at, v).rem_euclid(360.0))
    }
}
