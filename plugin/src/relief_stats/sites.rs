//! Places on a planet by the orogeny that built their relief, drawn by its seed.
//!
//! Only samples whose neighbours are of the same class are drawn: a tile about one of them lies in
//! the middle of its class. Where the planet has none of them, samples at the border do.

use super::quantile::median;
use super::tile::ReliefStats;
use crate::crust::Orogeny;
use crate::math;
use crate::named::named_enum;
use crate::query::{AzimuthalEquidistant, Ground, GroundError, MapSquare};
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;

/// Sites drawn of each class.
pub const SITES: usize = 20;

/// Pixels to a side of the tile around a site.
pub const TILE_PIXELS: usize = 648;

/// Side of that tile in m: 60 km at 92.6 m, as the measured tiles of the Earth.
pub const TILE_M: f64 = 92.6 * TILE_PIXELS as f64;

/// Age in My below which a belt is young: the Himalaya and the Andes rose within it.
const YOUNG_MY: f32 = 30.0;

/// Lowest elevation of young belts in km: it leaves out their forelands.
const YOUNG_BELT_KM: f32 = 1.0;

/// Age in My above which a belt is old: Appalachians and Scottish Highlands are.
const OLD_MY: f32 = 150.0;

/// Lowest elevation of old belts in km.
const OLD_BELT_KM: f32 = 0.2;

/// Age in My above which an orogeny no longer counts: no relief is left of it.
const FORGOTTEN_MY: f32 = 400.0;

/// Highest elevation of plains in km.
const PLAIN_KM: f32 = 0.5;

named_enum! {
    /// The orogeny that built the relief of a place.
    pub enum ReliefClass {
        /// Collision of continents less than 30 My ago, above 1 km.
        YoungHimalayan = "young_himalayan",
        /// Subduction below a continent less than 30 My ago, above 1 km.
        YoungAndean = "young_andean",
        /// Either of them more than 150 My ago, above 200 m.
        OldBelts = "old_belts",
        /// Neither of them within 400 My, below 500 m.
        Plains = "plains",
    }
}

impl ReliefClass {
    /// Whether crust of this elevation in km, orogeny, and age of the orogeny in My belongs to the
    /// class.
    pub fn holds(self, elevation: f32, orogeny: Orogeny, age: f32) -> bool {
        let is_young = age < YOUNG_MY && elevation > YOUNG_BELT_KM;
        match self {
            Self::YoungHimalayan => orogeny == Orogeny::Himalayan && is_young,
            Self::YoungAndean => orogeny == Orogeny::Andean && is_young,
            Self::OldBelts => orogeny != Orogeny::None && age > OLD_MY && elevation > OLD_BELT_KM,
            Self::Plains => {
                let is_unfolded = orogeny == Orogeny::None || age > FORGOTTEN_MY;
                is_unfolded && elevation > 0.0 && elevation < PLAIN_KM
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

impl SiteInput<'_> {
    /// Number of samples with an entry in every column.
    fn len(&self) -> usize {
        let columns = self.elevation.len().min(self.orogeny.len());
        self.mesh.len().min(columns).min(self.orogeny_age.len())
    }

    /// Whether a sample belongs to a class.
    fn holds(&self, class: ReliefClass, sample: u32) -> bool {
        let i = sample as usize;
        i < self.len() && class.holds(self.elevation[i], self.orogeny[i], self.orogeny_age[i])
    }
}

/// Up to [`SITES`] samples of a class, in the order in which they were drawn.
pub fn sites(input: &SiteInput, class: ReliefClass) -> Vec<u32> {
    let holds = |i: u32| input.holds(class, i);
    let is_inner = |i: u32| input.mesh.ring(i).iter().all(|&j| holds(j));
    let all: Vec<u32> = (0..input.len() as u32).filter(|&i| holds(i)).collect();
    let inner: Vec<u32> = all.iter().copied().filter(|&i| is_inner(i)).collect();
    // In the middle of its class, unless the planet has only borders of it.
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

/// The relief of the tile around each site, one after the other, each on all threads; `seen` is
/// called after each.
///
/// # Errors
/// As [`Ground::height`].
pub fn class_relief(
    ground: &(impl Ground + ?Sized),
    mesh: &SphereMesh,
    sites: &[u32],
    mut seen: impl FnMut(),
) -> Result<Vec<ReliefStats>, GroundError> {
    let mut reliefs = Vec::with_capacity(sites.len());
    for &site in sites {
        let (lat, lon) = math::lat_lon(mesh.point(site));
        let about = AzimuthalEquidistant::new(lat, lon, ground.radius_m())?;
        // A small planet has smaller tiles: half of what fits around it.
        let side = TILE_M.min(0.5 * AzimuthalEquidistant::largest_square(ground.radius_m()));
        let square = MapSquare::new(about, side, TILE_PIXELS)?;
        reliefs.extend(ReliefStats::of(&square.heights(ground, square.level())?));
        seen();
    }
    Ok(reliefs)
}

/// The median of a figure over the sites of a class; `None` where no site has it.
pub fn median_of(
    reliefs: &[ReliefStats],
    figure: impl Fn(&ReliefStats) -> Option<f64>,
) -> Option<f64> {
    median(reliefs.iter().filter_map(figure).collect())
}

/// Medians over the sites of a class: relief in 10 km in m, 90th percentile of the slope in
/// degrees, spectral exponent. `None` where no site has the figure.
pub fn medians(reliefs: &[ReliefStats]) -> [Option<f64>; 3] {
    [
        median_of(reliefs, |relief| relief.relief10_median_m),
        median_of(reliefs, |relief| Some(relief.slope_p90_deg)),
        median_of(reliefs, |relief| relief.spectral_exponent),
    ]
}

#[cfg(test)]
#[path = "sites_tests.rs"]
mod tests;
