//! The control mesh made ready: vertices of level 0 with their nearest river, edges with what
//! arrives along them.
//!
//! Done once per planet; what refines the ground only reads it.

use super::control::{ControlMesh, VertexKind};
use super::fixed::{GRAINS, ONE};
use super::geometry::nearest_on;
use super::rules::EdgeKind;
use super::scale::PlanetScale;
use super::topology::{Edge, Face, Level, NONE};
use super::vertex::{FAR, RiverSegment, Vertex};
use super::vertex_resolve::segment;

/// Level 0 of the ground.
#[derive(Clone, Debug)]
pub struct Base {
    /// The planet's constants.
    pub scale: PlanetScale,
    /// Vertices of the control mesh.
    pub vertices: Vec<Vertex>,
    /// Its edges and faces.
    pub level: Level,
    /// Faces around vertex v: `around[starts[v]..starts[v + 1]]`.
    pub starts: Vec<u32>,
    /// See `starts`.
    pub around: Vec<u32>,
    /// Where to look for the face of a direction.
    pub index: super::locate::FaceIndex,
}

/// What is wrong with a control mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BadMesh {
    /// The radius is outside 50,000..=10,000,000 m.
    Radius,
    /// It has fewer than four faces, or so many items that 32 bits cannot number them.
    Size,
    /// This vertex is off the sphere by more than a millionth, or more than 100 km high, deep, or
    /// under water.
    Vertex(u32),
    /// This face names an edge that is not there, or not its own.
    Face(u32),
    /// This edge lacks a face, or is longer than about 15 degrees.
    Edge(u32),
}

impl core::fmt::Display for BadMesh {
    fn fmt(&self, f: &mut core::fmt::Formatter) -> core::fmt::Result {
        match self {
            Self::Radius => write!(f, "the radius of a control mesh must be 50 km to 10,000 km"),
            Self::Size => {
                write!(
                    f,
                    "a control mesh must have at least four faces, and items that 32 bits can number"
                )
            }
            Self::Vertex(i) => write!(
                f,
                "vertex {i} of the control mesh is off the sphere or beyond 100 km"
            ),
            Self::Face(i) => write!(
                f,
                "face {i} of the control mesh does not fit its edges and vertices"
            ),
            Self::Edge(i) => write!(
                f,
                "edge {i} of the control mesh does not fit its faces, or is too long"
            ),
        }
    }
}

impl core::error::Error for BadMesh {}

impl Base {
    /// Makes a control mesh ready. Every face must have its three edges, every edge its two faces.
    pub fn new(mesh: &ControlMesh) -> Result<Self, BadMesh> {
        check(mesh)?;
        let scale = PlanetScale::new(mesh);
        let mut vertices: Vec<Vertex> = mesh.vertices.iter().map(Vertex::from_control).collect();
        for vertex in &mut vertices {
            if vertex.is_wet() {
                (vertex.height, vertex.water) = (vertex.bed, vertex.water.max(vertex.bed));
            } else {
                vertex.discharge = 0;
            }
        }
        accumulate(mesh, &mut vertices);
        let mut edges = edges(mesh, &vertices);
        dry_drains(&mut vertices, &mut edges);
        let faces: Vec<Face> = (0..)
            .zip(&mesh.faces)
            .map(|(i, f)| Face::new(f.vertices, f.edges, i))
            .collect();
        nearest_rivers(&scale, &mut vertices, &edges, &faces);
        let (starts, around) = incidence(vertices.len(), &faces);
        let index = super::locate::FaceIndex::new(&vertices, &faces);
        Ok(Self {
            scale,
            vertices,
            level: Level { edges, faces },
            starts,
            around,
            index,
        })
    }

    /// Faces around a vertex.
    pub fn faces_around(&self, vertex: u32) -> &[u32] {
        &self.around
            [self.starts[vertex as usize] as usize..self.starts[vertex as usize + 1] as usize]
    }
}

