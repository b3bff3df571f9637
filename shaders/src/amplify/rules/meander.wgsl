// Meanders: how a river winds about the axis of its valley.

// How much a river with a fall (Q16) winds at a vertex of a seed: 0..1 in Q15, negative where it
// crosses to the right.
fn winding(fall: i32, seed: u32, to_left: bool) -> i32 {
    let slow = Q16 - linear_step(FALL[0], FALL[1], fall);
    let drawn = mul_q16(slow, mix(LEAST_WINDING, Q16, share(seed, 30u))) / 2;
    let most = min(drawn, 0x7fff);
    return select(-most, most, to_left);
}

// A place beside the axis in grains: along it, and across to its left.
struct Beside {
    along: i32,
    across: i32,
}

// How the river of a segment winds about its axis.
struct Wander {
    // Whether it winds at all.
    is_known: bool,
    // Half-waves from end to end.
    waves: i32,
    // Half-waves that would fit with the waves of either end, Q16.
    fitting: vec2<i32>,
    // Half a wave at the ends, grains.
    half_waves: vec2<i32>,
    // Winding at the ends, Q16.
    winding: vec2<i32>,
    // Side of the first bend: 1 to the left, -1 to the right.
    side: i32,
    seed: u32,
}

// The river at a share of its axis.
struct Wave {
    // Half-waves up to there, Q16.
    phase: i32,
    // Half-waves in the length of the axis at the rate there, Q16.
    rate: i32,
    // Half a wave, grains.
    half_wave: i32,
    // Half a wave as its ends have it, grains.
    even: i32,
    // How far the belt of its bends reaches from the axis, grains.
    belt: i32,
    // How far bends reach from the axis, grains; negative where odd ones lie to the left.
    swing: i32,
    // How far they lean over, grains.
    lean: i32,
}

// The nearest point of a winding river.
struct Nearest {
    // Where it lies: share of the axis, Q16.
    along: i32,
    // The way from it, grains along and across the axis.
    off: vec3<i32>,
    // Tangent there, grains a half-wave.
    tangent: vec3<i32>,
    // Distance to it, grains.
    distance: i32,
    // Distance to the belt that its bends sweep, grains; at most that to the river.
    belt: i32,
}

// The wander of a segment with an axis of so many grains, and half-waves of a river of its width at
// its ends.
fn wander_new(segment: RiverSegment, axis: i32, half_waves: vec2<i32>) -> Wander {
    // Tides straighten a funnel.
    let winding = vec2(
        mul_q16(2 * abs(segment.winding.x), Q16 - ratio(segment.tide.x, OCTAVE)),
        mul_q16(2 * abs(segment.winding.y), Q16 - ratio(segment.tide.y, OCTAVE)),
    );
    let longest = max(half_waves.x, half_waves.y);
    let shortest = min(half_waves.x, half_waves.y);
    let is_long = axis > LONGEST_AXIS || axis / MOST_WAVES >= shortest;
    if all(winding == vec2(0)) || axis < longest || is_long {
        return Wander();
    }
    let is_right = segment.winding < vec2(0);
    let fitting = (vec2(axis) / max(half_waves >> vec2(8u), vec2(1))) << vec2(8u);
    let odd = select(0, 1, is_right.x != is_right.y);
    return Wander(
        true,
        whole_waves(fitting, odd),
        fitting,
        half_waves,
        winding,
        select(1, -1, is_right.x),
        pcg(seed_of(segment.ends[0]) ^ pcg(seed_of(segment.ends[1]))),
    );
}

// The river at a share of the axis (Q16), where the axis has `speed` grains a whole.
fn wander_wave(wander: Wander, at: i32, speed: i32) -> Wave {
    let phase = wander_phase(wander, at);
    let half_wave = mul_q16(speed, ratio(Q16, phase.y));
    let even = mix(wander.half_waves.x, wander.half_waves.y, at);
    let drawn = min(half_wave, mul_q16(even, MOST_SWING));
    let mean = mix(wander.winding.x, wander.winding.y, at);
    let uneven = mix(UNEVEN[0], UNEVEN[1], wander_unevenness(wander, phase.x));
    let winding = mul_q16(mean, uneven);
    let squared = square(winding);
    let lean = mul_q16(squared, mix(squared, Q16, LEAN[1]));
    return Wave(
        phase.x,
        phase.y,
        half_wave,
        even,
        mul_q16(even, swing_of(mean)) / 16 * BELT,
        wander.side * mul_q16(drawn, swing_of(winding)),
        mul_q16(half_wave, mul_q16(LEAN[0], lean)),
    );
}

// Half-waves up to a share of the axis, and their rate there; Q16.
fn wander_phase(wander: Wander, at: i32) -> vec2<i32> {
    let rest = Q16 - at;
    let middle = mul_q16(at, rest);
    let first = wander.fitting.x;
    let last = wander.fitting.y;
    let back = rest - at;
    let moved = 2 * wander.waves * mul_q16(centred_share(wander.seed, 0u), UNEVEN_WAVES[0]);
    let spread = 2 * wander.waves * mul_q16(centred_share(wander.seed, 1u), UNEVEN_WAVES[1]);
    let drawn = moved + mul_q16(spread, back);
    let phase = wander.waves * arith_smooth(at) + mul_q16(first, mul_q16(middle, rest))
        - mul_q16(last, mul_q16(middle, at))
        + mul_q16(drawn, 16 * square(middle));
    let rate = wander.waves * 6 * middle + mul_q16(first, mul_q16(rest, Q16 - 3 * at))
        - mul_q16(last, mul_q16(at, 2 * Q16 - 3 * at))
        + mul_q16(drawn, 32 * mul_q16(middle, back))
        - mul_q16(spread, 32 * square(middle));
    return vec2(clamp(phase, 0, wander.waves * Q16), max(rate, Q16 / 4));
}

