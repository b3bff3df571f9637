//! The control mesh does not show in the ground: along its edges and across them the relief has the
//! same spectrum.
//!
//! At each edge two profiles cross at right angles in its middle, both as long as the edge. A
//! crease along the edge, a facet beside it or a pattern of its corners would give one of them more
//! power than the other at some wavelength. Edges down which water runs, in a river or after rain,
//! are left out: valleys follow them by intent.

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::control::{Bake, PlanetBake, bake_now};
use bevy_pangaea::hydrology::ShoreClass;
use bevy_pangaea::query::{Ground, PlanetGround, Rules};
use core::f64::consts::{LN_2, PI};
use pangaea_shaders::amplify::control::{ControlEdge, ControlVertex, VertexKind};
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, planet_app, steps, surface};

/// Points of a profile; 52 km / 128 are two edges of [`LEVEL`].
const POINTS: usize = 128;

/// Level of the heights: edges of 200 m.
const LEVEL: u8 = 8;

/// Octaves: wavelengths from 26 km to 0.8 km, in waves to a profile.
const BANDS: [[usize; 2]; 5] = [[2, 4], [4, 8], [8, 16], [16, 32], [32, 64]];

/// Edges of a kind of ground.
const EDGES: usize = 400;

/// Standard errors that chance may be off: with 15 bands, in one of a thousand planets.
const SIGMAS: f64 = 4.0;

/// The middle of an edge, where two profiles cross, and half of the edge.
struct Cross {
    middle: DVec3,
    half: DVec3,
}

impl Cross {
    fn new(a: DVec3, b: DVec3) -> Self {
        Self {
            middle: (a + b).normalize(),
            half: 0.5 * (b - a),
        }
    }

    /// Directions of a profile along the edge, or across it.
    fn profile(&self, across: bool) -> impl Iterator<Item = DVec3> + '_ {
        let half = if across {
            self.middle.cross(self.half)
        } else {
            self.half
        };
        let share = |i: usize| (2.0 * i as f64 + 1.0) / POINTS as f64 - 1.0;
        (0..POINTS).map(move |i| (self.middle + share(i) * half).normalize())
    }
}

/// Power of a profile in each band, under a Hann window, once its line of least squares is taken
/// off.
fn powers(heights: &[f32]) -> [f64; BANDS.len()] {
    let windowed = windowed(heights);
    BANDS.map(|[low, high]| (low..high).map(|k| power(&windowed, k)).sum())
}

/// A profile without its mean and its slope, faded in and out.
fn windowed(heights: &[f32]) -> Vec<f64> {
    let n = heights.len() as f64;
    let place = |i: usize| i as f64 - 0.5 * (n - 1.0);
    let heights: Vec<f64> = heights.iter().map(|&z| f64::from(z)).collect();
    let mean = heights.iter().sum::<f64>() / n;
    let moments = heights.iter().enumerate().map(|(i, z)| z * place(i));
    let slope = moments.sum::<f64>() / (n * (n * n - 1.0) / 12.0);
    let rest = heights
        .iter()
        .enumerate()
        .map(|(i, z)| z - mean - slope * place(i));
    rest.enumerate()
        .map(|(i, z)| z * (PI * (i as f64 + 0.5) / n).sin().powi(2))
        .collect()
}

/// Power of the wave that fits `k` times into a profile.
fn power(profile: &[f64], k: usize) -> f64 {
    let n = profile.len();
    let mut sums = [0.0; 2];
    for (i, z) in profile.iter().enumerate() {
        let (sin, cos) = (2.0 * PI * ((k * i) % n) as f64 / n as f64).sin_cos();
        sums[0] += z * cos;
        sums[1] += z * sin;
    }
    sums[0] * sums[0] + sums[1] * sums[1]
}

/// A thousandth of a millimetre, squared: flat facets have no logarithm.
const FAINT: f64 = 1e-6;

/// Mean and standard error, over edges, of ln(power across / power along) in each band.
fn log_ratios(ground: &impl Ground, level: u8, edges: &[Cross]) -> [[f64; 2]; BANDS.len()] {
    let directions: Vec<DVec3> = edges
        .iter()
        .flat_map(|edge| edge.profile(false).chain(edge.profile(true)))
        .collect();
    let mut heights = vec![0.0; directions.len()];
    ground.heights(&directions, level, &mut heights).unwrap();
    let ratios: Vec<[f64; BANDS.len()]> = heights
        .chunks_exact(2 * POINTS)
        .map(|pair| {
            let (along, across) = (powers(&pair[..POINTS]), powers(&pair[POINTS..]));
            core::array::from_fn(|k| ((across[k] + FAINT) / (along[k] + FAINT)).ln())
        })
        .collect();
    core::array::from_fn(|k| mean_and_error(ratios.iter().map(|ratio| ratio[k])))
}

