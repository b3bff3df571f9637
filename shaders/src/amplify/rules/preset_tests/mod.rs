//! Print and release as closed forms of reals: what a rule makes of two random vertices, against
//! its formula written again in f64. Heights in grains.

mod drains;
mod mountains;

use super::graph_tests::{edge_length, halved, vertex};
use super::*;
use crate::amplify::fixed::{ONE, metres};
use crate::amplify::seed::{between, draw, share};
use crate::amplify::vertex::Vertex;

const PRESETS: [Rules; 2] = [Rules::PAPER, Rules::RELEASE];

/// Two vertices of any maps, at any latitude and any distance from a river, that no lake widens.
fn pair(seed: u32, kinds: [VertexKind; 2]) -> [Vertex; 2] {
    [(seed, kinds[0]), (seed + 50_000, kinds[1])].map(|(seed, kind)| Vertex {
        direction: [0, 0, (draw(seed, 30) % ONE as u32) as i32],
        river_distance: (draw(seed, 31) % metres(40_000) as u32) as i32,
        branched: true,
        is_drained: true,
        ..vertex(seed, kind)
    })
}

/// The edge of a level between two vertices, in reals.
struct RealEdge<'a> {
    rules: &'a Rules,
    ends: [&'a Vertex; 2],
    level: u32,
}

impl RealEdge<'_> {
    /// The `k`th draw of the vertex in the middle, 0..1.
    fn xi(&self, k: u32) -> f64 {
        let [a, b] = self.ends;
        f64::from(share(between(a.seed, b.seed), k)) / 65_536.0
    }

    fn heights(&self) -> [f64; 2] {
        self.ends.map(|v| f64::from(v.height))
    }

    /// The lower height and the higher.
    fn ordered(&self) -> [f64; 2] {
        let [a, b] = self.heights();
        [a.min(b), a.max(b)]
    }

    fn length(&self) -> f64 {
        f64::from(edge_length(self.level))
    }

    /// Crust elevation C in the middle.
    fn crust(&self) -> f64 {
        let [a, b] = self.ends;
        f64::from(a.crust / 2 + b.crust / 2)
    }

    /// Plateau presence P in the middle.
    fn plateau(&self) -> f64 {
        f64::from(self.ends[0].plateau) / 65_536.0
    }
}

/// A length in metres as grains.
fn m(metres: f64) -> f64 {
    metres * 1_024.0
}

fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Compares heights of the levels below the fine ones; a share of 2⁻¹⁶ of 8 km is 125 grains.
fn check(edge: EdgeKind, kinds: [VertexKind; 2], within: f64, want: impl Fn(&RealEdge) -> f64) {
    for rules in PRESETS {
        for seed in 0..4_000 {
            let [a, b] = pair(seed, kinds);
            let level = seed % rules.fine_level;
            let got = f64::from(halved(&rules, edge, &a, &b, level).height);
            let real = RealEdge {
                rules: &rules,
                ends: [&a, &b],
                level,
            };
            let want = want(&real);
            assert!(
                (got - want).abs() < within,
                "{rules:?} {level} {seed}: {got}, not {want}"
            );
        }
    }
}

/// Fine ground of the release: α = ½ - q/2 + qξ with q = 1 - 0.618 (λ/16)², and up to ℓ / 6.82
/// above; whatever its ends are.
#[test]
fn fine_ground_is_the_closed_form() {
    use VertexKind::{Gully, River, Terrain};
    for (k, kinds) in (0..).zip([
        [Terrain, Terrain],
        [River, River],
        [River, Terrain],
        [Gully, Terrain],
        [Gully, Gully],
    ]) {
        for seed in 0..4_000 {
            let (rules, level) = (&PRESETS[seed as usize % 2], 10 + (seed + k) % 7);
            let [a, b] = pair(seed, kinds);
            let real = RealEdge {
                rules,
                ends: [&a, &b],
                level,
            };
            let [low, high] = real.ordered();
            let q = 1.0 - 0.618 * f64::from(level * level) / 256.0;
            let base = mix(low, high, 0.5 - q / 2.0 + q * real.xi(0));
            let above = real.length() / 6.82 * real.xi(1) * real.xi(2);
            let want = base + above * real.xi(3) * real.xi(4);
            let got = f64::from(halved(rules, EdgeKind::Terrain, &a, &b, level).height);
            // q is right to 2⁻¹¹.
            let allowed = 6.0 + (high - low) / 2_000.0;
            assert!((got - want).abs() < allowed, "{level} {got} {want}");
        }
    }
}

/// Between land and sea, and along the sea floor, the mean; along the shore the shore.
#[test]
fn coasts_are_the_mean() {
    use VertexKind::{Coast, Sea, Terrain};
    for kinds in [[Terrain, Sea], [Sea, Sea], [Coast, Coast]] {
        check(EdgeKind::Terrain, kinds, 2.0, |edge| {
            let [a, b] = edge.ends;
            let ground = halved(edge.rules, EdgeKind::Terrain, a, b, edge.level);
            let mean = edge.heights().iter().sum::<f64>() / 2.0;
            assert_eq!(ground.kind == Sea, mean < 0.0, "{mean}");
            mean
        });
    }
}
