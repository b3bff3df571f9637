//! Rivers of level 0: discharges, headings, what arrives along each edge, and the nearest river of
//! every vertex.

use super::arms::{BaseRivers, LargestAbove, carried, parts};
use super::estuary::{self, length};
use crate::amplify::arith::{linear_step, mul_q16, ratio};
use crate::amplify::control::VertexKind;
use crate::amplify::curve::heading_of;
use crate::amplify::fixed::{Q16, difference, q16};
use crate::amplify::geometry::is_left;
use crate::amplify::rules::meander::winding;
use crate::amplify::scale::PlanetScale;
use crate::amplify::topology::{Edge, Face, NONE, gather};
use crate::amplify::vertex::{FAR, RiverSegment, Vertex};

/// Share of a river that joins in the discharge of the vertex: up to the first it changes nothing,
/// from the second on both run straight into one another.
const JOINED: [i32; 2] = [q16(0.02), q16(0.12)];

/// Settles what rivers carry and where they flow.
pub(super) fn lay(
    scale: &PlanetScale,
    network: &BaseRivers,
    vertices: &mut [Vertex],
    edges: &mut [Edge],
) {
    accumulate(network, vertices);
    let largest = LargestAbove::new(network, vertices);
    find_headings(network, &largest, vertices);
    find_windings(scale, network, &largest, vertices);
    estuary::flood(scale, network, &largest, vertices);
    find_arriving(network, vertices, edges);
}