fn check(mesh: &ControlMesh) -> Result<(), BadMesh> {
    if !(50_000..=10_000_000).contains(&mesh.radius_m) {
        return Err(BadMesh::Radius);
    }
    let (vertices, edges, faces) = (mesh.vertices.len(), mesh.edges.len(), mesh.faces.len());
    if faces < 4 || vertices.max(edges).max(faces) > 1 << 28 {
        return Err(BadMesh::Size);
    }
    for (i, vertex) in (0..).zip(&mesh.vertices) {
        let square: f64 = vertex
            .direction
            .iter()
            .map(|&x| f64::from(x) * f64::from(x))
            .sum();
        let on_sphere = (square.sqrt() / f64::from(ONE) - 1.0).abs() < 1e-6;
        let heights = [vertex.height, vertex.bed, vertex.water, vertex.crust];
        if !on_sphere
            || heights
                .iter()
                .any(|h| h.unsigned_abs() > 100_000 * GRAINS as u32)
        {
            return Err(BadMesh::Vertex(i));
        }
    }
    for (i, face) in (0..).zip(&mesh.faces) {
        let fits = (0..3).all(|k| {
            let (a, b) = (face.vertices[k], face.vertices[(k + 1) % 3]);
            (a as usize) < vertices
                && a != b
                && mesh.edges.get(face.edges[k] as usize).is_some_and(|e| {
                    (e.faces[0] == i && e.vertices == [a, b])
                        || (e.faces[1] == i && e.vertices == [b, a])
                })
        });
        if !fits {
            return Err(BadMesh::Face(i));
        }
    }
    for (i, edge) in (0..).zip(&mesh.edges) {
        let [a, b] = edge
            .vertices
            .map(|v| mesh.vertices.get(v as usize).map(|v| v.direction));
        let short = a
            .zip(b)
            .is_some_and(|(a, b)| (0..3).all(|i| a[i].abs_diff(b[i]) < 1 << 29));
        let fits = short
            && edge.faces[0] != edge.faces[1]
            && edge.faces.iter().all(|&f| {
                mesh.faces
                    .get(f as usize)
                    .is_some_and(|f| f.edges.contains(&i))
            });
        if !fits {
            return Err(BadMesh::Edge(i));
        }
    }
    Ok(())
}

/// Raises discharges until every vertex carries at least what comes from upstream: squares of
/// rounded flows need not.
fn accumulate(mesh: &ControlMesh, vertices: &mut [Vertex]) {
    let rivers = || {
        mesh.edges
            .iter()
            .filter(|e| e.river != 0)
            .map(|e| e.vertices.map(|v| v as usize))
    };
    let mut waiting = vec![0_u32; vertices.len()];
    let mut below = vec![usize::MAX; vertices.len()];
    for [up, down] in rivers() {
        waiting[down] += 1;
        below[up] = down;
    }
    let mut inflow = vec![0_u32; vertices.len()];
    let mut ready: Vec<usize> = (0..vertices.len())
        .filter(|&v| waiting[v] == 0 && below[v] != usize::MAX)
        .collect();
    while let Some(up) = ready.pop() {
        vertices[up].discharge = vertices[up].discharge.max(inflow[up]);
        let down = below[up];
        if down != usize::MAX {
            inflow[down] = inflow[down].saturating_add(vertices[up].discharge);
            waiting[down] -= 1;
            if waiting[down] == 0 {
                ready.push(down);
            }
        }
    }
}

/// Edges, with the discharge that arrives at each river edge's lower end: what leaves the upper
/// end, and an equal part of what the lower vertex gains by itself, so that all that arrives there
/// makes its discharge.
fn edges(mesh: &ControlMesh, vertices: &[Vertex]) -> Vec<Edge> {
    let mut inflow = vec![(0_u64, 0_u64); vertices.len()];
    let rivers = || mesh.edges.iter().filter(|e| e.river != 0);
    for edge in rivers() {
        let into = &mut inflow[edge.vertices[1] as usize];
        (into.0, into.1) = (
            into.0 + u64::from(vertices[edge.vertices[0] as usize].discharge),
            into.1 + 1,
        );
    }
    let mut seen = vec![0_u64; vertices.len()];
    let make = |edge: &super::control::ControlEdge| {
        let kind = if edge.river != 0 {
            EdgeKind::River
        } else {
            EdgeKind::Terrain
        };
        let mut made = Edge::new(kind, edge.vertices, edge.faces);
        if edge.river != 0 {
            let [up, down] = edge.vertices.map(|v| v as usize);
            let (sum, count) = inflow[down];
            let gain = u64::from(vertices[down].discharge).saturating_sub(sum);
            let k = seen[down];
            seen[down] += 1;
            let part = gain * (k + 1) / count - gain * k / count;
            made.arriving =
                (u64::from(vertices[up].discharge) + part).min(u64::from(u32::MAX)) as u32;
        }
        made
    };
    mesh.edges.iter().map(make).collect()
}

