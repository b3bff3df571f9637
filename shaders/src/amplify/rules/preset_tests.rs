//! Print and release as closed forms of reals.

use super::graph_tests::{edge_length, halved, vertex};
use super::*;
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, metres};
use crate::amplify::seed::{between, share};
use crate::amplify::vertex::Vertex;

const PRESETS: [Rules; 2] = [Rules::PAPER, Rules::RELEASE];

/// A pair of vertices without plateaus and hills, on young wet land.
fn plain_pair(seed: u32, kinds: [VertexKind; 2]) -> [Vertex; 2] {
    let [a, b] = [seed, seed + 50_000];
    [(a, kinds[0]), (b, kinds[1])].map(|(seed, kind)| Vertex {
        plateau: 0,
        hills: 0,
        age: 0,
        wetness: u16::MAX,
        branched: true,
        ..vertex(seed, kind)
    })
}

/// The `k`th draw of the vertex between two others, 0..1.
fn xi(a: &Vertex, b: &Vertex, k: u32) -> f64 {
    f64::from(share(between(a.seed, b.seed), k)) / 65_536.0
}

/// Compares heights of all levels below the fine ones, to within a share of 2⁻¹⁵ of 10 km and the
/// errors of the fixed-point constants.
fn check(edge: EdgeKind, kinds: [VertexKind; 2], want: impl Fn(&Rules, [&Vertex; 2], u32) -> f64) {
    for rules in PRESETS {
        for seed in 0..4_000 {
            let [a, b] = plain_pair(seed, kinds);
            let level = seed % rules.fine_level;
            let got = f64::from(halved(&rules, edge, &a, &b, level).height);
            let want = want(&rules, [&a, &b], level);
            assert!((got - want).abs() < 400.0, "{rules:?} {level} {got} {want}");
        }
    }
}

fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// R2: max(h_r + min(0.2ℓ, 50 m), (1 - 0.95ξ²)·min(0.2ℓ, C)).
#[test]
fn crests_between_rivers_are_the_closed_form() {
    use VertexKind::River;
    check(EdgeKind::Terrain, [River, River], |_, [a, b], level| {
        let rise = 0.2 * f64::from(edge_length(level));
        let crust = f64::from(a.crust / 2 + b.crust / 2);
        let over_rivers = f64::from(a.height.max(b.height)) + rise.min(f64::from(metres(50)));
        let xi = xi(a, b, 0);
        over_rivers.max((1.0 - 0.95 * xi * xi) * rise.min(crust))
    });
}

/// R3: mix(h_r, h_t, 0.1 + 0.9ξ); land below its river rises by 0.05 + 0.95ξ of the lower of 0.2ℓ
/// and the room under the crust.
#[test]
fn slopes_beside_rivers_are_the_closed_form() {
    use VertexKind::{River, Terrain};
    check(
        EdgeKind::Terrain,
        [River, Terrain],
        |_, [river, land], level| {
            let [low, high] = [river, land].map(|v| f64::from(v.height));
            let xi = xi(river, land, 0);
            if high > low {
                return mix(low, high, 0.1 + 0.9 * xi);
            }
            let room = f64::from(river.crust / 2 + land.crust / 2) - low;
            let rise = 0.2 * f64::from(edge_length(level));
            low + rise.min(room.max(f64::from(metres(100)))) * (0.05 + 0.95 * xi)
        },
    );
}

/// A gully is halved at 0.4 + 0.1ξ of the way up.
#[test]
fn gullies_are_the_closed_form() {
    use VertexKind::{Gully, Terrain};
    check(EdgeKind::Gully, [Gully, Terrain], |_, [a, b], _| {
        let [low, high] = [a.height.min(b.height), a.height.max(b.height)].map(f64::from);
        mix(low, high, 0.4 + 0.1 * xi(a, b, 0))
    });
}

/// R5 where peaks have faded: α between the ends, ½ + Δ/2 (ξ^1.5 - 1) as printed and
/// ½ + Δ (ξ^1.5 - ½) as released, with Δ = 1 - 0.04λ.
#[test]
fn young_mountains_are_the_closed_form() {
    use VertexKind::Terrain;
    for rules in PRESETS {
        for seed in 0..4_000 {
            let [a, b] = plain_pair(seed, [Terrain, Terrain]);
            let [low, high] = [a.height.min(b.height), a.height.max(b.height)].map(f64::from);
            let xi = xi(&a, &b, 0);
            let power = xi * xi.sqrt();
            let delta = 1.0 - 0.04 * 9.0;
            let alpha = match rules.form {
                nodes::Form::Paper => 0.5 + delta / 2.0 * (power - 1.0),
                nodes::Form::Release => 0.5 + delta * (power - 0.5),
            };
            let got = f64::from(halved(&rules, EdgeKind::Terrain, &a, &b, 9).height);
            let want = mix(low, high, alpha);
            // Under low crust, a part of the hundredth that has not faded yet.
            let allowed = 400.0 + 0.01 * (high - low).max(f64::from(a.crust));
            assert!((got - want).abs() < allowed, "{rules:?} {got} {want}");
        }
    }
}

