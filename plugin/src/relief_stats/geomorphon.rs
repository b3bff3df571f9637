//! The ten commonest geomorphons: forms of the land by what is seen from a cell in eight directions
//! (Jasiewicz and Stepinski 2013, "Geomorphons: a pattern recognition approach to classification
//! and mapping of landforms", Geomorphology 182).
//!
//! ```text
//! β   highest elevation angle of the line of sight to a cell of the profile, 90° - zenith angle
//! δ   lowest one, nadir angle - 90°
//! β + δ > t: higher · β + δ < -t: lower · else level
//! ```
//!
//! How many of the eight profiles are higher and how many are lower makes the form. Profiles reach
//! 20 cells of 92.6 m (14 along diagonals, as far in m), and t is 1°. Cells nearer than 20 to an
//! edge of the tile have no form.

use super::cells::on_cells;
use super::neighbours::{CellStep, NEIGHBOURS};
use crate::math;
use crate::named::named_enum;
use crate::query::HeightGrid;
use bevy::reflect::Reflect;
use rayon::prelude::*;
use serde::ser::{Serialize, Serializer};

/// Search radius in cells.
const RADIUS: usize = 20;

/// Flatness threshold t in degrees.
const FLATNESS_DEG: f64 = 1.0;

named_enum! {
    /// A form of the land, of the ten commonest.
    pub enum Geomorphon {
        /// Level all around.
        Flat = "flat",
        /// Lower all around: a summit.
        Peak = "peak",
        /// Lower but along its crest.
        Ridge = "ridge",
        /// Level above, lower below.
        Shoulder = "shoulder",
        /// A slope bent outwards.
        Spur = "spur",
        /// Higher above, lower below.
        Slope = "slope",
        /// A slope bent inwards.
        Hollow = "hollow",
        /// Higher above, level below.
        Footslope = "footslope",
        /// Higher but along its floor.
        Valley = "valley",
        /// Higher all around.
        Depression = "depression",
    }
}

/// The forms by the number of lower profiles (rows) and of higher ones (columns): figure 4 of the
/// paper.
const FORMS: [&[Geomorphon]; 9] = {
    use Geomorphon::{
        Depression as D, Flat as F, Footslope as T, Hollow as H, Peak as P, Ridge as R,
        Shoulder as O, Slope as S, Spur as U, Valley as V,
    };
    [
        &[F, F, F, T, T, V, V, V, D],
        &[F, F, T, T, T, V, V, V],
        &[F, O, S, S, H, H, V],
        &[O, O, S, S, S, H],
        &[O, O, U, S, S],
        &[R, R, U, U],
        &[R, R, R],
        &[R, R],
        &[P],
    ]
};

impl Geomorphon {
    /// The form of a cell with so many lower and so many higher profiles; `None` of more than eight
    /// together.
    ///
    /// ```
    /// use bevy_pangaea::relief_stats::Geomorphon;
    ///
    /// assert_eq!(Geomorphon::of_profiles(8, 0), Some(Geomorphon::Peak));
    /// assert_eq!(Geomorphon::of_profiles(3, 3), Some(Geomorphon::Slope));
    /// assert_eq!(Geomorphon::of_profiles(5, 4), None);
    /// ```
    pub fn of_profiles(lower: usize, higher: usize) -> Option<Self> {
        FORMS.get(lower)?.get(higher).copied()
    }
}

/// Shares of the ten forms in a tile; their sum is 1.
///
/// ```
/// use bevy_pangaea::query::HeightGrid;
/// use bevy_pangaea::relief_stats::{Geomorphon, GeomorphonShares};
///
/// let tile = HeightGrid { width: 50, height: 50, values: vec![7.0; 2500], pixel_m: [92.6; 2] };
/// let shares = GeomorphonShares::of(&tile).ok_or("too small")?;
/// assert_eq!(shares.share(Geomorphon::Flat), 1.0);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct GeomorphonShares([f64; Geomorphon::COUNT]);

impl GeomorphonShares {
    /// The shares of a tile; `None` of one that is broken, coarser than 97 m or smaller than
    /// 41 x 41 cells.
    pub fn of(tile: &HeightGrid) -> Option<Self> {
        let cells = on_cells(tile, 2 * RADIUS + 1)?;
        let rows: Vec<[u32; Geomorphon::COUNT]> = (RADIUS..cells.height - RADIUS)
            .into_par_iter()
            .map(|y| count_row(&cells, y))
            .collect();
        let all = (cells.width - 2 * RADIUS) * rows.len();
        Some(Self(core::array::from_fn(|form| {
            let count: u32 = rows.iter().map(|row| row[form]).sum();
            f64::from(count) / all as f64
        })))
    }

