//! The ground of a view: every level from the control mesh down to what the view asks for.

use super::base::Base;
use super::cull::cull;
use super::mark::{View, halo};
use super::rules::Rules;
use super::scale::PlanetScale;
use super::step::step;
use super::topology::{Level, SplitMark, gather};
use super::vertex::Vertex;

/// The finest level: edges of 0.4 m on an Earth-sized planet.
pub const FINEST: u32 = 17;

/// Caps of a refinement: the sizes of its buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caps {
    /// Vertices.
    pub vertices: usize,
    /// Faces of one level.
    pub faces: usize,
}

impl Default for Caps {
    /// 8 million vertices, 8 million faces a level: about 3 GB with the edges, at most.
    fn default() -> Self {
        Self {
            vertices: 8_000_000,
            faces: 8_000_000,
        }
    }
}

/// Ground refined for a view.
#[derive(Clone, Debug)]
pub struct RefinedGround {
    /// The planet's constants.
    pub scale: PlanetScale,
    /// Vertices of all levels.
    pub vertices: Vec<Vertex>,
    /// Edges and faces level by level. A face of any level that is not [`SplitMark::Split`] is a
    /// leaf.
    pub levels: Vec<Level>,
    /// The first level whose splits were dropped because a cap was reached.
    pub capped: Option<u32>,
}

/// Refines the ground for a view. At a cap the whole level that would pass it is dropped, so the
/// mesh stays whole.
///
/// ```
/// use pangaea_shaders::amplify::base::Base;
/// use pangaea_shaders::amplify::ground::{Caps, refine};
/// use pangaea_shaders::amplify::mark::View;
/// use pangaea_shaders::amplify::rules::Rules;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let base = Base::new(&control_mesh(6_371_000, 3, 1))?;
/// let view = View::disc(base.vertices[7].direction, 50, 17);
/// let ground = refine(&base, &Rules::default(), &view, &Caps::default());
/// assert_eq!((ground.levels.len(), ground.capped), (18, None));
/// assert!(!ground.triangles().is_empty());
/// # Ok::<(), pangaea_shaders::amplify::base::BadMesh>(())
/// ```
pub fn refine(base: &Base, rules: &Rules, view: &View, caps: &Caps) -> RefinedGround {
    refined(base, rules, view, caps, true)
}

/// The same without the edges of the view's finest level, which is all that a collider needs: a
/// fifth less work.
pub fn refine_faces(base: &Base, rules: &Rules, view: &View, caps: &Caps) -> RefinedGround {
    refined(base, rules, view, caps, false)
}

fn refined(
    base: &Base,
    rules: &Rules,
    view: &View,
    caps: &Caps,
    finest_edges: bool,
) -> RefinedGround {
    let (vertices, level) = cull(base, view);
    let mut ground = RefinedGround {
        scale: base.scale,
        vertices,
        levels: vec![level],
        capped: None,
    };
    let finest = view.level.min(FINEST);
    for index in 0..finest {
        let level = &mut ground.levels[index as usize];
        let (vertices, faces) = mark_faces(&base.scale, view, index, level, &ground.vertices);
        if faces == 0 {
            break;
        }
        if ground.vertices.len() + vertices > caps.vertices || 4 * faces > caps.faces {
            unmark(level);
            ground.capped = Some(index);
            break;
        }
        // Without edges nothing can be split further, so only the last level may lack them.
        let edges = finest_edges || index + 1 < finest;
        let next = step(
            &base.scale,
            rules,
            index,
            level,
            &mut ground.vertices,
            edges,
        );
        ground.levels.push(next);
    }
    ground
}

/// Makes all faces of a level leaves.
fn unmark(level: &mut Level) {
    for face in &mut level.faces {
        face.mark = SplitMark::Leaf;
    }
}

/// Marks the faces of a level; returns bounds of the vertices made and the number of faces split.
fn mark_faces(
    scale: &PlanetScale,
    view: &View,
    index: u32,
    level: &mut Level,
    vertices: &[Vertex],
) -> (usize, usize) {
    let splits: Vec<bool> = level
        .faces
        .iter()
        .map(|face| view.splits(scale, index, gather(vertices, face.vertices)))
        .collect();
    let mut marked = 0;
    for i in 0..level.faces.len() {
        // All splits are known before the first mark: a mark reads its neighbours'.
        let mark = halo(&level.faces[i], i as u32, &level.edges, |f| {
            splits[f as usize]
        });
        level.faces[i].mark = mark;
        marked += usize::from(mark != SplitMark::Leaf);
    }
    // At most a middle an edge; neighbours share theirs, so fewer are made.
    (3 * marked, splits.iter().filter(|&&s| s).count())
}