// How narrow a bend is drawn, 0..1 in Q16; half-way at the ends of the piece.
fn wander_unevenness(wander: Wander, phase: i32) -> i32 {
    let crossing = phase >> 16u;
    let here = wander_crossing(wander, crossing);
    let next = wander_crossing(wander, crossing + 1);
    return mix(here, next, arith_smooth(phase & 0xffff));
}

fn wander_crossing(wander: Wander, crossing: i32) -> i32 {
    let is_end = crossing <= 0 || crossing >= wander.waves;
    return select(share(wander.seed, 1u + u32(crossing)), Q16 / 2, is_end);
}

// The nearest point of the river to a place beside the axis at a share of it (Q16), where the axis
// has `speed` grains a whole.
fn wander_nearest(wander: Wander, at: i32, speed: i32, place: Beside) -> Nearest {
    let first = wander_wave(wander, at, speed);
    let tried = wave_first_try(first, wander.waves, place);
    let near = wander_bounded(wander, first, tried, place);
    // Once more from there, as waves differ along the piece.
    let there = saturate(at + mul_q16(near, ratio(Q16, first.rate)));
    let moved = mul_q16(speed, there - at);
    let beside = Beside(place.along - moved, place.across);
    let wave = wander_wave(wander, there, speed);
    let way = wander_bounded(wander, wave, 0, beside);
    var along = saturate(there + mul_q16(way, ratio(Q16, wave.rate)));
    if way == -wave.phase {
        along = 0;
    } else if way == wander.waves * Q16 - wave.phase {
        along = Q16;
    }
    let off = wave_off(wave, way, beside);
    let straight = length(beside.along + moved, beside.across, 0);
    let far = smoothstep(
        mul_q16(wave.even, FAR_AWAY[0]),
        mul_q16(wave.even, FAR_AWAY[1]),
        straight,
    );
    let distance = mix(length(off.x, off.y, 0), straight, far);
    let belt = min(distance, max(straight - wave.belt, 0));
    return Nearest(along, off, wave_tangent(wave, way), distance, belt);
}

// The way to the nearest point by steps from a way, within the piece.
fn wander_bounded(wander: Wander, wave: Wave, start: i32, place: Beside) -> i32 {
    var way = start;
    for (var i = 0u; i < WANDER_STEPS; i++) {
        let moved = damped_projection(wave_tangent(wave, way), wave_off(wave, way, place));
        way = clamp(way + moved, -wave.phase, wander.waves * Q16 - wave.phase);
    }
    return way;
}

// The place of the river so many half-waves on, Q16.
fn wave_place(wave: Wave, way: i32) -> vec3<i32> {
    let phase = wave.phase + way;
    let lean = mul_q16(wave.lean, sin_turn(phase));
    let swing = mul_q16(wave.swing, sin_turn(phase >> 1u));
    return vec3(mul_q16(wave.half_wave, way) - lean, swing, 0);
}

// The best of some ways to the nearest point, in a piece of so many half-waves.
fn wave_first_try(wave: Wave, waves: i32, place: Beside) -> i32 {
    var best = 0;
    var nearest = 0x7fffffff;
    for (var k = -TRIES; k <= TRIES; k++) {
        let way = clamp(k * (Q16 / TRIES), -wave.phase, waves * Q16 - wave.phase);
        let off = wave_off(wave, way, place);
        let distance = length(off.x, off.y, 0);
        // Of equal ones the first.
        if distance < nearest {
            nearest = distance;
            best = way;
        }
    }
    return best;
}

// The vector from there to a place.
fn wave_off(wave: Wave, way: i32, place: Beside) -> vec3<i32> {
    let at = wave_place(wave, way);
    return vec3(place.along - at.x, place.across - at.y, 0);
}

// The tangent there, grains a half-wave.
fn wave_tangent(wave: Wave, way: i32) -> vec3<i32> {
    let phase = wave.phase + way;
    let lean = 2 * mul_q16(mul_q16(wave.lean, PI), cos_turn(phase));
    let swing = mul_q16(mul_q16(wave.swing, PI), cos_turn(phase >> 1u));
    return vec3(wave.half_wave - lean, swing, 0);
}

// How far bends of a winding reach from the axis, in half-waves, Q16.
fn swing_of(winding: i32) -> i32 {
    return mul_q16(SWING[0], mul_q16(winding, mix(square(winding), Q16, SWING[1])));
}

// The whole number of half-waves, odd or even, that fits best.
fn whole_waves(fitting: vec2<i32>, odd: i32) -> i32 {
    // Rather fewer: short waves have sharp bends.
    let mean = (fitting.x / 2 + fitting.y / 2) / 16 * 15;
    let pairs = (mean - odd * Q16 + Q16) >> 17u;
    let waves = 2 * pairs + odd;
    return select(2 - odd, waves, waves > 0);
}

// The sine of a phase whose whole turn is 2^16, Q16.
fn sin_turn(t: i32) -> i32 {
    return cos_turn(t - 0x4000);
}

// A seed of a place.
fn seed_of(place: vec3<i32>) -> u32 {
    return pcg(u32(place.x) ^ pcg(u32(place.y) ^ pcg(u32(place.z))));
}
