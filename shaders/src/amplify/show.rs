//! Pass: every vertex gets the ground that a level shows of it.
//!
//! Reads and writes one vertex. Its final ground is its own on every level; what a coarse level
//! shows stands for the land around it ([`rules::coarse`](super::rules::coarse)), so that a square
//! has the same mean height at every level. A question asks for one level. In a view the level
//! follows from the distance ([`View::shown_level`]), evenly: a vertex has one shown height,
//! whatever leaves meet there, so no crack opens, and none jumps while the camera moves.

use super::carve::Carved;
use super::fixed::Q16;
use super::mark::View;
use super::rules::{Rules, coarse};
use super::scale::PlanetScale;
use super::vertex::Vertex;

/// Ground and water that a whole level shows of a vertex.
///
/// ```
/// use pangaea_shaders::amplify::base::Base;
/// use pangaea_shaders::amplify::carve::{CarveCache, carve};
/// use pangaea_shaders::amplify::rules::Rules;
/// use pangaea_shaders::amplify::show::show;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let base = Base::new(&control_mesh(6_371_000, 3, 1))?;
/// let (rules, scale) = (Rules::default(), base.scale);
/// let land = base.vertices.iter().find(|v| v.height > 500_000).expect("a hill");
/// let carved = carve(&mut CarveCache::default(), &scale, &rules, land);
/// // From afar the land around it, which is higher than its valleys; near by itself.
/// assert!(show(&scale, &rules, land, carved, 0).ground > carved.ground);
/// assert_eq!(show(&scale, &rules, land, carved, 8), carved);
/// # Ok::<(), pangaea_shaders::amplify::base::BadMesh>(())
/// ```
#[inline]
pub fn show(
    scale: &PlanetScale,
    rules: &Rules,
    vertex: &Vertex,
    carved: Carved,
    level: u32,
) -> Carved {
    between_levels(scale, rules, vertex, carved, level as i32 * Q16)
}

/// The same of a level in Q16.
fn between_levels(
    scale: &PlanetScale,
    rules: &Rules,
    vertex: &Vertex,
    carved: Carved,
    level: i32,
) -> Carved {
    let edge = scale.edge_grains(0);
    let ground = carved.ground + coarse::lift(rules, vertex, carved.ground, edge, level);
    Carved { ground, ..carved }
}

/// Ground and water that a view shows of a column of vertices and their final ground.
pub fn show_all<'a>(
    scale: &PlanetScale,
    rules: &Rules,
    view: &View,
    vertices: impl IntoIterator<Item = &'a Vertex>,
    carved: &[Carved],
) -> Vec<Carved> {
    let shown = vertices.into_iter().zip(carved).map(|(vertex, &carved)| {
        let level = view.shown_level(scale, vertex);
        between_levels(scale, rules, vertex, carved, level)
    });
    shown.collect()
}

#[cfg(test)]
#[path = "show_tests.rs"]
mod tests;
