// The procedural nodes of the compute graphs: mountains young and old, peaks, terraces, hills,
// plateaus.

// How much a level counts, Q16: 1 at level 0, 0.6 from level 10 on.
fn scale_dependency(level: u32) -> i32 {
    return Q16 - (i32(min(level, 10u)) * 4 * Q16 + 50) / 100;
}

// The blend of a young mountain, Q16: 1/2 + D/2 (x^1.5 - 1) as printed, 1/2 + D (x^1.5 - 1/2) as
// released.
fn young(form: u32, delta: i32, xi: i32) -> i32 {
    let power = pow_1_5(xi);
    if form == FORM_PAPER {
        return Q16 / 2 + mul_q16(delta, power - Q16) / 2;
    }
    return Q16 / 2 + mul_q16(delta, power - Q16 / 2);
}

// The blend of an old mountain of a dry land, Q16: 1/2 + 2D/5 (x - 1).
fn old_dry(delta: i32, xi: i32) -> i32 {
    return Q16 / 2 + mul_q16(2 * delta, xi - Q16) / 5;
}

// The blend of an old mountain of a wet land, Q16: 1 + 3D/5 (x - 1).
fn old_wet(delta: i32, xi: i32) -> i32 {
    return Q16 + mul_q16(3 * delta, xi - Q16) / 5;
}

// Peak of a young mountain under the crust elevation C: x^2 C.
fn peak_young(xi: i32, crust: i32) -> i32 {
    return mul_q16(crust, square(xi));
}

// Peak of an old mountain of a dry land: x C.
fn peak_old_dry(xi: i32, crust: i32) -> i32 {
    return mul_q16(crust, xi);
}

// Peak of an old mountain of a wet land: (1 - x^2) C.
fn peak_old_wet(xi: i32, crust: i32) -> i32 {
    return mul_q16(crust, Q16 - square(xi));
}

// Terraces: treads at multiples of `step_height`, Hermite risers between them.
fn terrace(height: i32, step_height: i32) -> i32 {
    let tread = floor_to(height, step_height);
    return tread + mul_q16(step_height, arith_smooth(ratio(height - tread, step_height)));
}

// The largest multiple of `step_height` not above a height.
fn floor_to(height: i32, step_height: i32) -> i32 {
    let down = height % step_height;
    return height - down - select(0, step_height, down < 0);
}

// Offset of hills: min(800 m, (1 - x^2)/2 e) B, e the edge's length, or below a half of the other
// draw a third (printed) or 0.3 (released) of it downwards.
fn hill(form: u32, xi: i32, chi: i32, length: i32, presence: i32) -> i32 {
    var epsilon = length;
    if chi < Q16 / 2 {
        epsilon = select(-mul_q16(length, HOLLOWS), -(length / 3), form == FORM_PAPER);
    }
    let offset = mul_q16(epsilon, Q16 - square(xi)) / 2;
    return mul_q16(min(offset, HILL_LIMIT), presence);
}

// A plateau holds a height at its base level.
fn plateau(height: i32, base: i32, presence: i32) -> i32 {
    return mix(height, base, mul_q16(saturate(presence), PLATEAU_HOLD));
}

// The draw of a slope: x, on plateaus 1 less a power of it.
fn cliff(xi: i32, power: i32, presence: i32) -> i32 {
    return mix(xi, Q16 - power, presence);
}

// A height between two others, whichever of them is the higher.
fn nodes_between(a: i32, b: i32, alpha: i32) -> i32 {
    let ends = ordered(a, b);
    return mix(ends.x, ends.y, alpha);
}
