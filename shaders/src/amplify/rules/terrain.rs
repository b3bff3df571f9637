//! (t, T, t): the ground between two vertices of dry land (paper 002 Fig. 10, Appendix A; rule R5).
//!
//! Print and release: all nodes of Appendix A, which are mountains young and old blended by age and
//! wetness, terraces on dry rock, peaks at the coarse levels and hills; and plateaus. Ours: the
//! common rise of all slopes ([`rise`]) in place of mountains and peaks.

use super::landform::Landform;
use super::preset::Rules;
use super::{VertexGround, nodes, rise};
use crate::amplify::arith::{
    linear_step, mix, mul_q16, ordered, ratio, saturate, smooth, smoothstep, sqrt_q16, square,
};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{ONE, Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, FAR, Vertex};

/// Crust elevation at which peaks are full, grains.
const FULL_CRUST: i32 = metres(5_000);

/// Least tangent that bounds hills in ours: that of 8.5°, in lands of hills alone.
const LEAST_HILL_SLOPE: i32 = q16(0.15);

/// The bound is that tangent's rise over this part of an edge in ours.
const OUR_HILL_LIMIT: i32 = 64;

/// Lowest terrace of old land that is barely dry, grains (release).
const LOWEST_TERRACE: i32 = metres(3_700);

/// How much lower terraces begin where land is dry and young, grains (release).
const DESERT_TERRACES: i32 = metres(4_000);

/// How much of that old land takes back, grains (release).
const OLD_TERRACES: i32 = metres(2_800);

/// How much lower terraces begin at the poles, grains (release); in ours latitude counts through
/// the climate alone.
const POLAR_TERRACES: i32 = metres(2_200);

/// Heights over which the lowest terrace sets in, grains (release).
const TERRACE_ONSET: i32 = metres(250);

/// The same in ours.
const OUR_TERRACE_ONSET: i32 = metres(256);

/// Heights over which terraces' edges lose their raggedness, grains (release).
const RAGGED_HEIGHTS: [i32; 2] = [metres(2_000), metres(2_800)];

/// Added to the height of every peak, grains (release).
const PEAK_BASE: i32 = metres(10);

/// Most rise of peaks' feet over the lower end, under no crust, and how much full crust adds to it,
/// grains (release).
const PEAK_RISE: [i32; 2] = [metres(70), metres(600)];

/// Least height of hilly ground, grains (release).
const LEAST_HILLY: i32 = metres(1);

/// Dryness from which on there are no hills (release).
const DRIEST_HILLS: i32 = q16(0.1);

/// The same in ours.
const OUR_DRIEST_HILLS: i32 = q16(0.9);

/// Distance from a river at which hills are full, grains (release).
const HILLS_AWAY: i32 = metres(25_000);

crate::wgsl::shared!(
    FULL_CRUST,
    LEAST_HILL_SLOPE,
    OUR_HILL_LIMIT,
    LOWEST_TERRACE,
    DESERT_TERRACES,
    OLD_TERRACES,
    POLAR_TERRACES,
    TERRACE_ONSET,
    OUR_TERRACE_ONSET,
    RAGGED_HEIGHTS,
    PEAK_BASE,
    PEAK_RISE,
    LEAST_HILLY,
    DRIEST_HILLS,
    OUR_DRIEST_HILLS,
    HILLS_AWAY,
);

/// The ground in the middle of a (t, T, t) edge.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context))
}

/// Height in the middle of a (t, T, t) edge, grains.
pub fn height(rules: &Rules, context: &EdgeContext) -> i32 {
    if rules.landforms {
        return shaped(rules, context);
    }
    let new = context.new;
    let form = Landform::of(rules, new);
    let mountain = mountain(rules, context, form);
    let lowest = lowest_terrace(form) - mul_q16(polar(new), POLAR_TERRACES);
    let onset = [lowest, lowest + TERRACE_ONSET];
    let terraced = terraced(rules, context, form, onset, mountain);
    let fading = peak_fading(new.crust, context.level);
    let low = context.a.height.min(context.b.height);
    let raised = peaks(new, form, low, terraced, fading);
    let hilly = (raised + hills(rules, context, form, fading)).max(LEAST_HILLY);
    // A plateau has no peaks and no hills.
    nodes::plateau(hilly, terraced, i32::from(new.plateau))
}

/// Ours: the common rise, then terraces on dry rock, hills no steeper than a few degrees, and
/// plateaus. It stays above its lower end, so that it drains there, and under the crust.
fn shaped(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    let form = Landform::of(rules, new);
    let (low, high) = ordered(context.a.height, context.b.height);
    let risen = rise::divide(rules, context);
    let lowest = lowest_terrace(form);
    let onset = [lowest, lowest + OUR_TERRACE_ONSET];
    let terraced = terraced(rules, context, form, onset, risen);
    // Hills must not overturn the slope they stand on.
    let limit = mul_q16(context.length, form.steep.max(LEAST_HILL_SLOPE)) / OUR_HILL_LIMIT;
    let fading = peak_fading(new.crust, context.level);
    // Or vertices would lose their way down.
    let hills = if context.is_descent {
        0
    } else {
        hills(rules, context, form, fading).clamp(0, limit)
    };
    let hilly = terraced + hills;
    let level = nodes::plateau(hilly, low + (high - low) / 2, i32::from(new.plateau));
    level.min(high.max(new.crust)).max(low + 1)
}

