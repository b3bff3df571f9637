//! Rivers and gullies of level 0: discharges, river edges, dry drainage lines, nearest rivers.

use super::arms::{Below, carried, parts, river_edges};
use super::estuary::length;
use crate::amplify::arith::{linear_step, mul_q16, ratio};
use crate::amplify::control::{ControlMesh, VertexKind};
use crate::amplify::curve::heading_of;
use crate::amplify::fixed::{Q16, difference, q16};
use crate::amplify::geometry::is_left;
use crate::amplify::rules::EdgeKind;
use crate::amplify::rules::meander::winding;
use crate::amplify::scale::PlanetScale;
use crate::amplify::topology::{Edge, Face, NONE, gather};
use crate::amplify::vertex::{FAR, RiverSegment, Vertex};

/// Share of a river that joins in the discharge of the vertex: up to the first it changes nothing,
/// from the second on both run straight into one another.
const JOINED: [i32; 2] = [q16(0.02), q16(0.12)];

/// Puts wet ground at its bed, water over it, and takes the discharge from dry ground.
pub(super) fn settle_water(vertices: &mut [Vertex]) {
    for vertex in vertices {
        if vertex.is_wet() {
            vertex.height = vertex.bed;
            vertex.water = vertex.water.max(vertex.bed);
        } else {
            vertex.discharge = 0;
        }
    }
}

/// Raises discharges until every vertex carries at least what comes from upstream: squares of
/// rounded flows need not.
pub(super) fn accumulate(mesh: &ControlMesh, below: &Below, vertices: &mut [Vertex]) {
    // How many rivers still have to arrive at each vertex.
    let mut waiting = vec![0_u32; vertices.len()];
    for [_, down] in river_edges(mesh) {
        waiting[down] += 1;
    }
    // From the springs down: a vertex is ready once all that flow into it are done.
    let mut inflow = vec![0_u32; vertices.len()];
    let mut ready: Vec<usize> = (0..vertices.len())
        .filter(|&v| waiting[v] == 0 && !below.of(v).is_empty())
        .collect();
    while let Some(up) = ready.pop() {
        let arms = below.of(up);
        let arrived = vertices[up].discharge.max(inflow[up]);
        vertices[up].discharge = arrived;
        for (&down, part) in arms.iter().zip(parts(vertices, arrived, arms)) {
            // A planet that saturates carries 200,000 m³/s in one river.
            inflow[down] = inflow[down].saturating_add(part);
            if arms.len() > 1 {
                // An arm of a delta has what the split gives it, and no more.
                vertices[down].discharge = part;
            }
            // Edges that run in a ring never become ready, and keep their discharges.
            waiting[down] -= 1;
            if waiting[down] == 0 {
                ready.push(down);
            }
        }
    }
}

/// Headings of rivers: from the largest river that arrives at a vertex to the one that leaves it.
pub(super) fn find_headings(below: &Below, largest: &[Option<usize>], vertices: &mut [Vertex]) {
    for v in 0..vertices.len() {
        let arrives = largest[v].map_or([0; 3], |up| way(vertices, up, v));
        let next = below.of(v).last();
        let leaves = next.map_or([0; 3], |&down| way(vertices, v, down));
        vertices[v].heading = heading_of([0, 1, 2].map(|i| arrives[i] + leaves[i]));
    }
}

