//! Relief figures of a class of sites, or of one tile of real ground, and their JSON.

use bevy_pangaea::relief_stats::{GeomorphonShares, ReliefStats, median_of, medians};
use serde_json::{Map, Value, json};

/// Relief figures of a class of sites, or of one tile of real ground.
#[derive(Default)]
pub(super) struct ReliefFigures {
    pub name: String,
    pub sites: usize,
    pub relief10_median_m: Option<f64>,
    pub slope_p90_deg: Option<f64>,
    pub spectral_exponent: Option<f64>,
    pub coherence_median: Option<f64>,
    pub coherence_p90: Option<f64>,
    pub slope_area_exponent: Option<f64>,
    pub pits_percent: Option<f64>,
    pub geomorphons: Option<GeomorphonShares>,
    pub nearest: Option<NearestTile>,
}

/// The tile whose geomorphons are most alike.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NearestTile {
    pub name: String,
    /// Jensen-Shannon distance of the shares.
    pub distance: f64,
}

impl ReliefFigures {
    /// Medians over the sites, and the mean of their shares of geomorphons.
    pub(super) fn new(name: String, reliefs: &[ReliefStats]) -> Self {
        let [relief10_median_m, slope_p90_deg, spectral_exponent] = medians(reliefs);
        let shares: Vec<_> = reliefs.iter().filter_map(|r| r.geomorphons).collect();
        Self {
            name,
            sites: reliefs.len(),
            relief10_median_m,
            slope_p90_deg,
            spectral_exponent,
            coherence_median: median_of(reliefs, |r| Some(r.coherence?.median)),
            coherence_p90: median_of(reliefs, |r| Some(r.coherence?.p90)),
            slope_area_exponent: median_of(reliefs, |r| r.slope_area_exponent),
            pits_percent: median_of(reliefs, |r| r.pits_percent),
            geomorphons: GeomorphonShares::mean(&shares),
            nearest: None,
        }
    }

    /// The tile nearest to it, other than tile `own`.
    fn nearest_of(&self, tiles: &[Self], own: Option<usize>) -> Option<NearestTile> {
        let shares = self.geomorphons?;
        let others = tiles.iter().enumerate().filter(|(i, _)| Some(*i) != own);
        let distances = others.filter_map(|(_, tile)| {
            Some(NearestTile {
                name: tile.name.clone(),
                distance: shares.distance(&tile.geomorphons?),
            })
        });
        distances.min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// Its numbers, or null.
    fn json(&self) -> Value {
        json!({
            "sites": self.sites,
            "relief10_median_m": self.relief10_median_m,
            "slope_p90_deg": self.slope_p90_deg,
            "spectral_exponent": self.spectral_exponent,
            "coherence_median": self.coherence_median,
            "coherence_p90": self.coherence_p90,
            "slope_area_exponent": self.slope_area_exponent,
            "pits_percent": self.pits_percent,
            "geomorphon_distance": self.nearest.as_ref().map(|nearest| nearest.distance),
        })
    }
}

/// Finds the tile nearest to every class, and to every tile among the others.
pub(super) fn compare(classes: &mut [ReliefFigures], tiles: &mut [ReliefFigures]) {
    for class in classes {
        class.nearest = class.nearest_of(tiles, None);
    }
    for i in 0..tiles.len() {
        tiles[i].nearest = tiles[i].nearest_of(tiles, Some(i));
    }
}

/// The figures of classes by their names, and those of tiles by theirs under `tiles`; the shares of
/// geomorphons and the nearest tiles of both under `geomorphons` and `nearest_tile`.
pub(super) fn all_figures(classes: &[ReliefFigures], tiles: &[ReliefFigures]) -> Value {
    let both = || classes.iter().chain(tiles);
    let nearest = |figures: &ReliefFigures| json!(figures.nearest.as_ref().map(|tile| &tile.name));
    let mut all = by_name(classes, ReliefFigures::json);
    let parts = [
        ("tiles", by_name(tiles, ReliefFigures::json)),
        ("geomorphons", by_name(both(), |of| json!(of.geomorphons))),
        ("nearest_tile", by_name(both(), nearest)),
    ];
    all.extend(parts.map(|(name, part)| (name.to_string(), Value::Object(part))));
    Value::Object(all)
}

fn by_name<'a>(
    figures: impl IntoIterator<Item = &'a ReliefFigures>,
    value: impl Fn(&ReliefFigures) -> Value,
) -> Map<String, Value> {
    let figures = figures.into_iter();
    figures.map(|of| (of.name.clone(), value(of))).collect()
}
