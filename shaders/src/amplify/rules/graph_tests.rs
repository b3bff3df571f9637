//! Laws of the graphs, which hold for any two vertices and any seed.

use super::*;
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres};
use crate::amplify::seed::{between, draw, pcg};
use crate::amplify::vertex::{EdgeContext, FAR, Vertex};

/// A random vertex of a kind: land however worn, up to 8 km high.
pub(super) fn vertex(seed: u32, kind: VertexKind) -> Vertex {
    let crust = 50 * GRAINS + (draw(seed, 1) % 8_000_000) as i32;
    let height = match kind {
        VertexKind::Sea => -GRAINS - (draw(seed, 2) % 6_000_000) as i32,
        VertexKind::Coast => 0,
        _ => 20 * GRAINS + (draw(seed, 2) % crust as u32) as i32,
    };
    let wet = matches!(kind, VertexKind::River | VertexKind::Lake);
    let water = if wet { height + 2_000 } else { height.max(0) };
    Vertex {
        kind,
        height,
        bed: height,
        water,
        crust,
        seed: pcg(seed),
        discharge: if wet { draw(seed, 3) } else { 0 },
        worn: draw(seed, 4) as u16,
        collision: draw(seed, 5) as u16,
        wetness: draw(seed, 6) as u16,
        plateau: if seed & 4 == 0 {
            0
        } else {
            draw(seed, 7) as u16
        },
        hills: if seed & 8 == 0 {
            0
        } else {
            draw(seed, 8) as u16
        },
        river_distance: FAR,
        ..Vertex::default()
    }
}

/// Length of an edge of a level, grains.
pub(super) const fn edge_length(level: u32) -> i32 {
    metres(52_000) >> level
}

/// An edge of a length between two vertices, of which the rules know no corners beside it.
pub(super) fn between_two<'a>(
    [a, b]: [&'a Vertex; 2],
    new: &'a Vertex,
    level: u32,
    length: i32,
) -> EdgeContext<'a> {
    EdgeContext {
        a,
        b,
        new,
        face: a.height / 2 + b.height / 2,
        range: [a.height.min(b.height), a.height.max(b.height)],
        is_dammed: true,
        curvature: 0,
        beside: [None; 2],
        is_descent: false,
        length,
        span: length,
        level,
        radius_m: 6_371_000,
    }
}

/// The ground in the middle of an edge of mean length; the maps of the new vertex are those of `a`.
pub(super) fn halved(
    rules: &Rules,
    edge: EdgeKind,
    a: &Vertex,
    b: &Vertex,
    level: u32,
) -> VertexGround {
    let new = Vertex {
        seed: between(a.seed, b.seed),
        crust: a.crust / 2 + b.crust / 2,
        ..*a
    };
    halve(
        rules,
        edge,
        &between_two([a, b], &new, level, edge_length(level)),
    )
}

/// Every pair of kinds on every level.
fn pairs(mut check: impl FnMut(Vertex, Vertex, u32)) {
    use VertexKind::{Coast, Gully, Lake, River, Sea, Terrain};
    let kinds = [Terrain, River, Gully, Lake, Coast, Sea];
    for seed in 0..400 {
        for (k, a) in kinds.into_iter().enumerate() {
            for (j, b) in kinds.into_iter().enumerate() {
                let other = pcg(seed * 64 + (k * 8 + j) as u32);
                check(vertex(pcg(seed + 9_999), a), vertex(other, b), seed % 17);
            }
        }
    }
}

const fn is_land(vertex: &Vertex) -> bool {
    !matches!(vertex.kind, VertexKind::Sea | VertexKind::Coast)
}

/// So that it can drain there, whatever the drains around it do.
#[test]
fn new_land_stands_above_its_lower_end() {
    let rules = Rules::default();
    let mut land = 0;
    pairs(|a, b, level| {
        let is_dry = [&a, &b]
            .iter()
            .all(|v| is_land(v) && v.kind != VertexKind::Lake);
        let ground = halved(&rules, EdgeKind::Terrain, &a, &b, level);
        if is_dry && level < rules.fine_level && ground.kind == VertexKind::Terrain {
            let lower = a.height.min(b.height);
            assert!(ground.height > lower, "{level} {a:?} {b:?} {ground:?}");
            land += 1;
        }
    });
    assert!(land > 1_000, "{land}");
}

/// Fine ground has its roughness on top, a fifth of the edge at most; drains a least rise.
#[test]
fn crests_stay_under_the_crust() {
    let rules = Rules::default();
    pairs(|a, b, level| {
        if !is_land(&a) || !is_land(&b) {
            return;
        }
        let ground = halved(&rules, EdgeKind::Terrain, &a, &b, level);
        let share = if level < rules.fine_level { 4_096 } else { 5 };
        let spare = edge_length(level) / share + metres(2);
        let top = a.height.max(b.height).max(a.crust / 2 + b.crust / 2);
        assert!(
            ground.height <= top + spare,
            "{level} {a:?} {b:?} {ground:?}"
        );
    });
}

