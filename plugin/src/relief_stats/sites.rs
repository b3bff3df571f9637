//! Places on a planet by what built their relief, drawn by its seed.
//!
//! Only samples whose neighbours are of the same class are drawn: a tile about one of them lies in
//! the middle of its class. Where the planet has none of them, samples at the border do.

use super::{Relief, median, relief};
use crate::crust::Orogeny;
use crate::math;
use crate::query::{AzimuthalEquidistant, Ground, GroundError, Square};
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;

/// Sites drawn of each class.
pub const SITES: usize = 20;

/// Pixels to a side of the tile around a site.
pub const TILE_PIXELS: usize = 648;

/// Side of that tile in m: 60 km at 92.6 m, as the measured tiles of the Earth.
pub const TILE_M: f64 = 92.6 * TILE_PIXELS as f64;

/// What built the relief of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefClass {
    /// Collision of continents less than 30 My ago, above 1 km.
    YoungHimalayan,
    /// Subduction below a continent less than 30 My ago, above 1 km.
    YoungAndean,
    /// Either of them more than 150 My ago, above 200 m.
    OldBelts,
    /// Neither of them within 400 My, below 500 m.
    Plains,
}

/// All classes, in the order of reports.
pub const CLASSES: [ReliefClass; 4] = [
    ReliefClass::YoungHimalayan,
    ReliefClass::YoungAndean,
    ReliefClass::OldBelts,
    ReliefClass::Plains,
];

impl ReliefClass {
    /// Its name in reports: `young_himalayan`, `young_andean`, `old_belts`, `plains`.
    pub fn name(self) -> &'static str {
        match self {
            Self::YoungHimalayan => "young_himalayan",
            Self::YoungAndean => "young_andean",
            Self::OldBelts => "old_belts",
            Self::Plains => "plains",
        }
    }

    /// Does crust of this elevation in km, orogeny, and age of the orogeny in My belong to the
    /// class?
    pub fn holds(self, elevation: f32, orogeny: Orogeny, age: f32) -> bool {
        match self {
            Self::YoungHimalayan => orogeny == Orogeny::Himalayan && age < 30.0 && elevation > 1.0,
            Self::YoungAndean => orogeny == Orogeny::Andean && age < 30.0 && elevation > 1.0,
            Self::OldBelts => orogeny != Orogeny::None && age > 150.0 && elevation > 0.2,
            Self::Plains => {
                (orogeny == Orogeny::None || age > 400.0) && elevation > 0.0 && elevation < 0.5
            }
        }
    }
}

/// The planet as sites see it; columns have an entry per sample.
#[derive(Clone, Copy)]
pub struct SiteInput<'a> {
    /// Samples.
    pub mesh: &'a SphereMesh,
    /// Elevation in km.
    pub elevation: &'a [f32],
    /// Type of the last orogeny.
    pub orogeny: &'a [Orogeny],
    /// Time since it in My.
    pub orogeny_age: &'a [f32],
    /// Seed of the planet.
    pub seed: u64,
}

/// Up to [`SITES`] samples of a class, in the order in which they were drawn.
pub fn sites(input: &SiteInput, class: ReliefClass) -> Vec<u32> {
    let n = input
        .mesh
        .len()
        .min(input.elevation.len())
        .min(input.orogeny.len())
        .min(input.orogeny_age.len());
    let holds = |i: u32| {
        let i = i as usize;
        i < n && class.holds(input.elevation[i], input.orogeny[i], input.orogeny_age[i])
    };
    let all: Vec<u32> = (0..n as u32).filter(|&i| holds(i)).collect();
    let inner: Vec<u32> = all
        .iter()
        .copied()
        .filter(|&i| input.mesh.ring(i).iter().all(|&j| holds(j)))
        .collect();
    let mut candidates = if inner.is_empty() { all } else { inner };
    let stream = Stream::new(input.seed, Purpose::ReliefSites, class as u64);
    // The first steps of a shuffle: no sample is drawn twice.
    let count = SITES.min(candidates.len());
    for k in 0..count {
        let left = (candidates.len() - k) as u64;
        candidates.swap(k, k + (stream.bits(k as u64) % left) as usize);
    }
    candidates.truncate(count);
    candidates
}

/// The relief of the tile around each site, one after the other, each on all threads.
///
/// # Errors
/// As [`Ground::height`].
pub fn class_relief(
    ground: &(impl Ground + ?Sized),
    mesh: &SphereMesh,
    sites: &[u32],
    mut seen: impl FnMut(),
) -> Result<Vec<Relief>, GroundError> {
    let mut reliefs = Vec::with_capacity(sites.len());
    for &site in sites {
        let (lat, lon) = math::lat_lon(mesh.point(site));
        // A small planet has smaller tiles: half of what fits around it.
        let side = TILE_M.min(0.5 * AzimuthalEquidistant::largest_square(ground.radius_m()));
        let square = Square::new(
            AzimuthalEquidistant::new(lat, lon, ground.radius_m())?,
            side,
            TILE_PIXELS,
        )?;
        reliefs.extend(relief(&square.heights(ground, square.level())?));
        seen();
    }
    Ok(reliefs)
}

/// Medians over the sites of a class: relief in 10 km in m, 90th percentile of the slope in
/// degrees, spectral exponent. `None` where no site has the figure.
pub fn medians(reliefs: &[Relief]) -> [Option<f64>; 3] {
    let of = |figure: &(dyn Fn(&Relief) -> Option<f64> + Sync)| {
        median(reliefs.iter().filter_map(figure).collect())
    };
    [
        of(&|r| r.relief10_median_m),
        of(&|r| Some(r.slope_p90_deg)),
        of(&|r| r.spectral_exponent),
    ]
}