/// How much rivers wind at their vertices: by their fall from the largest river that arrives to the
/// one that leaves. Where two rivers meet they do not, so that they join at an acute angle, nor
/// where one parts.
pub(super) fn find_windings(
    scale: &PlanetScale,
    below: &Below,
    largest: &[Option<usize>],
    joins: &[Option<usize>],
    vertices: &mut [Vertex],
) {
    for v in 0..vertices.len() {
        let &[next] = below.of(v) else { continue };
        if vertices[v].kind != VertexKind::River {
            continue;
        }
        let from = largest[v].unwrap_or(v);
        let way = [(from, v), (v, next)].map(|(up, down)| length(scale, vertices, [up, down]));
        let fall = vertices[from].water.saturating_sub(vertices[next].water);
        let fall = ratio(fall, way[0].saturating_add(way[1]));
        let joining = joins[v].map_or(0, |from| vertices[from].discharge);
        let alone = Q16
            - linear_step(
                JOINED[0],
                JOINED[1],
                ratio_of(joining, vertices[v].discharge),
            );
        let to_left = joins[v].map_or(vertices[v].seed & 1 == 0, |from| {
            is_left_of(vertices, [largest[v].unwrap_or(v), v], from)
        });
        let winding = winding(fall, vertices[v].seed, to_left);
        vertices[v].winding = mul_q16(i32::from(winding), alone) as i16;
    }
}

/// Whether a vertex lies to the left of the way from a vertex to another.
fn is_left_of(vertices: &[Vertex], [from, to]: [usize; 2], place: usize) -> bool {
    let [from, to, place] = [from, to, place].map(|v| vertices[v].direction);
    is_left(to, difference(to, from), difference(place, to))
}

/// Share of a discharge in another, Q16.
fn ratio_of(part: u32, whole: u32) -> i32 {
    ratio((part >> 1) as i32, (whole >> 1) as i32)
}

/// The unit tangent from a vertex to another, times 32767.
fn way(vertices: &[Vertex], from: usize, to: usize) -> [i32; 3] {
    let way = difference(vertices[to].direction, vertices[from].direction);
    heading_of(way).map(i32::from)
}

/// Rivers that meet in a vertex.
#[derive(Clone, Copy, Default)]
struct Confluence {
    /// Discharge at the upper ends of their edges.
    discharge: u64,
    /// Number of rivers.
    rivers: u64,
    /// Rivers whose arriving discharge is known already.
    done: u64,
}

/// Edges, with the discharge that arrives at each river edge's lower end: what leaves the upper
/// end, and an equal part of what the lower vertex gains by itself, so that all that arrives there
/// makes its discharge.
pub(super) fn edges(mesh: &ControlMesh, below: &Below, vertices: &[Vertex]) -> Vec<Edge> {
    let mut confluences = vec![Confluence::default(); vertices.len()];
    for [up, down] in river_edges(mesh) {
        let carried = carried([&vertices[up], &vertices[down]], below.of(up).len());
        confluences[down].discharge += u64::from(carried);
        confluences[down].rivers += 1;
    }
    let edges = mesh.edges.iter().map(|edge| {
        if edge.river == 0 {
            return Edge::new(EdgeKind::Terrain, edge.vertices, edge.faces);
        }
        let into = &mut confluences[edge.vertices[1] as usize];
        let ends = gather(vertices, edge.vertices);
        let carried = carried(ends, below.of(edge.vertices[0] as usize).len());
        Edge {
            arriving: arriving(carried, ends[1], into),
            ..Edge::new(EdgeKind::River, edge.vertices, edge.faces)
        }
    });
    edges.collect()
}

/// Discharge that the next river of a confluence brings, of which it carries so much already.
fn arriving(carried: u32, down: &Vertex, into: &mut Confluence) -> u32 {
    // What the vertex gains by itself is spread over the rivers that meet there.
    let gain = u64::from(down.discharge).saturating_sub(into.discharge);
    // Differences of rounded sums, so that the parts make the whole.
    let part = gain * (into.done + 1) / into.rivers - gain * into.done / into.rivers;
    into.done += 1;
    (u64::from(carried) + part).min(u64::from(u32::MAX)) as u32
}

/// Every dry land vertex drains down its steepest edge, which becomes a gully, as does the vertex.
pub(super) fn add_gullies(vertices: &mut [Vertex], edges: &mut [Edge]) {
    for (v, drain) in (0..).zip(drains(vertices, edges)) {
        let Some(edge) = drain.map(|i| &mut edges[i as usize]) else {
            continue;
        };
        // Only its higher end drains along it, so no edge is turned twice.
        edge.kind = EdgeKind::Gully;
        if edge.vertices[0] != v {
            edge.reverse();
        }
        let vertex = &mut vertices[v as usize];
        vertex.kind = VertexKind::Gully;
    }
}

