//! R5 as a whole: Fig. 10 and Appendix A.

use super::*;
use VertexKind::Terrain;

/// Height of a terrace's step.
const STEP_M: f64 = 700.0;

/// The land in the middle of an edge, 0..1.
struct RealLand {
    /// 0 wet, 1 dry.
    dry: f64,
    /// 0 young, 1 old.
    old: f64,
    /// min(λ, 10) / 10.
    level: f64,
    /// How far peaks and hills have faded.
    faded: f64,
    /// Crust elevation over 5 km.
    high: f64,
}

impl RealLand {
    fn of(edge: &RealEdge) -> Self {
        let maps = edge.ends[0];
        let dry = 1.0 - smoothstep(0.15, 0.45, f64::from(maps.wetness) / 65_536.0);
        let worn = f64::from(maps.worn) / 65_536.0;
        let high = (edge.crust() / m(5_000.0)).clamp(0.0, 1.0);
        let fading = smoothstep(0.0, 6.0 + 3.0 * (1.0 - high), f64::from(edge.level));
        Self {
            dry,
            old: (worn + 0.38 * dry).min(1.0),
            level: f64::from(edge.level.min(10)) / 10.0,
            faded: smoothstep(0.0, 1.0, fading),
            high,
        }
    }
}

/// Classic mountains.
fn mountain(edge: &RealEdge, land: &RealLand) -> f64 {
    let [low, high] = edge.ordered();
    let (xi, delta) = (edge.xi(0), 1.0 - 0.4 * land.level);
    let power = xi * xi.sqrt();
    let young = match edge.rules.form {
        nodes::Form::Paper => 0.5 + delta / 2.0 * (power - 1.0),
        nodes::Form::Release => 0.5 + delta * (power - 0.5),
    };
    let old_dry = 0.5 + 0.4 * delta * (xi - 1.0);
    let old_wet = 1.0 + 0.6 * delta * (xi - 1.0);
    let old = mix(old_wet, old_dry, land.dry);
    mix(low, high, mix(young, old, land.old * (1.0 - land.level)))
}

/// Terraced mountains.
fn terraced(edge: &RealEdge, land: &RealLand, height: f64) -> f64 {
    let step = m(STEP_M);
    let tread = (height / step).floor() * step;
    let stepped = tread + smoothstep(0.0, step, height - tread) * step;
    let low = 1.0 - smoothstep(m(2_000.0), m(2_800.0), stepped);
    let ragged = mix(stepped, tread, 0.9 * edge.xi(1) * low);
    let sine = f64::from(edge.ends[0].direction[2]) / f64::from(ONE);
    let rock =
        m(3_700.0) - m(2_200.0) * sine * sine - m(4_000.0) * land.dry * (1.0 - 0.7 * land.old);
    let onset = ((height - rock) / m(250.0)).clamp(0.0, 1.0);
    let weight = land.old * (1.0 - land.level * land.level) * land.dry.sqrt() * onset;
    mix(height, ragged, weight)
}

/// Peaks.
fn peaked(edge: &RealEdge, land: &RealLand, height: f64) -> f64 {
    let (xi, crust) = (edge.xi(2), edge.crust());
    let old = mix((1.0 - xi * xi) * crust, xi * crust, land.dry);
    let peak = mix(xi * xi * crust, old, land.old) + m(10.0);
    let rise = edge.xi(5) * (m(70.0) + m(600.0) * land.high);
    let foot = edge.ordered()[0] + (1.0 - land.faded) * rise;
    mix(peak, height, land.faded).max(foot)
}

/// Offset of hills.
fn hills(edge: &RealEdge, land: &RealLand) -> f64 {
    let maps = edge.ends[0];
    if land.dry >= 0.1 {
        return 0.0;
    }
    let down = match edge.rules.form {
        nodes::Form::Paper => -1.0 / 3.0,
        nodes::Form::Release => -0.3,
    };
    let (xi, chi) = (edge.xi(3), edge.xi(4));
    let epsilon = edge.length() * if chi < 0.5 { down } else { 1.0 };
    let offset = ((1.0 - xi * xi) / 2.0 * epsilon).min(m(800.0));
    let away = smoothstep(0.0, m(25_000.0), f64::from(maps.river_distance));
    offset * f64::from(maps.hills) / 65_536.0 * (1.0 - land.faded) * away
}

/// Whether a rule jumps so near that a rounding decides: the floor of a step, and bare rock.
fn is_at_a_jump(land: &RealLand, mountain: f64) -> bool {
    let off = mountain.rem_euclid(m(STEP_M));
    off.min(m(STEP_M) - off) < m(1.0) || (land.dry - 0.1).abs() < 0.001
}

/// Mountains, terraces, peaks, hills and plateaus, one after the other.
#[test]
fn open_ground_is_the_closed_form() {
    let mut skipped = 0;
    for rules in PRESETS {
        for seed in 0..20_000 {
            let [a, b] = pair(seed, [Terrain, Terrain]);
            let level = seed % rules.fine_level;
            let edge = RealEdge {
                rules: &rules,
                ends: [&a, &b],
                level,
            };
            let land = RealLand::of(&edge);
            let mountain = mountain(&edge, &land);
            if is_at_a_jump(&land, mountain) {
                skipped += 1;
                continue;
            }
            let terraced = terraced(&edge, &land, mountain);
            let hilly = peaked(&edge, &land, terraced) + hills(&edge, &land);
            let want = mix(hilly.max(m(1.0)), terraced, 0.88 * edge.plateau());
            let got = f64::from(halved(&rules, EdgeKind::Terrain, &a, &b, level).height);
            assert!(
                (got - want).abs() < m(1.5),
                "{rules:?} {level} {seed}: {got}, not {want}"
            );
        }
    }
    assert!(skipped < 400, "{skipped}");
}

/// Where the print's young mountains lie below the middle, the release's span the whole way.
#[test]
fn young_mountains_differ_between_print_and_release() {
    for seed in 0..1_000 {
        let [a, b] = pair(seed, [Terrain, Terrain]).map(|v| Vertex {
            worn: 0,
            wetness: u16::MAX,
            plateau: u16::MAX,
            hills: 0,
            ..v
        });
        let [paper, release] =
            PRESETS.map(|rules| halved(&rules, EdgeKind::Terrain, &a, &b, 9).height);
        // The plateau holds 0.88 of them, the rest has faded peaks.
        let slack = (a.height.abs_diff(b.height) / 100).max(a.crust as u32 / 100) as i32;
        assert!(paper <= release + slack, "{paper} {release}");
        assert!(paper <= a.height / 2 + b.height / 2 + slack);
    }
}
