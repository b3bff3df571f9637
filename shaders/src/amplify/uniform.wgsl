// Data that all items of a level's passes have in common.

struct LevelUniform {
    // The view, and in it the planet's constants.
    sight: Sight,
    // The rules.
    rules: Rules,
    // Most vertices, edges and faces of a level, and triangles that the buffers hold.
    caps: LevelCaps,
    // The level that is split.
    level: u32,
}
