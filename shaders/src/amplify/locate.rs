//! The face that a direction lies in. On the CPU alone, in f64: it chooses a face, and changes no
//! bit of it.

use super::control::ControlMesh;
use super::topology::{Face, LevelMesh, NONE, gather};
use super::vertex::Vertex;

/// Cells along an edge of the cube: 24,576 in all, for about twenty faces each of a planet's
/// control mesh.
const CELLS: usize = 64;

/// Steps after which a walk across edges is given up: it would end in any Delaunay triangulation,
/// but a mesh need not be one.
const MOST_STEPS: u32 = 4096;

/// A face near every cell of a cube around the sphere, to start walking from.
#[derive(Clone, Debug)]
pub struct FaceIndex {
    starts: Vec<u32>,
}

impl FaceIndex {
    /// Indexes the faces of the control mesh.
    pub fn new(mesh: &ControlMesh) -> Self {
        let mut starts = vec![NONE; 6 * CELLS * CELLS];
        let mut last = (NONE, 0);
        for (i, face) in (0..).zip(&mesh.faces) {
            // Faces of one first corner mostly follow each other.
            let corner = face.vertices[0];
            if corner != last.0 {
                last = (corner, cell(mesh.vertices[corner as usize].direction));
            }
            // Which of a cell's faces is taken does not matter: the walk ends in the same face.
            starts[last.1] = i;
        }
        // A cell without a corner takes the face of the last one that has one.
        let mut last = 0;
        for start in &mut starts {
            if *start == NONE {
                *start = last;
            }
            last = *start;
        }
        Self { starts }
    }

    /// The face of the indexed mesh that a direction lies in; `hint` is a face likely to be near.
    pub fn locate(
        &self,
        level: &LevelMesh,
        vertices: &[Vertex],
        direction: [i32; 3],
        hint: Option<u32>,
    ) -> u32 {
        let mut at = hint
            .filter(|&f| (f as usize) < level.faces.len())
            .unwrap_or(self.starts[cell(direction)]);
        for _ in 0..MOST_STEPS {
            let face = &level.faces[at as usize];
            let sides = sides(direction, gather(vertices, face.vertices));
            // Across the edge that the direction lies farthest beyond.
            let worst = least(sides);
            if sides[worst] >= 0.0 {
                return at;
            }
            at = level.edges[face.edges[worst] as usize].beyond(at);
        }
        locate_slowly(&level.faces, vertices, direction)
    }
}

/// The index of the least of three numbers, of equal ones the first.
fn least(of: [f64; 3]) -> usize {
    (0..3).min_by(|&i, &j| of[i].total_cmp(&of[j])).unwrap_or(0)
}

/// The face in which a direction lies deepest, of those whose first corner is on its side of the
/// planet.
fn locate_slowly(faces: &[Face], vertices: &[Vertex], direction: [i32; 3]) -> u32 {
    let corners = |f: &Face| gather(vertices, f.vertices);
    let depth_in = |f: &Face| depth(sides(direction, corners(f)));
    (0..)
        .zip(faces)
        .filter(|(_, f)| is_ahead(direction, corners(f)[0]))
        .max_by(|(_, f), (_, g)| depth_in(f).total_cmp(&depth_in(g)))
        .map_or(0, |(i, _)| i)
}

/// Whether a vertex is on a direction's side of the planet.
fn is_ahead(direction: [i32; 3], vertex: &Vertex) -> bool {
    let along = (0..3).map(|i| f64::from(direction[i]) * f64::from(vertex.direction[i]));
    along.sum::<f64>() > 0.0
}

/// The cell of a direction of any length.
fn cell(direction: [i32; 3]) -> usize {
    let size = direction.map(i32::unsigned_abs);
    let axis = if size[0] >= size[1] && size[0] >= size[2] {
        0
    } else if size[1] >= size[2] {
        1
    } else {
        2
    };
    // The ray through the direction meets the side of the cube on its greatest axis.
    // The zero direction has no side; any cell will do.
    let depth = f64::from(size[axis].max(1));
    let [row, column] = [1, 2].map(|step| {
        let share = f64::from(direction[(axis + step) % 3]) / depth * 0.5 + 0.5;
        ((share * CELLS as f64) as usize).min(CELLS - 1)
    });
    let side = axis * 2 + usize::from(direction[axis] < 0);
    (side * CELLS + row) * CELLS + column
}

/// How far a direction lies left of each edge of a triangle; all are at least 0 inside. Opposite in
/// sign for the two faces of an edge, to the last bit. All corners must be less than 60 degrees
/// away.
#[inline]
pub fn sides(direction: [i32; 3], corners: [&Vertex; 3]) -> [f64; 3] {
    let d = direction.map(f64::from);
    let to = corners.map(|v| [0, 1, 2].map(|i| f64::from(v.direction[i]) - d[i]));
    [[0, 1], [1, 2], [2, 0]].map(|[i, j]| triple(to[i], to[j], d))
}

/// The triple product (p × q)·d.
#[inline]
fn triple(p: [f64; 3], q: [f64; 3], d: [f64; 3]) -> f64 {
    // With p and q exchanged every term is negated exactly: both faces of an edge agree.
    let n = [
        p[1] * q[2] - p[2] * q[1],
        p[2] * q[0] - p[0] * q[2],
        p[0] * q[1] - p[1] * q[0],
    ];
    n[0] * d[0] + n[1] * d[1] + n[2] * d[2]
}

/// Least of the three sides of a triangle, as a share of their sum: at least 0 inside, at most a
/// third.
#[inline]
pub fn depth(sides: [f64; 3]) -> f64 {
    let sum = (sides[0] + sides[1] + sides[2])
        .abs()
        .max(f64::MIN_POSITIVE);
    sides[0].min(sides[1]).min(sides[2]) / sum
}