/// The edge of each dry land vertex to its lowest neighbour, where that lies lower; the index
/// decides between equal heights.
fn drains(vertices: &[Vertex], edges: &[Edge]) -> Vec<Option<u32>> {
    let key = |v: u32| (vertices[v as usize].height, v);
    let mut lowest: Vec<Option<(u32, u32)>> = vec![None; vertices.len()];
    for (i, edge) in (0..).zip(edges) {
        if edge.kind != EdgeKind::Terrain {
            continue;
        }
        let [a, b] = edge.vertices;
        for (from, to) in [(a, b), (b, a)] {
            // A vertex without a lower neighbour is a pit, and has no drain.
            let best = lowest[from as usize].map_or(from, |(_, neighbour)| neighbour);
            if vertices[from as usize].kind == VertexKind::Terrain && key(to) < key(best) {
                lowest[from as usize] = Some((i, to));
            }
        }
    }
    lowest
        .into_iter()
        .map(|found| found.map(|(edge, _)| edge))
        .collect()
}

/// Gives each vertex the nearest river edge of the faces around it.
pub(super) fn find_nearest(
    scale: &PlanetScale,
    vertices: &mut [Vertex],
    edges: &[Edge],
    faces: &[Face],
) {
    for vertex in vertices.iter_mut().filter(|v| v.is_wet()) {
        // On the river itself: a segment without length.
        vertex.river = RiverSegment::between(scale, 0, 0, [vertex, vertex], vertex.discharge);
        vertex.river_distance = 0;
        vertex.river_along = 0;
    }
    for (vertex, found) in (0..).zip(beside_faces(scale, vertices, edges, faces)) {
        let vertex: &mut Vertex = &mut vertices[vertex as usize];
        if found.distance < vertex.river_distance {
            vertex.river = found.segment;
            vertex.river_distance = found.distance;
            vertex.river_along = found.along;
        }
    }
}

/// A river beside a vertex.
#[derive(Clone, Copy)]
struct RiverBeside {
    distance: i32,
    along: i32,
    segment: RiverSegment,
}

impl RiverBeside {
    /// No river yet.
    fn none() -> Self {
        Self {
            distance: FAR,
            along: 0,
            segment: RiverSegment::default(),
        }
    }

    /// Takes a segment if it is nearer to a direction.
    fn offer(&mut self, scale: &PlanetScale, direction: [i32; 3], segment: RiverSegment) {
        let (along, off) = segment.curve().nearest(direction);
        let distance = scale.grains(off).min(FAR);
        if distance < self.distance {
            *self = Self {
                distance,
                along,
                segment,
            };
        }
    }
}

/// The nearest river edge opposite to each vertex: a river edge is seen by the far corners of its
/// two faces.
fn beside_faces(
    scale: &PlanetScale,
    vertices: &[Vertex],
    edges: &[Edge],
    faces: &[Face],
) -> Vec<RiverBeside> {
    let mut found = vec![RiverBeside::none(); vertices.len()];
    for (i, edge) in (0..).zip(edges) {
        if edge.kind != EdgeKind::River {
            continue;
        }
        let ends = gather(vertices, edge.vertices);
        // River vertices know their river; the far corners of its faces need a distance.
        let segment = RiverSegment::between(scale, 0, 0, ends, edge.arriving);
        // The floor of the sea carries the river's bed on.
        let [_, end] = edge.vertices;
        found[end as usize].offer(scale, ends[1].direction, segment);
        for &face in edge.faces.iter().filter(|&&f| f != NONE) {
            let corner = faces[face as usize].opposite(i) as usize;
            found[corner].offer(scale, vertices[corner].direction, segment);
        }
    }
    found
}
