//! What lies under the cursor, as numbers.

use crate::explorer::state::View;
use crate::explorer::style::{hint, row};
use crate::explorer::text;
use bevy::math::DVec3;
use bevy_egui::egui::Ui;
use bevy_pangaea::control::Bake;
use bevy_pangaea::hydrology::LakeKind;
use bevy_pangaea::math::azimuth;
use bevy_pangaea::prelude::*;

/// Draws the panel.
pub fn show(ui: &mut Ui, view: &View, ground: Option<DVec3>) {
    let Some(direction) = ground else {
        hint(ui, "Move the pointer over the globe.");
        return;
    };
    let point = view.surface.at(view.mesh, direction);
    let i = point.sample as usize;
    let (surface, crust) = (view.surface, &view.surface.crust);
    let plate = surface.plate[i];
    row(ui, "Place", text::place(direction));
    row(ui, "Elevation", format!("{:.2} km", point.elevation));
    row(ui, "Plate", plate.0.to_string());
    row(
        ui,
        "Crust",
        if crust.is_continental(i) {
            "continental"
        } else {
            "oceanic"
        },
    );
    row(ui, "Thickness", format!("{:.1} km", point.thickness));
    if crust.is_continental(i) {
        match crust.orogeny[i] {
            Orogeny::None => row(ui, "Orogeny", "none"),
            Orogeny::Andean => row(ui, "Orogeny", "Andean"),
            Orogeny::Himalayan => row(ui, "Orogeny", "Himalayan"),
        };
        if crust.orogeny[i] != Orogeny::None {
            row(ui, "Folded", format!("{:.0} My ago", point.orogeny_age));
            row(
                ui,
                "Fold direction",
                heading(direction, crust.fold[i].as_dvec3()),
            );
        }
    } else {
        row(ui, "Floor age", format!("{:.0} My", point.ocean_age));
        row(
            ui,
            "Ridge direction",
            heading(direction, crust.ridge[i].as_dvec3()),
        );
    }
    let velocity = view.plates.angular_velocity(plate).cross(direction);
    let speed = velocity.length() * view.planet.radius;
    row(
        ui,
        "Speed",
        format!("{speed:.1} km/My  {}", heading(direction, velocity)),
    );
    if surface.trench[i] < -0.01 {
        row(ui, "Trench bend", format!("{:.2} km", surface.trench[i]));
    }
    row(ui, "Sample", i.to_string());
    if let Some(bake) = view.bake {
        weather(ui, bake, direction);
    }
}

/// Climate and water at the nearest vertex of the base mesh.
fn weather(ui: &mut Ui, bake: &Bake, direction: DVec3) {
    let i = bake.mesh().nearest(direction) as usize;
    let (climate, drainage) = (&bake.climate, &bake.drainage);
    row(
        ui,
        "Temperature",
        format!("{:.1} °C", climate.temperature[i]),
    );
    row(ui, "Rain", format!("{:.0} mm/y", climate.rain[i]));
    row(ui, "Wetness", format!("{:.2}", climate.wetness[i]));
    if drainage.strahler[i] > 0 {
        row(ui, "River, order", drainage.strahler[i].to_string());
        row(
            ui,
            "Discharge",
            format!("{:.0} m³/s", drainage.discharge_m3s(i)),
        );
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

/// The heading of a tangent vector in degrees from north, or a dash where there is none.
fn heading(at: DVec3, v: DVec3) -> String {
    if v.length_squared() < 1e-18 {
        "–".into()
    } else {
        format!("{:.0}°", degrees(azimuth(at, v)))
    }
}

fn degrees(azimuth: f64) -> f64 {
    azimuth.rem_euclid(360.0)
}
