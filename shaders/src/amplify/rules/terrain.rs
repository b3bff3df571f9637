//! (t, T, t): the ground between two vertices of dry land (paper 002 Fig. 10, Appendix A; rule R5).
//!
//! Print and release: mountains young and old blended by age and wetness, terraces on dry rock,
//! peaks at the coarse levels, hills, plateau. Ours: what the graphs of slopes share ([`rise`]) in
//! place of mountains and peaks.

use super::super::arith::{
    linear_step, mix, mul_q16, saturate, smooth, smoothstep, sqrt_q16, square,
};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::{EdgeContext, FAR, Vertex};
use super::landform::Landform;
use super::nodes;
use super::preset::Rules;
use super::{VertexGround, rise};

/// 5 km, the crust elevation at which peaks are full.
const FULL_CRUST: i32 = 5_000 * GRAINS;

/// The ground in the middle of a (t, T, t) edge.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context))
}

/// Its height, grains.
pub fn height(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    if rules.landforms {
        return shaped(rules, context);
    }
    let form = Landform::of(rules, new);
    let (low, high) = ordered(context.a.height, context.b.height);
    let mountain = mountain(rules, context, form, low, high);
    let terraced = terraced(new, form, context.level, mountain);
    let fading = peak_fading(new.crust, context.level);
    let raised = peaks(new, form, low, terraced, fading);
    let hilly = raised + hills(rules, context, form, fading);
    let base = low + (high - low) / 2;
    nodes::plateau(hilly, base, i32::from(new.plateau))
}

/// Ours: the common rise, then terraces on dry rock, hills no steeper than a few degrees, and
/// plateaus. It stays above its lower end, so that it drains there, and under the crust.
fn shaped(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    let form = Landform::of(rules, new);
    let (low, high) = ordered(context.a.height, context.b.height);
    let terraced = terraced(
        new,
        form,
        context.level,
        rise::height(rules, context, 90_000),
    );
    // tan 8.5° = 0.15 in lands of hills alone.
    let limit = mul_q16(context.length, form.steep.max(9_830)) / 4;
    let hill =
        hills(rules, context, form, peak_fading(new.crust, context.level)).clamp(-limit, limit);
    let level = nodes::plateau(
        terraced + hill,
        low + (high - low) / 2,
        i32::from(new.plateau),
    );
    level.min(high.max(new.crust)).max(low + 1)
}

/// Lower and higher of two.
#[inline]
pub(super) const fn ordered(a: i32, b: i32) -> (i32, i32) {
    if a < b { (a, b) } else { (b, a) }
}

/// Classic mountains: young and old, wet and dry.
fn mountain(rules: &Rules, context: &EdgeContext, form: Landform, low: i32, high: i32) -> i32 {
    let delta = nodes::scale_dependency(context.level);
    let xi = share(context.new.seed, 0);
    let young = nodes::young(rules.form, delta, xi);
    let old = mix(
        nodes::old_wet(delta, xi),
        nodes::old_dry(delta, xi),
        form.dry,
    );
    let late = mul_q16(form.old, Q16 - level_share(context.level));
    let alpha = saturate(mix(young, old, late));
    mix(low, high, alpha)
}

/// The release's nl: level / 10, at most 1; Q16.
const fn level_share(level: u32) -> i32 {
    (if level < 10 { level as i32 } else { 10 }) * Q16 / 10
}

/// Steps of 700 m on dry old rock, where the land is high enough.
fn terraced(new: &Vertex, form: Landform, level: u32, height: i32) -> i32 {
    if form.dry == 0 || form.old == 0 {
        return height;
    }
    let share_of_level = level_share(level);
    // Lowest terrace: 3.7 km, lower in deserts and in youth.
    let least = 3_788_800 - mul_q16(form.dry, 4_096_000 - mul_q16(form.old, 2_867_200));
    let room = linear_step(least, least + 256 * GRAINS, height);
    let weight = mul_q16(
        mul_q16(form.old, Q16 - square(share_of_level)),
        mul_q16(sqrt_q16(form.dry), room),
    );
    let stepped = nodes::terrace(height, nodes::TERRACE_STEP);
    let raw = nodes::floor_to(height, nodes::TERRACE_STEP);
    let ragged = mul_q16(
        share(new.seed, 1),
        Q16 - smoothstep(2_000 * GRAINS, 2_800 * GRAINS, height),
    ) / 10
        * 9;
    mix(height, mix(stepped, raw, ragged), weight)
}

/// How far peaks and hills have faded at a level, 0..1 Q16: later under low crust.
fn peak_fading(crust: i32, level: u32) -> i32 {
    let low = Q16 - linear_step(0, FULL_CRUST, crust);
    let span = 6 * Q16 + 3 * low;
    smooth(smoothstep(0, span, level as i32 * Q16))
}

/// Peaks pull the ground of coarse levels towards their own height under the crust elevation.
fn peaks(new: &Vertex, form: Landform, low: i32, height: i32, fading: i32) -> i32 {
    if fading >= Q16 || new.crust <= 0 {
        return height;
    }
    let xi = share(new.seed, 2);
    let old = mix(
        nodes::peak_old_wet(xi, new.crust),
        nodes::peak_old_dry(xi, new.crust),
        form.dry,
    );
    let peak = mix(nodes::peak_young(xi, new.crust), old, form.old) + 10 * GRAINS;
    let rise = 72 * GRAINS + mul_q16(linear_step(0, FULL_CRUST, new.crust), 614 * GRAINS);
    // No more than a tenth of the crust above the lower end, so that plains stay plain.
    let rise = rise.min(new.crust / 8);
    let floor = low + mul_q16(mul_q16(rise, xi), Q16 - fading);
    mix(peak, height, fading).max(floor)
}

/// Hills, away from rivers and deserts.
fn hills(rules: &Rules, context: &EdgeContext, form: Landform, fading: i32) -> i32 {
    let new = context.new;
    if new.hills == 0 || form.dry > 58_982 {
        return 0;
    }
    let away = if new.river_distance >= FAR {
        Q16
    } else {
        smoothstep(0, 25_000 * GRAINS, new.river_distance)
    };
    let xi = share(new.seed, 3);
    let chi = share(new.seed, 4);
    let offset = nodes::hill(rules.form, xi, chi, context.length, i32::from(new.hills));
    mul_q16(mul_q16(offset, Q16 - fading), away)
}
