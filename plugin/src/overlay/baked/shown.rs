//! The quantity that an overlay of a bake shows at every vertex of the base mesh, and how it becomes
//! a colour between them.
//!
//! Logarithms and hues are found once a vertex: a map has ten times as many pixels.

use super::BasePlace;
use crate::control::Bake;
use crate::hydrology::NO_VERTEX;
use crate::overlay::Overlay;
use crate::overlay::discharge::discharge_position;
use crate::overlay::palette::{self, Ramp, Rgba, classes};
use crate::parallel;
use crate::random::mix;

/// Temperature in °C at the start of the ramp.
pub(in crate::overlay) const TEMPERATURE_MIN: f32 = -40.0;
/// Temperature in °C at the end of the ramp.
pub(in crate::overlay) const TEMPERATURE_MAX: f32 = 35.0;
/// Rain at the end of the ramp in mm per year.
pub(in crate::overlay) const RAIN_MAX: f32 = 4000.0;

/// The quantity that an overlay shows, rivers apart.
pub(super) enum Shown<'a> {
    /// Numbers on a ramp from `low` to `high`, on land and sea.
    Scalar {
        values: &'a [f32],
        ramp: Ramp,
        low: f32,
        high: f32,
    },
    /// Positions of the discharge on its ramp; the sea is plain. Between a river and its banks
    /// discharge differs by powers of ten, so positions are averaged, not m³/s.
    Discharge(Vec<f64>),
    /// The colour of the nearest vertex where that has one, on land alone; else that of land or
    /// sea.
    Basins(Vec<Option<Rgba>>),
    /// As [`Shown::Basins`], on land and sea.
    Lakes(Vec<Option<Rgba>>),
    /// No overlay of a bake.
    Nothing,
}

impl<'a> Shown<'a> {
    /// The quantity of `bake` that `overlay` shows.
    pub(super) fn new(overlay: Overlay, bake: &'a Bake) -> Self {
        let (climate, vertices) = (&bake.climate, bake.mesh().len());
        match overlay {
            Overlay::Temperature => Self::Scalar {
                values: &climate.temperature,
                ramp: palette::TEMPERATURE,
                low: TEMPERATURE_MIN,
                high: TEMPERATURE_MAX,
            },
            Overlay::Rain => Self::rain(&climate.rain, RAIN_MAX),
            Overlay::Wetness => Self::rain(&climate.wetness, 1.0),
            Overlay::Drainage => Self::Discharge(parallel::map(vertices, |i| {
                discharge_position(bake.drainage.earth_like_discharge(i as usize))
            })),
            Overlay::Basins => {
                Self::Basins(parallel::map(vertices, |i| basin_color(bake, i as usize)))
            }
            Overlay::Rivers | Overlay::Lakes => {
                Self::Lakes(parallel::map(vertices, |i| lake_color(bake, i as usize)))
            }
            _ => Self::Nothing,
        }
    }

    /// Values from 0 to `high` on the ramp of rain.
    fn rain(values: &'a [f32], high: f32) -> Self {
        Self::Scalar {
            values,
            ramp: palette::RAIN,
            low: 0.0,
            high,
        }
    }

    /// The colour at a place.
    pub(super) fn at(&self, place: &BasePlace) -> Rgba {
        let at = &place.at;
        match self {
            Self::Scalar {
                values,
                ramp,
                low,
                high,
            } => {
                let value = at.interpolate(|i| f64::from(values[i as usize]));
                ramp.within(value as f32, *low, *high)
            }
            Self::Discharge(_) if place.is_sea => classes::SEA,
            Self::Discharge(positions) => {
                let position = at.interpolate(|i| positions[i as usize]);
                palette::DISCHARGE.at(position as f32)
            }
            Self::Basins(_) if place.is_sea => classes::SEA,
            Self::Basins(colors) | Self::Lakes(colors) => {
                colors[at.nearest as usize].unwrap_or_else(|| backdrop(place))
            }
            Self::Nothing => classes::NO_VALUE_LAND,
        }
    }
}

/// The colour of land or sea.
fn backdrop(place: &BasePlace) -> Rgba {
    if place.is_sea {
        classes::SEA
    } else {
        classes::LAND
    }
}

/// The colour of the basin of a vertex, drawn by the number of its mouth; darker where its water
/// does not reach the sea.
fn basin_color(bake: &Bake, i: usize) -> Option<Rgba> {
    let basin = bake.drainage.basin[i];
    if basin == NO_VERTEX {
        return None;
    }
    let color = palette::distinct(mix(u64::from(basin)) as u32);
    Some(if bake.drainage.is_endorheic(i) {
        palette::mix(color, classes::ENDORHEIC, 0.6)
    } else {
        color
    })
}

fn lake_color(bake: &Bake, i: usize) -> Option<Rgba> {
    let kind = bake.drainage.lake_kind(i)?;
    Some(classes::LAKES[kind as usize])
}
