//! The control mesh: the last CPU stage of a planet and the only input of the amplifier.
//!
//! An irregular triangulation of the sphere with edges of about 52 km on an Earth-sized planet
//! (paper 002 §4, Fig. 5). Its vertices carry the control maps C, A, W, P, B (§3) and the river
//! network (§4) in integers, so that every machine starts from the same bits. Units are those of
//! [`crate::amplify::fixed`].

/// One vertex of the control mesh, 64 bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct ControlVertex {
    /// Unit direction from the planet's centre, each component times `ONE`.
    pub direction: [i32; 3],
    /// Seed of the vertex's random numbers.
    pub seed: u32,
    /// Ground above sea level, grains.
    pub height: i32,
    /// River bed or lake floor, grains; equals `height` at dry vertices.
    pub bed: i32,
    /// Water surface, grains: the sea's is 0, a lake's the same at all its vertices. Equals `bed`
    /// at dry vertices.
    pub water: i32,
    /// Flow φ = sqrt(discharge / 200,000 m³/s), at most 1; Q16. 0 at dry vertices.
    pub flow: u32,
    /// Crust elevation C above sea level, grains: the level that summits reach.
    pub crust: i32,
    /// [`VertexKind`] as a number.
    pub kind: u8,
    /// [`ValleyShape`] as a number.
    pub valley: u8,
    /// How far age has worn the land (A), Q16: 0 right after an orogeny, 1 from 200 My on and where
    /// none ever was. A share, not an age: it has means, and so land has a middle between a young
    /// belt and ground without one.
    pub worn: u16,
    /// Share of continental collision (Himalayan, 1) against subduction (Andean, 0) in the orogeny,
    /// Q16.
    pub collision: u16,
    /// Wetness W, Q16.
    pub wetness: u16,
    /// Plateau presence P, Q16.
    pub plateau: u16,
    /// Hill presence B, Q16.
    pub hills: u16,
    /// Share of oceanic crust, Q16: blends the rules of land and of the ocean floor.
    pub oceanic: u16,
    /// Age of the ocean floor, 1/64 My.
    pub ocean_age: u16,
    /// Fold direction f (undirected, tangent), components times 32767; zero where there is none.
    pub fold: [i16; 3],
    /// Ridge direction r of the ocean floor (undirected, tangent), components times 32767; zero
    /// where there is none.
    pub ridge: [i16; 3],
}

const _: () = assert!(size_of::<ControlVertex>() == 64);

/// Kind of a vertex (paper 002 Table 1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum VertexKind {
    /// Dry land.
    #[default]
    Terrain = 0,
    /// Below the sea.
    Sea = 1,
    /// At the shore: its ground lies near sea level, on either side of it.
    Coast = 2,
    /// On a river.
    River = 3,
    /// In a lake.
    Lake = 4,
    /// On a dry drainage line.
    Gully = 5,
}

impl VertexKind {
    /// The kind with this number; [`VertexKind::Terrain`] for a number that has none.
    pub const fn from_number(number: u8) -> Self {
        match number {
            1 => Self::Sea,
            2 => Self::Coast,
            3 => Self::River,
            4 => Self::Lake,
            5 => Self::Gully,
            _ => Self::Terrain,
        }
    }
}

/// How the sides of a valley rise from its river (the paper's archetype e_r); `rules::valley` has
/// the curves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum ValleyShape {
    /// V: rivers that cut faster than their slopes retreat, in young mountains.
    #[default]
    V = 0,
    /// A flat floor between even slopes: old and low land.
    FlatFloor = 1,
    /// U: troughs of ice, flat below and steep above.
    IceTrough = 2,
    /// Two risers with a terrace between them: canyons of plateaus.
    Terraced = 3,
}

impl ValleyShape {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 4] = [Self::V, Self::FlatFloor, Self::IceTrough, Self::Terraced];

    /// The shape with this number; numbers repeat after four.
    pub const fn from_number(number: u8) -> Self {
        match number & 3 {
            0 => Self::V,
            1 => Self::FlatFloor,
            2 => Self::IceTrough,
            _ => Self::Terraced,
        }
    }
}

/// One edge of the control mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct ControlEdge {
    /// Its ends; a river runs from the first to the second. The direction of an edge of the ground is
    /// part of the planet, too: draws that choose a side of the edge count from it.
    pub vertices: [u32; 2],
    /// The faces on both sides; the first has the edge in its winding direction.
    pub faces: [u32; 2],
    /// 1 for a river edge, 0 for terrain.
    pub river: u32,
}

/// One face, counter-clockwise from outside. `edges[i]` joins `vertices[i]` and `vertices[(i + 1) %
/// 3]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct ControlFace {
    /// Its corners.
    pub vertices: [u32; 3],
    /// Its edges.
    pub edges: [u32; 3],
}

/// The control mesh of one planet.
///
/// ```
/// use pangaea_shaders::amplify::control::VertexKind;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let mesh = control_mesh(6_371_000, 5, 1);
/// let river = mesh.edges.iter().find(|edge| edge.river == 1).expect("a river");
/// let [upper, _] = river.vertices.map(|v| &mesh.vertices[v as usize]);
/// assert_ne!(upper.kind, VertexKind::Terrain as u8);
/// assert!(upper.flow > 0 && upper.water >= upper.bed);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ControlMesh {
    /// Radius of the planet at sea level, metres; there is ground for 50,000 to 10,000,000.
    pub radius_m: u32,
    /// Vertices.
    pub vertices: Vec<ControlVertex>,
    /// Edges.
    pub edges: Vec<ControlEdge>,
    /// Faces.
    pub faces: Vec<ControlFace>,
}
