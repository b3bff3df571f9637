//! Valleys: the ground drains without hollows, and valleys lead on to rivers.

use super::*;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Level, NONE};
use crate::amplify::vertices::Vertices;

/// Lowest ground next to every vertex along the edges of a level; `None` of those that lack some of
/// their edges there.
fn lowest_beside(level: &Level, vertices: &Vertices) -> Vec<Option<i32>> {
    let mut lowest = vec![None; vertices.len()];
    for (edge, _) in level.edges() {
        let [a, b] = edge.vertices.map(|v| v as usize);
        for (here, there) in [(a, b), (b, a)] {
            let height = vertices[there].height;
            lowest[here] = Some(lowest[here].map_or(height, |low: i32| low.min(height)));
        }
    }
    let rim = level.edges().filter(|(edge, _)| edge.faces.contains(&NONE));
    for vertex in rim.flat_map(|(edge, _)| edge.vertices) {
        lowest[vertex as usize] = None;
    }
    lowest
}

/// Every vertex is made above an end of its edge, and what finer levels lay between the two falls
/// towards that end: of dry land next to none is a pit. Where all halves of edges may overtop their
/// ends, one vertex of 160 is.
#[test]
fn land_has_no_hollows() {
    const LEVEL: u32 = 6;
    let base = planet();
    let [mut land, mut pits] = [0, 0];
    for k in 0..6 {
        let ground = refined(&base, &View::disc(direction(k), 20_000, LEVEL));
        let lowest = lowest_beside(&ground.levels[LEVEL as usize], &ground.vertices);
        for (vertex, lowest) in ground.vertices.iter().zip(lowest) {
            let is_land = matches!(vertex.kind, VertexKind::Terrain | VertexKind::Gully);
            if let Some(lowest) = lowest.filter(|_| is_land && vertex.level > 0) {
                land += 1;
                pits += u32::from(lowest >= vertex.height);
            }
        }
    }
    assert!(land > 1_000, "{land}");
    assert!(pits * 1_000 < land, "{pits} of {land}");
}

/// Valleys of the coarse levels join into longer ones: where one ends another begins, or water, or
/// the floor of a basin of the control mesh.
#[test]
fn valleys_lead_on_to_rivers() {
    const LEVEL: u32 = 4;
    let base = planet();
    let [mut ends, mut lost] = [0, 0];
    for k in 0..6 {
        let ground = refined(&base, &View::disc(direction(k), 60_000, LEVEL));
        let level = &ground.levels[LEVEL as usize];
        let mut leads_on = vec![false; ground.vertices.len()];
        for (edge, _) in level
            .edges()
            .filter(|(edge, _)| edge.kind != EdgeKind::Terrain)
        {
            leads_on[edge.vertices[0] as usize] = true;
        }
        let rim: Vec<u32> = level
            .edges()
            .filter(|(edge, _)| edge.faces.contains(&NONE))
            .flat_map(|(edge, _)| edge.vertices)
            .collect();
        for (edge, _) in level
            .edges()
            .filter(|(edge, _)| edge.kind == EdgeKind::Gully)
        {
            let end = edge.vertices[1];
            let vertex = &ground.vertices[end as usize];
            let is_dry = matches!(vertex.kind, VertexKind::Terrain | VertexKind::Gully);
            if is_dry && vertex.level > 0 && !rim.contains(&end) {
                ends += 1;
                lost += u32::from(!leads_on[end as usize]);
            }
        }
    }
    assert!(ends > 1_000, "{ends}");
    assert_eq!(lost, 0, "of {ends}");
}
