//! The meaning of the colours of an overlay.

use super::boundary::BoundaryKind;
use super::discharge::discharge_decades;
use super::palette::{self, Ramp, Rgba, classes as colors};
use super::quantity::{self, LAPLACIAN_MAX, OCEAN_AGE_MAX, SLOPE_MAX, THICKNESS_MAX};
use super::{Overlay, OverlayInput, baked, rivers};
use crate::crust::CrustKind;
use bevy::prelude::*;

/// Title, unit and key of an overlay.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct Legend {
    /// Name of the quantity.
    pub title: &'static str,
    /// Unit of the values; empty for quantities without a unit.
    pub unit: &'static str,
    /// Colours and their meaning.
    pub entries: LegendEntries,
}

/// The key of a legend.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub enum LegendEntries {
    /// A ramp of values in ascending order; two stops of one value are a step.
    Gradient {
        /// Values in the legend's unit, and their colours.
        stops: Vec<(f32, Rgba)>,
    },
    /// Classes, or marks on a scale that is not linear.
    Classes(Vec<(String, Rgba)>),
}

/// Names and colours of classes.
type ClassTable = [(&'static str, Rgba)];

/// Kinds of crust.
const CRUST_TYPES: &ClassTable = &[
    ("oceanic", colors::OCEANIC_CRUST),
    ("continental, land", colors::CONTINENT),
    ("continental, under water", colors::SHELF),
];

/// Kinds of mountain building.
const OROGENIES: &ClassTable = &[
    ("Andean: above a subduction zone", colors::ANDEAN),
    ("Himalayan: continental collision", colors::HIMALAYAN),
    ("unfolded continent", colors::NO_VALUE_LAND),
    ("unfolded ocean floor", colors::NO_VALUE_OCEAN),
];

/// The channels of the border noise.
const NOISE_AXES: &ClassTable = &[
    ("x of the warp", [230, 128, 128, 255]),
    ("y of the warp", [128, 230, 128, 255]),
    ("z of the warp", [128, 128, 230, 255]),
];

/// Classes behind the basins, whose own colours are too many to list.
const BASINS: &ClassTable = &[
    (
        "one colour per mouth; reddish: never reaches the sea",
        colors::GREY,
    ),
    ("sea", colors::SEA),
];

/// Kinds of lakes, and the land and sea behind them.
const LAKES: &ClassTable = &[
    ("lake that drains to the sea", colors::LAKES[0]),
    (
        "lake that drains to one without an outlet",
        colors::LAKES[1],
    ),
    ("lake without an outlet", colors::LAKES[2]),
    ("sea", colors::SEA),
];

/// The one entry of the mesh, whose shades tell samples apart.
const SAMPLES: &ClassTable = &[("one shade per sample", colors::GREY)];

impl Overlay {
    /// Title, unit and key of the overlay on the planet as it is now.
    pub fn legend(self, input: &OverlayInput) -> Legend {
        Legend {
            title: self.label(),
            unit: unit(self),
            entries: entries(self, input),
        }
    }
}

fn unit(overlay: Overlay) -> &'static str {
    match overlay {
        Overlay::Elevation | Overlay::Thickness => "km",
        Overlay::OceanAge | Overlay::OrogenyAge => "My",
        Overlay::FoldDirection | Overlay::RidgeDirection => "° from north",
        Overlay::Velocity => "km/My",
        Overlay::Slope => "m/km",
        Overlay::Laplacian => "m/km²",
        Overlay::Temperature => "°C",
        Overlay::Rain => "mm/year",
        Overlay::Drainage => "m³/s",
        Overlay::Rivers => "order",
        _ => "",
    }
}

fn entries(overlay: Overlay, input: &OverlayInput) -> LegendEntries {
    match overlay {
        Overlay::Elevation => gradient(palette::HYPSOMETRIC, 1.0),
        Overlay::Plates => plates(),
        Overlay::CrustType => classes(CRUST_TYPES),
        Overlay::OceanAge => gradient(palette::AGE, OCEAN_AGE_MAX),
        Overlay::Thickness => gradient(palette::AMOUNT, THICKNESS_MAX),
        Overlay::OrogenyType => classes(OROGENIES),
        Overlay::OrogenyAge => gradient(palette::AGE, quantity::orogeny_age_max(input)),
        Overlay::FoldDirection | Overlay::RidgeDirection => axes(),
        Overlay::Velocity => gradient(palette::AMOUNT, input.params.max_speed as f32),
        Overlay::Slope => gradient(palette::STEEPNESS, SLOPE_MAX),
        Overlay::Laplacian => gradient(palette::DIVERGING, LAPLACIAN_MAX),
        Overlay::VectorNoise => classes(NOISE_AXES),
        Overlay::Mesh => classes(SAMPLES),
        Overlay::Temperature => temperature(),
        Overlay::Rain => gradient(palette::RAIN, baked::RAIN_MAX),
        Overlay::Wetness => gradient(palette::RAIN, 1.0),
        Overlay::Drainage => discharges(input.planet.radius),
        Overlay::Rivers => orders(),
        Overlay::Basins => classes(BASINS),
        Overlay::Lakes => classes(LAKES),
    }
}

/// A ramp whose position 1 stands for `scale`.
fn gradient(ramp: Ramp, scale: f32) -> LegendEntries {
    let stops = ramp.0.iter();
    LegendEntries::Gradient {
        stops: stops
            .map(|&(x, color)| (x * scale, palette::opaque(color)))
            .collect(),
    }
}

fn classes(table: &ClassTable) -> LegendEntries {
    LegendEntries::Classes(named(table).collect())
}

fn named(table: &ClassTable) -> impl Iterator<Item = (String, Rgba)> {
    table.iter().map(|&(name, color)| (name.to_string(), color))
}

/// Kinds of boundaries, and the two shades of one plate for all.
fn plates() -> LegendEntries {
    // Plates are too many to list: one of them stands for all.
    let kinds = BoundaryKind::DRAWN;
    let kinds = kinds.map(|kind| (format!("{} boundary", kind.name()), kind.color()));
    let shades = [
        ("ocean floor of a plate", CrustKind::Oceanic),
        ("continent of the plate", CrustKind::Continental),
    ]
    .map(|(name, kind)| (name.to_string(), quantity::plate_color(2, kind)));
    LegendEntries::Classes(kinds.into_iter().chain(shades).collect())
}

fn temperature() -> LegendEntries {
    let (low, high) = (baked::TEMPERATURE_MIN, baked::TEMPERATURE_MAX);
    let stops = palette::TEMPERATURE.0.iter();
    LegendEntries::Gradient {
        stops: stops
            .map(|&(x, color)| (low + x * (high - low), palette::opaque(color)))
            .collect(),
    }
}

/// Powers of ten.
fn discharges(radius: f64) -> LegendEntries {
    let decades = discharge_decades(radius).map(|(power, color)| (power_of_ten(power), color));
    let sea = ("sea".to_string(), colors::SEA);
    LegendEntries::Classes(decades.chain([sea]).collect())
}

/// 10 to the `power` in digits.
fn power_of_ten(power: i32) -> String {
    match power {
        0.. => format!("1{}", "0".repeat(power as usize)),
        _ => format!("0.{}1", "0".repeat((-power - 1) as usize)),
    }
}

/// Orders of rivers, and lakes.
fn orders() -> LegendEntries {
    let orders = (2..=7).map(|order| (format!("order {order}"), rivers::order_color(order)));
    LegendEntries::Classes(orders.chain(named(LAKES)).collect())
}

/// Azimuths of half a turn, every 15 degrees.
fn axes() -> LegendEntries {
    let stops = (0..=12_u8).map(|k| {
        let degrees = 15.0 * f32::from(k);
        (degrees, palette::axis_hue(degrees.into()))
    });
    LegendEntries::Gradient {
        stops: stops.collect(),
    }
}
