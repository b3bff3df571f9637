// The place of a river that is nearest to a direction.

struct RiverPlace {
    // The river there.
    reach: Reach,
    // Where along its segment it is, Q16.
    along: i32,
    // Distance to it, grains.
    distance: i32,
    // Distance to the belt that its bends sweep, grains.
    belt: i32,
}

// The place of a segment's river that is nearest to a direction.
fn river_place_nearest(
    scale: PlanetScale,
    rules: Rules,
    segment: RiverSegment,
    direction: vec3<i32>,
) -> RiverPlace {
    let curve = river_segment_curve(segment);
    let on_axis = curve_nearest(curve, direction);
    let winds = wander(scale, rules, segment);
    var off = on_axis.off;
    var place = RiverPlace(Reach(), on_axis.share, planet_scale_grains(scale, off), 0);
    place.belt = place.distance;
    var stretch = place.distance;
    if winds.is_known {
        let axis = axis_at(scale, curve, segment, on_axis.share);
        let beside = axis_beside(axis, scale, off);
        let nearest = wander_nearest(winds, on_axis.share, axis.speed, beside);
        place.along = nearest.along;
        place.distance = nearest.distance;
        place.belt = nearest.belt;
        if is_end(place.along) {
            let way = BEYOND_END[select(0u, 1u, place.along == Q16)];
            off = stretched(nearest.off, nearest.tangent, way);
            stretch = length(off.x, off.y, 0);
        }
    } else if is_end(place.along) {
        let is_point = river_segment_is_point(segment);
        var tangent = curve_quarter_tangent(curve, place.along);
        if is_point {
            tangent = segment.headings[0] << vec3(14u);
        }
        let is_lower = place.along == Q16 || is_point;
        off = stretched(off, tangent, BEYOND_END[select(0u, 1u, is_lower)]);
        stretch = planet_scale_grains(scale, off);
    }
    place.reach = reach_at(scale, rules, segment, place.along);
    if is_end(place.along) {
        place.distance = river_place_stretch(place, stretch);
    }
    return place;
}

// Whether a share of a piece is that of an end.
fn is_end(along: i32) -> bool {
    return along == 0 || along == Q16;
}

// Another distance near the bed; away from it the true one stays.
fn river_place_stretch(place: RiverPlace, distance: i32) -> i32 {
    let bed = place.reach.half_bed;
    let is_great = bed > 0x7fffffff / 3;
    let twice = select(2 * bed, 0x7fffffff, bed > 0x3fffffff);
    let thrice = max(select(3 * bed, 0x7fffffff, is_great), 1);
    let far = smoothstep(twice, thrice, place.distance);
    if far < Q16 {
        return mix(distance, place.distance, far);
    }
    return place.distance;
}

// How the river of a segment winds.
fn wander(scale: PlanetScale, rules: Rules, segment: RiverSegment) -> Wander {
    let is_straight = all(segment.winding == vec2(0)) || river_segment_is_point(segment);
    if rules.landforms == 0u || is_straight {
        return Wander();
    }
    let axis = planet_scale_grains(scale, difference(segment.ends[1], segment.ends[0]));
    let half_waves = vec2(
        mul_q16(reach_width(scale, rules, segment.waves.x), HALF_WAVE),
        mul_q16(reach_width(scale, rules, segment.waves.y), HALF_WAVE),
    );
    return wander_new(segment, axis, half_waves);
}

// The axis of a valley at a place.
struct Axis {
    // The way up from the planet's centre.
    up: vec3<i32>,
    // A quarter of the tangent.
    tangent: vec3<i32>,
    // Length of the whole tangent, grains.
    speed: i32,
}

fn axis_at(scale: PlanetScale, curve: Curve, segment: RiverSegment, along: i32) -> Axis {
    let tangent = curve_quarter_tangent(curve, along);
    let quarter = planet_scale_grains(scale, tangent);
    let speed = select(4 * quarter, 0x7fffffff, quarter > 0x1fffffff);
    return Axis(segment.ends[0], tangent, speed);
}

// A vector from there in the axis's frame.
fn axis_beside(axis: Axis, scale: PlanetScale, off: vec3<i32>) -> Beside {
    let along = share_along(axis.tangent, off);
    let aside = off - weigh3(along, axis.tangent);
    let distance = planet_scale_grains(scale, aside);
    return Beside(
        mul_q16(axis.speed / 4, along),
        select(-distance, distance, is_left(axis.up, axis.tangent, aside)),
    );
}

// A vector whose part along a tangent counts by a share of its length, Q16.
fn stretched(off: vec3<i32>, tangent: vec3<i32>, way: i32) -> vec3<i32> {
    return off + weigh3(mul_q16(share_along(tangent, off), way - Q16), tangent);
}