/// Raises discharges until every vertex carries at least what comes from upstream: squares of
/// rounded flows need not.
fn accumulate(network: &BaseRivers, vertices: &mut [Vertex]) {
    // How many rivers still have to arrive at each vertex.
    let mut waiting = vec![0_u32; vertices.len()];
    for river in &network.edges {
        waiting[river.ends[1]] += 1;
    }
    // From the springs down: a vertex is ready once all that flow into it are done.
    let mut inflow = vec![0_u32; vertices.len()];
    let springs = network.upper_ends().iter().copied();
    let mut ready: Vec<usize> = springs.filter(|&v| waiting[v] == 0).collect();
    while let Some(up) = ready.pop() {
        let arms = network.below.of(up);
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
fn find_headings(network: &BaseRivers, largest: &LargestAbove, vertices: &mut [Vertex]) {
    // A vertex in which several rivers end has the same heading from each of them.
    for v in network.edges.iter().flat_map(|river| river.ends) {
        let arrives = largest.of(v).map_or([0; 3], |up| way(vertices, up, v));
        let next = network.below.of(v).last();
        let leaves = next.map_or([0; 3], |&down| way(vertices, v, down));
        vertices[v].heading = heading_of([0, 1, 2].map(|i| arrives[i] + leaves[i]));
    }
}

/// How much rivers wind at their vertices: by their fall from the largest river that arrives to the
/// one that leaves. Where two rivers meet they do not, so that they join at an acute angle, nor
/// where one parts.
fn find_windings(
    scale: &PlanetScale,
    network: &BaseRivers,
    largest: &LargestAbove,
    vertices: &mut [Vertex],
) {
    let joins = largest.joining(network, vertices);
    for &v in network.upper_ends() {
        let &[next] = network.below.of(v) else {
            continue;
        };
        if vertices[v].kind != VertexKind::River {
            continue;
        }
        let from = largest.of(v).unwrap_or(v);
        let fall = fall(scale, vertices, [from, v, next]);
        let joining = joins.of(v);
        let joined = joining.map_or(0, |other| vertices[other].discharge);
        let joined = ratio_of(joined, vertices[v].discharge);
        let alone = Q16 - linear_step(JOINED[0], JOINED[1], joined);
        let to_left = match joining {
            Some(other) => is_left_of(vertices, [from, v], other),
            None => vertices[v].seed & 1 == 0,
        };
        let winding = winding(fall, vertices[v].seed, to_left);
        vertices[v].winding = mul_q16(i32::from(winding), alone) as i16;
    }
}

/// Fall of the water over a way through three vertices, Q16.
fn fall(scale: &PlanetScale, vertices: &[Vertex], [from, v, next]: [usize; 3]) -> i32 {
    let way = [(from, v), (v, next)].map(|(up, down)| length(scale, vertices, [up, down]));
    let fall = vertices[from].water.saturating_sub(vertices[next].water);
    ratio(fall, way[0].saturating_add(way[1]))
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

/// Rivers that meet in each vertex.
struct Confluences {
    /// Discharge at the upper ends of their edges.
    discharge: Vec<u64>,
    /// Number of rivers.
    rivers: Vec<u32>,
    /// Rivers whose arriving discharge is known already.
    done: Vec<u32>,
}

/// The discharge that arrives at each river edge's lower end: what leaves the upper end, and an
/// equal part of what the lower vertex gains by itself, so that all that arrives there makes its
/// discharge.
fn find_arriving(network: &BaseRivers, vertices: &[Vertex], edges: &mut [Edge]) {
    let mut confluences = Confluences::new(network, vertices);
    for river in &network.edges {
        let down = river.ends[1];
        let carried = carried_from(network, vertices, river.ends);
        let arriving = confluences.arriving(carried, down, &vertices[down]);
        edges[river.edge as usize].arriving = arriving;
    }
}

/// Discharge that leaves the upper end of a river edge.
fn carried_from(network: &BaseRivers, vertices: &[Vertex], ends: [usize; 2]) -> u32 {
    let arms = network.below.of(ends[0]).len();
    carried(ends.map(|v| &vertices[v]), arms)
}

impl Confluences {
    fn new(network: &BaseRivers, vertices: &[Vertex]) -> Self {
        let n = vertices.len();
        let mut all = Self {
            discharge: vec![0; n],
            rivers: vec![0; n],
            done: vec![0; n],
        };
        for river in &network.edges {
            let carried = carried_from(network, vertices, river.ends);
            let down = river.ends[1];
            all.discharge[down] += u64::from(carried);
            all.rivers[down] += 1;
        }
        all
    }

    /// Discharge that the next river into a vertex brings, of which it carries so much already.
    fn arriving(&mut self, carried: u32, v: usize, down: &Vertex) -> u32 {
        // What the vertex gains by itself is spread over the rivers that meet there.
        let gain = u64::from(down.discharge).saturating_sub(self.discharge[v]);
        let [rivers, done] = [self.rivers[v], self.done[v]].map(u64::from);
        // Differences of rounded sums, so that the parts make the whole.
        let part = gain * (done + 1) / rivers - gain * done / rivers;
        self.done[v] += 1;
        (u64::from(carried) + part).min(u64::from(u32::MAX)) as u32
    }
}

/// Lays what every vertex has of its own: gullies run down from those that drain by one of `drains`;
/// wet ones lie on their river, a segment without length.
pub(super) fn lay_at_vertices(drains: &[u32], vertices: &mut [Vertex]) {
    for (vertex, &drain) in vertices.iter_mut().zip(drains) {
        if drain != NONE {
            vertex.kind = VertexKind::Gully;
        }
        if vertex.is_wet() {
            let ends = [&*vertex; 2];
            vertex.river = RiverSegment::between(0, 0, ends, vertex.discharge);
            vertex.river_distance = 0;
            vertex.river_along = 0;
        }
    }
}

/// Gives each vertex the nearest river edge opposite to it: a river edge is seen by the far corners
/// of its two faces.
pub(super) fn lay_beside(
    scale: &PlanetScale,
    network: &BaseRivers,
    vertices: &mut [Vertex],
    edges: &[Edge],
    faces: &[Face],
) {
    for river in &network.edges {
        let edge = &edges[river.edge as usize];
        let ends = gather(vertices, edge.vertices);
        // River vertices know their river; the far corners of its faces need a distance.
        let segment = RiverSegment::between(0, 0, ends, edge.arriving);
        // The floor of the sea carries the river's bed on.
        offer(scale, &mut vertices[river.ends[1]], segment);
        for &face in edge.faces.iter().filter(|&&f| f != NONE) {
            let corner = faces[face as usize].opposite(river.edge);
            offer(scale, &mut vertices[corner as usize], segment);
        }
    }
}

/// Gives a vertex a segment if that is nearer than its own, which none is to a wet one.
fn offer(scale: &PlanetScale, vertex: &mut Vertex, segment: RiverSegment) {
    let (along, off) = segment.curve().nearest(vertex.direction);
    let distance = scale.grains(off).min(FAR);
    if distance < vertex.river_distance {
        vertex.river = segment;
        vertex.river_distance = distance;
        vertex.river_along = along;
    }
}