/// Fine ground of the release: α = ½ - q/2 + qξ with q = 1 - 0.618 (λ/16)², and up to ℓ / 7 above.
#[test]
fn fine_ground_is_the_closed_form() {
    use VertexKind::Terrain;
    for level in 10..17 {
        for seed in 0..1_000 {
            let [a, b] = plain_pair(seed, [Terrain, Terrain]);
            let [low, high] = [a.height.min(b.height), a.height.max(b.height)].map(f64::from);
            let draw = |k| xi(&a, &b, k);
            let q = 1.0 - 0.618 * f64::from(level * level) / 256.0;
            let base = mix(low, high, 0.5 - q / 2.0 + q * draw(0));
            let above = f64::from(edge_length(level)) / 7.0 * draw(1) * draw(2);
            let got = halved(&Rules::RELEASE, EdgeKind::Terrain, &a, &b, level).height;
            let want = base + above * draw(3) * draw(4);
            // q is right to 2⁻¹¹.
            let allowed = 4.0 + (high - low) / 2_000.0;
            assert!(
                (f64::from(got) - want).abs() < allowed,
                "{level} {got} {want}"
            );
        }
    }
}

/// R1: beds and water fall by half of their way at the ends of the range of levels, by 0.65
/// between.
#[test]
fn rivers_fall_by_their_share() {
    for rules in PRESETS {
        for seed in 0..2_000 {
            let [mut up, mut down] = plain_pair(seed, [VertexKind::River, VertexKind::River]);
            if up.bed < down.bed {
                std::mem::swap(&mut up, &mut down);
            }
            let level = seed % 17;
            let share = if (1..8).contains(&level) { 0.65 } else { 0.5 };
            let ground = halved(&rules, EdgeKind::River, &up, &down, level);
            for (got, up, down) in [
                (ground.bed, up.bed, down.bed),
                (ground.water, up.water, down.water),
            ] {
                let want = mix(f64::from(up), f64::from(down), share);
                assert!((f64::from(got) - want).abs() < 60.0, "{level} {got} {want}");
            }
        }
    }
}

/// R4: a spring stands 0.4 + 0.2ξ of the way up to the land, at most 0.6 ℓ tan 3° and 1500 m over
/// its mouth.
#[test]
fn springs_are_the_closed_form() {
    for rules in PRESETS {
        for seed in 0..2_000 {
            let [mouth, mut land] = plain_pair(seed, [VertexKind::River, VertexKind::Terrain]);
            land.height = land.height.max(mouth.bed + 2 * GRAINS);
            let level = seed % 5;
            let ground = halved(&rules, EdgeKind::River, &land, &mouth, level);
            let [low, high] = [mouth.bed, land.height].map(f64::from);
            let slope = 0.052_408 * 0.6 * f64::from(edge_length(level));
            let gentle = low + slope.min(f64::from(metres(1_500)));
            let want = gentle.min(mix(low, high, 0.4 + 0.2 * xi(&mouth, &land, 0)));
            let got = f64::from(ground.bed);
            // A share of 2⁻¹⁶ of 52 km is 812 grains.
            assert!((got - want).abs() < 600.0, "{level} {got} {want}");
        }
    }
}

/// Between land and sea, and along the sea floor, the mean; along the shore the shore.
#[test]
fn coasts_are_the_mean() {
    use VertexKind::{Coast, Sea, Terrain};
    for (kinds, is_sea) in [
        ([Terrain, Sea], false),
        ([Sea, Sea], true),
        ([Coast, Coast], false),
    ] {
        check(EdgeKind::Terrain, kinds, |rules, [a, b], level| {
            let ground = halved(rules, EdgeKind::Terrain, a, b, level);
            assert_eq!(ground.kind == Sea, is_sea || ground.height < 0);
            f64::from(a.height) / 2.0 + f64::from(b.height) / 2.0
        });
    }
}

/// Height of the middle of an edge of a level in a plain, between two kinds of vertices.
fn height_in_plain(rules: &Rules, kinds: [VertexKind; 2], level: u32) -> i32 {
    let [a, b] = plain_pair(1, kinds);
    halved(rules, EdgeKind::Terrain, &a, &b, level).height
}

/// Where print and release agree, and where they do not.
#[test]
fn presets_differ_where_print_and_release_do() {
    use VertexKind::{River, Terrain};
    let both = |kinds, level| PRESETS.map(|rules| height_in_plain(&rules, kinds, level));
    let [paper, release] = both([Terrain, Terrain], 9);
    assert!(
        paper < release,
        "the print's young mountains lie below the middle"
    );
    for kinds in [[River, River], [River, Terrain]] {
        let [paper, release] = both(kinds, 5);
        assert_eq!(paper, release, "{kinds:?}");
        let ours = height_in_plain(&Rules::default(), kinds, 5);
        assert_ne!(ours, release, "{kinds:?}");
    }
}
