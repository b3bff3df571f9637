//! R1 to R4 and their likes for gullies.

use super::*;
use VertexKind::{Gully, River, Terrain};

/// R1: beds and water fall by three quarters of their way on the first half of edges of levels 0 to
/// 7, by half of it from level 8 on.
#[test]
fn rivers_fall_by_their_share() {
    for rules in PRESETS {
        for seed in 0..2_000 {
            let [mut up, mut down] = pair(seed, [River, River]);
            if up.bed < down.bed {
                std::mem::swap(&mut up, &mut down);
            }
            let level = seed % 17;
            let share = if level < 8 { 0.75 } else { 0.5 };
            let ground = halved(&rules, EdgeKind::River, &up, &down, level);
            for (got, up, down) in [
                (ground.bed, up.bed, down.bed),
                (ground.water, up.water, down.water),
            ] {
                let want = mix(f64::from(up), f64::from(down), share);
                assert!((f64::from(got) - want).abs() < 2.0, "{level} {got} {want}");
            }
        }
    }
}

/// (1 - 0.95r²)·min(0.2ℓ, C), at least min(0.2ℓ, `least`) over the higher drain.
fn crest(edge: &RealEdge, least: f64, r: f64) -> f64 {
    let rise = 0.2 * edge.length();
    let over_drains = edge.ordered()[1] + rise.min(least);
    over_drains.max((1.0 - 0.95 * r * r) * rise.min(edge.crust()))
}

/// R2: at least 50 m over the rivers.
#[test]
fn crests_between_rivers_are_the_closed_form() {
    check(EdgeKind::Terrain, [River, River], 400.0, |edge| {
        crest(edge, m(50.0), edge.xi(0))
    });
}

/// R2 of gullies: at least 25 m over them; r is ξ, on plateaus 1 - ξ³.
#[test]
fn crests_between_gullies_are_the_closed_form() {
    check(EdgeKind::Terrain, [Gully, Gully], 800.0, |edge| {
        let xi = edge.xi(0);
        let r = mix(xi, 1.0 - xi * xi * xi, edge.plateau());
        crest(edge, m(25.0), r)
    });
}

/// The lower of 0.2ℓ and the room under the crust, at least 100 m of it.
fn low_land_rise(edge: &RealEdge, drain: f64) -> f64 {
    let room = (edge.crust() - drain).max(m(100.0));
    room.min(0.2 * edge.length())
}

/// R3: mix(h_r, h_t, 0.1 + 0.9r), r = ξ, on plateaus 1 - ξ³; land below its river rises over it by
/// 0.05 + 0.95r of its rise.
#[test]
fn slopes_beside_rivers_are_the_closed_form() {
    check(EdgeKind::Terrain, [River, Terrain], 500.0, |edge| {
        let [river, land] = edge.heights();
        let xi = edge.xi(0);
        let r = mix(xi, 1.0 - xi * xi * xi, edge.plateau());
        if land < river {
            return river + low_land_rise(edge, river) * (0.05 + 0.95 * r);
        }
        mix(river, land, 0.1 + 0.9 * r)
    });
}

/// R3 of gullies: mix(h_g, h_t + min(0.1ℓ, max(10 m, C - h_t)), 0.4 + 0.4r), r = ξ, on plateaus
/// 1 - ξ²; land below its gully rises over it by 0.4 + 0.4r of its rise.
#[test]
fn slopes_beside_gullies_are_the_closed_form() {
    check(EdgeKind::Terrain, [Gully, Terrain], 500.0, |edge| {
        let [gully, land] = edge.heights();
        let xi = edge.xi(0);
        let share = 0.4 + 0.4 * mix(xi, 1.0 - xi * xi, edge.plateau());
        if land < gully {
            return gully + low_land_rise(edge, gully) * share;
        }
        let room = (edge.crust() - land).max(m(10.0));
        mix(gully, land + room.min(0.1 * edge.length()), share)
    });
}

/// A gully is halved at 0.4 + 0.1ξ of the way up.
#[test]
fn gullies_are_the_closed_form() {
    check(EdgeKind::Gully, [Gully, Terrain], 150.0, |edge| {
        let [low, high] = edge.ordered();
        mix(low, high, 0.4 + 0.1 * edge.xi(0))
    });
}

/// A gully that ends in a river but whose land does not overtop it stands 30 m and
/// ξ·min(0.1ℓ, 500 m) over the river.
#[test]
fn gullies_over_rivers_are_the_closed_form() {
    check(EdgeKind::Gully, [Terrain, River], 150.0, |edge| {
        let [land, river] = edge.heights();
        if land <= river {
            return river + m(30.0) + (0.1 * edge.length()).min(m(500.0)) * edge.xi(0);
        }
        mix(river, land, 0.4 + 0.1 * edge.xi(0))
    });
}

/// R4: a spring stands 0.4 + 0.2ξ of the way up to the land, at most 0.6 ℓ tan 3° and 1500 m over
/// its mouth; its bed is dry.
#[test]
fn springs_are_the_closed_form() {
    for rules in PRESETS {
        for seed in 0..2_000 {
            let [mouth, mut land] = pair(seed, [River, Terrain]);
            land.height = land.height.max(mouth.bed + metres(1));
            let level = seed % 5;
            let real = RealEdge {
                rules: &rules,
                ends: [&mouth, &land],
                level,
            };
            let [low, high] = real.heights();
            // The tangent of 3°.
            let slope = 0.052_407_8 * 0.6 * real.length();
            let gentle = low + slope.min(m(1_500.0));
            let want = gentle.min(mix(low, high, 0.4 + 0.2 * real.xi(0)));
            let ground = halved(&rules, EdgeKind::River, &land, &mouth, level);
            let got = f64::from(ground.bed);
            // A share of 2⁻¹⁶ of 52 km is 812 grains.
            assert!((got - want).abs() < 600.0, "{level} {got} {want}");
            assert_eq!(ground.water, ground.bed);
        }
    }
}

/// A spring is drawn at 0.6 to 0.8 of the way up from its mouth, on its edge.
#[test]
fn springs_lie_beyond_the_middle() {
    for rules in PRESETS {
        for seed in 0..2_000 {
            let new = vertex(seed, Terrain);
            let shift = |kinds| shift::shift(&rules, EdgeKind::River, kinds, seed % 5, &new);
            let up = 0.6 + 0.2 * f64::from(share(new.seed, 12)) / 65_536.0;
            for (kinds, want) in [([River, Terrain], up), ([Terrain, River], 1.0 - up)] {
                let shift = shift(kinds);
                let got = f64::from(shift.along) / 65_536.0;
                assert!((got - want).abs() < 1e-4, "{got} {want}");
                assert_eq!((shift.inward, shift.weight), (0, 65_536));
            }
        }
    }
}
