// The numbers of the rules.

// Constants of the subdivision rules. Shares and tangents are Q16, heights and lengths grains.
struct Rules {
    // Form of the young mountains' blend and of the hills.
    form: u32,
    // Whether crests and slopes follow the landform's own steepness.
    landforms: u32,
    // Rise of a crest over the higher river, per length of the edge halved.
    crest_rise: i32,
    // Tangent of the slopes of a young belt of continental collision.
    steep_collision: i32,
    // Tangent of the slopes of a young belt of subduction.
    steep_subduction: i32,
    // Tangent of the slopes of old land.
    steep_old: i32,
    // Levels whose river edges fall more on their first half: first and one beyond the last.
    hollow_levels: vec2<u32>,
    // Share of its fall that a river edge of those levels has on its first half.
    hollow_fall: i32,
    // First level whose halving is that of fine ground.
    fine_level: u32,
    // Levels of internal edges that may become tributaries, first and one beyond the last.
    tributary_levels: vec2<u32>,
    // One beyond the last level on which a tributary's edge goes on above its new spring.
    extension_levels: u32,
    // One beyond the last level of internal edges that may become gullies.
    gully_levels: u32,
    // Chance that an eligible internal edge becomes a gully off a gully.
    gully_branching: i32,
    // One beyond the last level on which lakes form.
    lake_levels: u32,
    // Chance of a lake where water abounds.
    lake_chance: i32,
    // Rise of a tributary along its first half, tangent.
    spring_slope: i32,
    // Width of a river in metres at a discharge of 1 m3/s on an Earth-sized planet, Q16.
    channel_width: i32,
    // Whether valleys are shaped by their archetype's curve.
    archetypes: u32,
}
