// The row of a vertex that the passes of the topology read.

// Where a vertex is, how high, its seed and its water.
struct VertexCore {
    // Unit direction from the planet's centre, each component times ONE.
    direction: vec3<i32>,
    // Ground above sea level before carving, grains.
    height: i32,
    // Seed of its random numbers.
    seed: u32,
    // River bed or lake floor, grains.
    bed: i32,
    // Water surface, grains.
    water: i32,
    // Discharge in 2^-32 of 200,000 m3/s.
    discharge: u32,
}