    /// The mean of the shares of several tiles; `None` of no tiles.
    pub fn mean(tiles: &[Self]) -> Option<Self> {
        let count = tiles.len() as f64;
        (!tiles.is_empty()).then(|| {
            Self(core::array::from_fn(|form| {
                tiles.iter().map(|tile| tile.0[form]).sum::<f64>() / count
            }))
        })
    }

    /// The share of a form, 0 to 1.
    pub fn share(&self, form: Geomorphon) -> f64 {
        self.0[form as usize]
    }

    /// How far two tiles differ: the Jensen-Shannon distance of their shares, to base 2.
    ///
    /// It is the square root of the divergence, D = H((P + Q) / 2) - (H(P) + H(Q)) / 2 with
    /// Shannon's entropy H in bits (Lin 1991; Endres and Schindelin 2003): 0 of equal shares, 1 of
    /// tiles that share no form.
    pub fn distance(&self, other: &Self) -> f64 {
        let pairs = self.0.iter().zip(&other.0);
        let divergence: f64 = pairs.map(|(&p, &q)| divergence_term(p, q)).sum();
        divergence.max(0.0).sqrt()
    }
}

impl Serialize for GeomorphonShares {
    /// A map from the names of the forms to their shares.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Geomorphon::ALL.map(|form| (form.name(), self.share(form))))
    }
}

/// The part of one form with shares `p` and `q` in the divergence.
fn divergence_term(p: f64, q: f64) -> f64 {
    let middle = 0.5 * (p + q);
    0.5 * (relative_bits(p, middle) + relative_bits(q, middle))
}

/// p log₂(p / q); 0 of p = 0.
fn relative_bits(p: f64, q: f64) -> f64 {
    if p > 0.0 {
        p * math::ln(p / q) / core::f64::consts::LN_2
    } else {
        0.0
    }
}

/// How many cells of a row have each form.
fn count_row(cells: &HeightGrid, y: usize) -> [u32; Geomorphon::COUNT] {
    let mut lower = vec![0; cells.width - 2 * RADIUS];
    let mut higher = lower.clone();
    let (sin_t, cos_t) = math::sin_cos(FLATNESS_DEG.to_radians());
    let tan_t = (sin_t / cos_t) as f32;
    for &step in &NEIGHBOURS {
        let angles = SightAngles::along(cells, y, step);
        for (x, (&steepest_up, &steepest_down)) in angles.up.iter().zip(&angles.down).enumerate() {
            higher[x] += usize::from(exceeds(steepest_up, steepest_down, tan_t));
            lower[x] += usize::from(exceeds(-steepest_down, -steepest_up, tan_t));
        }
    }
    let mut counts = [0; Geomorphon::COUNT];
    for (lower, higher) in lower.into_iter().zip(higher) {
        if let Some(form) = Geomorphon::of_profiles(lower, higher) {
            counts[form as usize] += 1;
        }
    }
    counts
}

/// Extreme lines of sight from the cells of a row in one direction.
struct SightAngles {
    /// Tangents of the highest elevation angles.
    up: Vec<f32>,
    /// Tangents of the lowest ones.
    down: Vec<f32>,
}

impl SightAngles {
    fn along(cells: &HeightGrid, y: usize, step: CellStep) -> Self {
        let here = &cells.row(y)[RADIUS..cells.width - RADIUS];
        let mut found = Self {
            up: vec![f32::NEG_INFINITY; here.len()],
            down: vec![f32::INFINITY; here.len()],
        };
        let length = step.length_m(cells.pixel_m);
        for k in 1..=steps(step) {
            let far = k as isize;
            let row = cells.row((y as isize + far * step.south) as usize);
            let there = &row[(RADIUS as isize + far * step.east) as usize..][..here.len()];
            found.look(here, there, 1.0 / (k as f32 * length));
        }
        found
    }

    /// Looks from some cells at others; `per_m` is 1 by the distance.
    fn look(&mut self, here: &[f32], there: &[f32], per_m: f32) {
        let extremes = self.up.iter_mut().zip(&mut self.down);
        for ((up, down), (here, there)) in extremes.zip(here.iter().zip(there)) {
            let tangent = (there - here) * per_m;
            *up = up.max(tangent);
            *down = down.min(tangent);
        }
    }
}

/// Steps in a direction that stay within the search radius.
fn steps(step: CellStep) -> usize {
    let squared = step.east * step.east + step.south * step.south;
    RADIUS.pow(2).div_euclid(squared as usize).isqrt()
}

/// Whether the sum of two elevation angles exceeds the threshold, by their tangents:
/// tan(β + δ) = (tan β + tan δ) / (1 - tan β tan δ).
fn exceeds(up: f32, down: f32, tan_t: f32) -> bool {
    let remainder = 1.0 - up * down;
    if remainder > 0.0 {
        up + down > tan_t * remainder
    } else {
        // Together they are steeper than 90° up, or than 90° down.
        up > 0.0
    }
}

#[cfg(test)]
#[path = "geomorphon_tests.rs"]
mod tests;