#[test]
fn terrain_does_not_know_which_end_comes_first() {
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        for seed in 0..2_000 {
            let a = vertex(seed, VertexKind::Terrain);
            // The maps of the new vertex are those of the first end.
            let b = Vertex {
                height: vertex(seed + 70_000, VertexKind::Terrain).height,
                seed: pcg(seed + 70_000),
                ..a
            };
            let forth = halved(&rules, EdgeKind::Terrain, &a, &b, 5);
            assert_eq!(forth, halved(&rules, EdgeKind::Terrain, &b, &a, 5));
        }
    }
}

#[test]
fn rivers_descend_and_hold_their_water() {
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        for seed in 0..4_000 {
            let mut up = vertex(seed, VertexKind::River);
            let mut down = vertex(seed + 50_000, VertexKind::River);
            if up.bed < down.bed {
                std::mem::swap(&mut up, &mut down);
            }
            let ground = halved(&rules, EdgeKind::River, &up, &down, seed % 17);
            assert_eq!(ground.kind, VertexKind::River);
            assert!(up.bed - down.bed < 2 || (up.bed > ground.bed && ground.bed > down.bed));
            assert!(ground.water >= ground.bed);
            assert!(up.water.max(ground.bed) >= ground.water);
        }
    }
}

#[test]
fn gullies_hang_in_a_hollow() {
    for rules in [Rules::default(), Rules::RELEASE] {
        for seed in 0..4_000 {
            let (a, b) = (
                vertex(seed, VertexKind::Gully),
                vertex(seed + 50_000, VertexKind::Terrain),
            );
            let (low, high) = (a.height.min(b.height), a.height.max(b.height));
            let height = halved(&rules, EdgeKind::Gully, &a, &b, seed % 9).height;
            assert!(
                (low..=low / 2 + high / 2 + 1).contains(&height),
                "{low} {height} {high}"
            );
            assert!(high - low < 8 || height > low);
        }
    }
}

#[test]
fn springs_rise_from_their_river() {
    for seed in 0..4_000 {
        let (mouth, mut land) = (
            vertex(seed, VertexKind::River),
            vertex(seed + 50_000, VertexKind::Terrain),
        );
        land.height = land.height.max(mouth.water + 10 * GRAINS);
        for (a, b) in [(&land, &mouth), (&mouth, &land)] {
            let ground = halved(&Rules::default(), EdgeKind::River, a, b, 2);
            assert_eq!(ground.kind, VertexKind::River);
            assert!(
                ground.bed > mouth.bed && ground.bed < land.height && ground.water >= ground.bed
            );
            // Never steeper than 3° over its half, but for the least rise.
            let rise = f64::from(ground.bed - mouth.bed);
            assert!(rise <= f64::from(edge_length(2)) * 0.0525 + 2.0);
        }
    }
}

#[test]
fn the_sea_floor_stays_under_the_sea() {
    for rules in [Rules::default(), Rules::PAPER] {
        for seed in 0..4_000 {
            let (a, b) = (
                vertex(seed, VertexKind::Sea),
                vertex(seed + 50_000, VertexKind::Sea),
            );
            let ground = halved(&rules, EdgeKind::Terrain, &a, &b, seed % 17);
            assert!(ground.kind == VertexKind::Sea && ground.height < 0 && ground.water == 0);
        }
    }
}

#[test]
fn lakes_lie_at_their_rivers_level_under_land() {
    let rules = Rules {
        lake_chance: Q16,
        ..Rules::default()
    };
    let mut lakes = 0;
    for seed in 0..4_000 {
        let (river, land) = (
            vertex(seed, VertexKind::River),
            vertex(seed + 50_000, VertexKind::Terrain),
        );
        let ground = halved(&rules, EdgeKind::Terrain, &river, &land, 2);
        if ground.kind == VertexKind::Lake {
            assert!(
                ground.water == river.water && ground.bed < river.bed && land.height > ground.water
            );
            // A slope that is not too steep for shores: they lie a fifth of the way up at least.
            assert!(land.height - ground.water <= 4 * (ground.water - ground.bed));
            lakes += 1;
        }
    }
    assert!(lakes > 100, "{lakes}");
}

/// A digest of all pairs of kinds under some rules.
fn digest(rules: &Rules) -> u32 {
    let mut digest = 0x811c_9dc5_u32;
    pairs(|a, b, level| {
        let ground = halved(rules, EdgeKind::Terrain, &a, &b, level);
        for word in [
            ground.kind as u32,
            ground.height as u32,
            ground.bed as u32,
            ground.water as u32,
        ] {
            digest = (digest ^ word).wrapping_mul(0x0100_0193);
        }
    });
    digest
}

/// A change of any rule shows here; bless it only where it is meant.
#[test]
fn bits_are_pinned() {
    assert_eq!(digest(&Rules::default()), 3_082_032_981);
    assert_eq!(
        [Rules::PAPER, Rules::RELEASE].map(|rules| digest(&rules)),
        [2_177_214_220, 3_067_952_355]
    );
}