/// Every dry land vertex drains down its steepest edge, which becomes a gully, as does the vertex.
fn dry_drains(vertices: &mut [Vertex], edges: &mut [Edge]) {
    let mut lowest: Vec<Option<u32>> = vec![None; vertices.len()];
    let beyond = |edge: &Edge, v: u32| {
        if edge.vertices[0] == v {
            edge.vertices[1]
        } else {
            edge.vertices[0]
        }
    };
    for (i, edge) in (0..)
        .zip(edges.iter())
        .filter(|(_, e)| e.kind == EdgeKind::Terrain)
    {
        for (v, to) in [
            (edge.vertices[0], edge.vertices[1]),
            (edge.vertices[1], edge.vertices[0]),
        ] {
            let key = |w: u32| (vertices[w as usize].height, w);
            let best = lowest[v as usize].map(|e: u32| key(beyond(&edges[e as usize], v)));
            if vertices[v as usize].kind == VertexKind::Terrain && key(to) < best.unwrap_or(key(v))
            {
                lowest[v as usize] = Some(i);
            }
        }
    }
    for (v, lowest) in (0..).zip(lowest) {
        let Some(edge) = lowest.map(|i| &mut edges[i as usize]) else {
            continue;
        };
        edge.kind = EdgeKind::Gully;
        if edge.vertices[0] != v {
            edge.vertices.swap(0, 1);
            edge.faces.swap(0, 1);
        }
        let vertex = &mut vertices[v as usize];
        (vertex.kind, vertex.gully_distance) = (VertexKind::Gully, 0);
    }
}

/// The nearest river edge of the faces around each vertex.
fn nearest_rivers(scale: &PlanetScale, vertices: &mut [Vertex], edges: &[Edge], faces: &[Face]) {
    for vertex in vertices.iter_mut() {
        if vertex.is_wet() {
            let own = segment(scale, 0, 0, [vertex, vertex], vertex.discharge);
            (vertex.river, vertex.river_distance, vertex.river_along) = (own, 0, 0);
        }
    }
    // A river edge is seen by the far corners of its two faces.
    let mut found: Vec<(i32, i32, RiverSegment)> =
        vec![(FAR, 0, RiverSegment::default()); vertices.len()];
    for (i, edge) in (0..).zip(edges) {
        if edge.kind != EdgeKind::River {
            continue;
        }
        let [up, down] = edge.vertices.map(|v| &vertices[v as usize]);
        let piece = segment(scale, 0, 0, [up, down], edge.arriving);
        for corner in edge
            .faces
            .iter()
            .filter(|&&f| f != NONE)
            .map(|&f| faces[f as usize].opposite(i))
        {
            let (along, off) = nearest_on(piece.ends, vertices[corner as usize].direction);
            let distance = scale.grains(off).min(FAR);
            let best = &mut found[corner as usize];
            if distance < best.0 {
                *best = (distance, along, piece);
            }
        }
    }
    for (vertex, (distance, along, piece)) in vertices.iter_mut().zip(found) {
        if distance < vertex.river_distance {
            (vertex.river, vertex.river_distance, vertex.river_along) = (piece, distance, along);
        }
    }
}

/// Faces around every vertex, in the order of the faces.
fn incidence(vertices: usize, faces: &[Face]) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; vertices + 1];
    for vertex in faces.iter().flat_map(|f| f.vertices) {
        starts[vertex as usize + 1] += 1;
    }
    for i in 0..vertices {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut around = vec![0; faces.len() * 3];
    for (i, face) in (0..).zip(faces) {
        for vertex in face.vertices {
            around[next[vertex as usize] as usize] = i;
            next[vertex as usize] += 1;
        }
    }
    (starts, around)
}
