//! What the colours of an overlay mean.

use super::boundary::BoundaryKind;
use super::field::{self, LAPLACIAN_MAX, OCEAN_AGE_MAX, SLOPE_MAX, THICKNESS_MAX};
use super::palette::{self, Ramp, Rgba};
use super::{Overlay, OverlayInput, ground};

/// Title, unit and key of an overlay.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// What is shown.
    pub title: &'static str,
    /// Unit of the values, empty where there is none.
    pub unit: &'static str,
    /// Colours and their meaning.
    pub entries: LegendEntries,
}

/// The key of a legend.
#[derive(Clone, Debug, PartialEq)]
pub enum LegendEntries {
    /// A ramp of values in ascending order; two stops of one value are a step.
    Gradient {
        /// Values in the legend's unit, and their colours.
        stops: Vec<(f32, Rgba)>,
    },
    /// Classes, or marks on a scale that is not linear.
    Classes(Vec<(String, Rgba)>),
}

pub(super) fn legend(overlay: Overlay, input: &OverlayInput) -> Legend {
    let (unit, entries) = match overlay {
        Overlay::Elevation => ("km", gradient(palette::HYPSOMETRIC, 1.0)),
        Overlay::Plates => ("", plates()),
        Overlay::CrustType => (
            "",
            classes(&[
                ("oceanic", field::CRUST[0]),
                ("continental, land", field::CRUST[1]),
                ("continental, under water", field::CRUST[2]),
            ]),
        ),
        Overlay::OceanAge => ("My", gradient(palette::AGE, OCEAN_AGE_MAX)),
        Overlay::Thickness => ("km", gradient(palette::AMOUNT, THICKNESS_MAX)),
        Overlay::OrogenyType => (
            "",
            classes(&[
                ("Andean: above a subduction zone", field::OROGENY[0]),
                ("Himalayan: continental collision", field::OROGENY[1]),
                ("unfolded continent", field::NO_VALUE_LAND),
                ("unfolded ocean floor", field::NO_VALUE_OCEAN),
            ]),
        ),
        Overlay::OrogenyAge => ("My", gradient(palette::AGE, field::orogeny_age_max(input))),
        Overlay::FoldDirection | Overlay::RidgeDirection => ("° from north", axes()),
        Overlay::Velocity => (
            "km/My",
            gradient(palette::AMOUNT, input.params.max_speed as f32),
        ),
        Overlay::Slope => ("m/km", gradient(palette::STEEPNESS, SLOPE_MAX)),
        Overlay::Laplacian => ("m/km²", gradient(palette::DIVERGING, LAPLACIAN_MAX)),
        Overlay::VectorNoise => (
            "",
            classes(&[
                ("x of the warp", [230, 128, 128, 255]),
                ("y of the warp", [128, 230, 128, 255]),
                ("z of the warp", [128, 128, 230, 255]),
            ]),
        ),
        Overlay::Temperature => {
            let (low, high) = ground::TEMPERATURE;
            let stops = palette::TEMPERATURE.0;
            let stop =
                |&(x, color): &(f32, [u8; 3])| (low + x * (high - low), palette::opaque(color));
            (
                "°C",
                LegendEntries::Gradient {
                    stops: stops.iter().map(stop).collect(),
                },
            )
        }
        Overlay::Rain => ("mm/year", gradient(palette::RAIN, ground::RAIN_MAX)),
        Overlay::Wetness => ("", gradient(palette::RAIN, 1.0)),
        Overlay::Drainage => ("m³/s", discharges(input.planet.radius)),
        Overlay::Rivers => ("order", rivers()),
        Overlay::Basins => (
            "",
            classes(&[
                (
                    "one colour per mouth; reddish: never reaches the sea",
                    [150, 150, 150, 255],
                ),
                ("sea", ground::SEA),
            ]),
        ),
        Overlay::Lakes => ("", classes(&LAKES)),
        Overlay::Mesh => (
            "",
            classes(&[("one shade per sample", [150, 150, 150, 255])]),
        ),
    };
    Legend {
        title: overlay.label(),
        unit,
        entries,
    }
}

fn gradient(ramp: Ramp, scale: f32) -> LegendEntries {
    let stops = ramp
        .0
        .iter()
        .map(|&(x, color)| (x * scale, palette::opaque(color)))
        .collect();
    LegendEntries::Gradient { stops }
}

fn classes(entries: &[(&str, Rgba)]) -> LegendEntries {
    LegendEntries::Classes(
        entries
            .iter()
            .map(|&(name, color)| (name.to_string(), color))
            .collect(),
    )
}

fn plates() -> LegendEntries {
    let kinds = BoundaryKind::ALL.map(|kind| (format!("{} boundary", kind.label()), kind.color()));
    let mut entries = kinds.to_vec();
    let shade = |kind| field::plate_color(2, kind);
    entries.push((
        "ocean floor of a plate".into(),
        shade(crate::crust::CrustKind::Oceanic),
    ));
    entries.push((
        "continent of the plate".into(),
        shade(crate::crust::CrustKind::Continental),
    ));
    LegendEntries::Classes(entries)
}

/// Classes of lakes.
const LAKES: [(&str, Rgba); 4] = [
    ("lake that drains to the sea", ground::LAKE[0]),
    ("lake that drains to one without an outlet", ground::LAKE[1]),
    ("lake without an outlet", ground::LAKE[2]),
    ("sea", ground::SEA),
];

fn discharges(radius: f64) -> LegendEntries {
    let name = |power: i32| match power {
        0.. => format!("1{}", "0".repeat(power as usize)),
        _ => format!("0.{}1", "0".repeat((-power - 1) as usize)),
    };
    let decades = ground::discharge_decades(radius).map(|(power, color)| (name(power), color));
    LegendEntries::Classes(decades.chain([("sea".to_string(), ground::SEA)]).collect())
}

fn rivers() -> LegendEntries {
    let orders = (2..=7).map(|order| (format!("order {order}"), super::rivers::order_color(order)));
    let lakes = LAKES.iter().map(|&(name, color)| (name.to_string(), color));
    LegendEntries::Classes(orders.chain(lakes).collect())
}

fn axes() -> LegendEntries {
    let stop = |k: u8| {
        let degrees = 15.0 * f32::from(k);
        (degrees, palette::axis_hue(degrees.into()))
    };
    LegendEntries::Gradient {
        stops: (0..=12).map(stop).collect(),
    }
}