/// Mean of some values and its standard error.
fn mean_and_error(values: impl ExactSizeIterator<Item = f64> + Clone) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.clone().sum::<f64>() / n;
    let square = values.map(|x| (x - mean) * (x - mean)).sum::<f64>();
    [mean, (square / (n * (n - 1.0))).sqrt()]
}

fn is_dry(vertex: &ControlVertex) -> bool {
    vertex.kind == VertexKind::Terrain as u8
}

/// The lowest neighbour of each vertex, to which dry land drains.
fn drains(bake: &Bake) -> Vec<Option<u32>> {
    let vertices = &bake.control.vertices;
    let ground = |v: u32| match &vertices[v as usize] {
        wet if wet.flow > 0 || wet.kind == VertexKind::Lake as u8 => wet.bed,
        dry => dry.height,
    };
    let mut drains = vec![None; vertices.len()];
    for &ControlEdge { vertices, .. } in &bake.control.edges {
        let [a, b] = vertices;
        for (from, to) in [(a, b), (b, a)] {
            let lowest = &mut drains[from as usize];
            if lowest.is_none_or(|v| ground(to) < ground(v)) {
                *lowest = Some(to);
            }
        }
    }
    drains
}

/// Edges of the control mesh, without a river or a drain of dry land, whose four vertices around all
/// belong; evenly drawn.
fn edges(bake: &Bake, belongs: impl Fn(usize) -> bool) -> Vec<Cross> {
    let mesh = bake.mesh();
    let drains = drains(bake);
    let drains_to = |v: u32, to: u32| {
        is_dry(&bake.control.vertices[v as usize]) && drains[v as usize] == Some(to)
    };
    let sheds = |edge: &&ControlEdge| {
        let [a, b] = edge.vertices;
        edge.river == 0 && !drains_to(a, b) && !drains_to(b, a)
    };
    let corners = |face: u32| mesh.triangles()[face as usize];
    let all_belong = |face: u32| corners(face).into_iter().all(|v| belongs(v as usize));
    let dry = bake.control.edges.iter().filter(sheds);
    let found: Vec<[u32; 2]> = dry
        .filter(|edge| edge.faces.into_iter().all(all_belong))
        .map(|edge| edge.vertices)
        .collect();
    found
        .iter()
        .step_by((found.len() / EDGES).max(1))
        .take(EDGES)
        .map(|&[a, b]| Cross::new(mesh.point(a), mesh.point(b)))
        .collect()
}

/// Edges of dry land.
fn land(bake: &Bake) -> Vec<Cross> {
    let sites = &bake.drainage.shore;
    let is_dry = |v: usize| bake.control.vertices[v].flow == 0 && !bake.drainage.is_lake(v);
    edges(bake, |v| sites[v] == ShoreClass::Land && is_dry(v))
}

/// Edges of sea floor between two elevations in km.
fn sea(bake: &Bake, low: f32, high: f32) -> Vec<Cross> {
    let (sites, km) = (&bake.drainage.shore, bake.terrain.elevation_km());
    edges(bake, |v| {
        sites[v] == ShoreClass::Sea && km[v] > low && km[v] < high
    })
}

/// Bands of some edges' spectra in which the power across them is more or less than that along
/// them, beyond chance.
fn visible_bands(ground: &PlanetGround, edges: &[Cross]) -> Vec<String> {
    let mut visible = Vec::new();
    let ratios = log_ratios(ground, LEVEL, edges);
    for ([mean, error], [low, high]) in ratios.into_iter().zip(BANDS) {
        // A test that cannot tell half as much again says nothing.
        assert!(SIGMAS * error < 1.5_f64.ln(), "{error}");
        if mean.abs() > SIGMAS * error {
            let [mean, error] = [mean, error].map(|x| x / LN_2);
            visible.push(format!(
                "{low} to {high} waves to an edge: 2^({mean:.2} ± {error:.2})"
            ));
        }
    }
    visible
}

#[test]
fn no_edge_of_the_control_mesh_shows_in_the_spectra_of_land_shelf_and_slope() {
    let (mut app, planet) = planet_app(&small(1, 60_000));
    steps(&mut app, planet, 60);
    surface(&mut app, planet);
    bake_now(app.world_mut(), planet).unwrap();
    let bake = &get::<PlanetBake>(&app, planet).0;
    let ground = PlanetGround::of_bake(bake, Rules::default()).unwrap();
    let kinds = [
        ("land", land(bake)),
        ("shelf", sea(bake, -0.25, 0.0)),
        ("slope", sea(bake, -3.5, -0.25)),
    ];
    for (name, edges) in kinds {
        assert!(edges.len() > EDGES / 2, "{} edges of {name}", edges.len());
        let facets = log_ratios(&ground, 0, &edges);
        let are_seen = facets.iter().all(|[mean, _]| *mean > 5.0);
        assert!(are_seen, "bare facets are not seen: {facets:?}");
        let visible = visible_bands(&ground, &edges);
        assert!(
            visible.is_empty(),
            "{name}, power across to power along: {visible:#?}"
        );
    }
}
