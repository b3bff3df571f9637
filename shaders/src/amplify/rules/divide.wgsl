// How far the middle of an edge rises as a divide between the drains of its ends.

// How level the ends of an edge are, Q16.
fn evenness(context: EdgeContext, slope: i32) -> i32 {
    let rise = abs(context.a.height - context.b.height);
    let even = ratio(max(slope - rise, 0), max(slope, 1));
    if context.level < FIRST_CREST_LEVEL {
        return even;
    }
    return mul_q16(even, crest_share(context, slope));
}

// How far an edge is a crest, Q16: 1 where nothing beside it stands above its middle.
fn crest_share(context: EdgeContext, slope: i32) -> i32 {
    let middle = context.a.height + (context.b.height - context.a.height) / 2;
    let x = context.beside[0];
    let y = context.beside[1];
    var highest = middle;
    if x.is_known && y.is_known {
        highest = max(x.height, y.height);
    } else if x.is_known || y.is_known {
        highest = select(y.height, x.height, x.is_known);
    }
    return Q16 - ratio(max(highest - middle, 0), max(slope / CREST_TOLERANCE, 1));
}

// How much a crest gains over the higher end in land of a tangent `steep`: a draw of the `bulge`
// (grains), bounded by the room that the crust leaves.
fn gain(context: EdgeContext, draws: RiseDraws, steep: i32, bulge: i32) -> i32 {
    let drawn = DRAWN_BULGE[0] + mul_q16(draws.xi, DRAWN_BULGE[1]);
    let free = mul_q16(
        mul_q16(bulge, divide_fading(context.level, context.new_vertex.worn)),
        drawn,
    );
    let most = room(context, steep);
    // Saturates, half-way there where the two are equal, so that summits stay apart.
    let taken = max(part(context.level, draws.chi), draws.crest);
    return mul_q16(most, mul_q16(ratio(free, free + most + 1), taken));
}

// Room between the higher end and the crust elevation, grains.
fn room(context: EdgeContext, steep: i32) -> i32 {
    let crust = context.new_vertex.crust;
    let ends = ordered(context.a.height, context.b.height);
    let relief = max(crust - ends.x, 0);
    let finer = mul_q16(context.length / RESERVE, steep);
    return max(crust - min(finer, relief / MOST_RESERVE) - ends.y, 0);
}

// Most that a crest takes of the room, between the least and the greatest draw; Q16.
fn part(level: u32, chi: i32) -> i32 {
    let bounds = PART_OF_ROOM[min(level, 3u)];
    return mix(bounds[0], bounds[1], chi);
}

// Bulges fade below the spacing of valleys, some kilometres. Q16.
fn divide_fading(level: u32, worn: i32) -> i32 {
    let kept = KEPT_BULGE[min(level, 8u)];
    if level < FIRST_WORN_LEVEL {
        return kept;
    }
    return kept - mul_q16(mul_q16(kept, worn), WORN_LOSS);
}