/// Classic mountains: young and old, wet and dry.
fn mountain(rules: &Rules, context: &EdgeContext, form: Landform) -> i32 {
    let delta = nodes::scale_dependency(context.level);
    let xi = share(context.new.seed, 0);
    let young = nodes::young(rules.form, delta, xi);
    let old = mix(
        nodes::old_wet(delta, xi),
        nodes::old_dry(delta, xi),
        form.dry,
    );
    // Age shows less on fine levels.
    let aged = mul_q16(form.old, Q16 - level_share(context.level));
    let alpha = saturate(mix(young, old, aged));
    nodes::between(context.a.height, context.b.height, alpha)
}

/// The release's nl: level / 10, at most 1; Q16.
const fn level_share(level: u32) -> i32 {
    (if level < 10 { level as i32 } else { 10 }) * Q16 / 10
}

/// Steps of 700 m on dry old rock, which set in over the heights of `onset`.
fn terraced(
    rules: &Rules,
    context: &EdgeContext,
    form: Landform,
    onset: [i32; 2],
    height: i32,
) -> i32 {
    if form.dry == 0 || form.old == 0 {
        return height;
    }
    let weight = mul_q16(
        mul_q16(form.old, Q16 - square(level_share(context.level))),
        mul_q16(sqrt_q16(form.dry), linear_step(onset[0], onset[1], height)),
    );
    // Treads with smooth risers; at low heights a draw takes vertices back towards their tread,
    // which makes ragged edges.
    let stepped = nodes::terrace(height, nodes::TERRACE_STEP);
    let tread = nodes::floor_to(height, nodes::TERRACE_STEP);
    let at = if rules.landforms { height } else { stepped };
    let low = Q16 - smoothstep(RAGGED_HEIGHTS[0], RAGGED_HEIGHTS[1], at);
    // Nine tenths of the way at most: some of the riser stays.
    let ragged = mul_q16(share(context.new.seed, 1), low) / 10 * 9;
    mix(height, mix(stepped, tread, ragged), weight)
}

/// Height at which terraces begin: lower in deserts and in youth; grains.
fn lowest_terrace(form: Landform) -> i32 {
    LOWEST_TERRACE - mul_q16(form.dry, DESERT_TERRACES - mul_q16(form.old, OLD_TERRACES))
}

/// The squared sine of a vertex's latitude, Q16.
const fn polar(vertex: &Vertex) -> i32 {
    square(ratio(vertex.direction[2].saturating_abs(), ONE))
}

/// How far peaks and hills have faded at a level, 0..1 Q16: later under low crust.
fn peak_fading(crust: i32, level: u32) -> i32 {
    let low = Q16 - linear_step(0, FULL_CRUST, crust);
    // Over six levels under crust of 5 km, over nine under the lowest.
    let span = 6 * Q16 + 3 * low;
    smooth(smoothstep(0, span, level as i32 * Q16))
}

/// Peaks pull the ground of coarse levels towards their own height under the crust elevation. On no
/// level does it lie below its lower end.
fn peaks(new: &Vertex, form: Landform, low: i32, height: i32, fading: i32) -> i32 {
    let xi = share(new.seed, 2);
    let old = mix(
        nodes::peak_old_wet(xi, new.crust),
        nodes::peak_old_dry(xi, new.crust),
        form.dry,
    );
    let peak = mix(nodes::peak_young(xi, new.crust), old, form.old) + PEAK_BASE;
    let rise = PEAK_RISE[0] + mul_q16(linear_step(0, FULL_CRUST, new.crust), PEAK_RISE[1]);
    let foot = low + mul_q16(mul_q16(rise, share(new.seed, 5)), Q16 - fading);
    mix(peak, height, fading).max(foot)
}

/// Hills, away from rivers and deserts; an offset in grains.
fn hills(rules: &Rules, context: &EdgeContext, form: Landform, fading: i32) -> i32 {
    let new = context.new;
    let is_bare = if rules.landforms {
        form.dry > OUR_DRIEST_HILLS
    } else {
        form.dry >= DRIEST_HILLS
    };
    if new.hills == 0 || is_bare {
        return 0;
    }
    let away = if new.river_distance >= FAR {
        Q16
    } else {
        smoothstep(0, HILLS_AWAY, new.river_distance)
    };
    let (xi, chi) = (share(new.seed, 3), share(new.seed, 4));
    let offset = nodes::hill(rules.form, xi, chi, context.length, i32::from(new.hills));
    mul_q16(mul_q16(offset, Q16 - fading), away)
}
