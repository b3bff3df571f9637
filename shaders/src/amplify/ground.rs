//! The ground of a view: every level from the control mesh down to what the view asks for.

use super::arith::{mul_q16, ratio, sqrt_q16};
use super::base::Base;
use super::fixed::{Q16, q16};
use super::mark::{SHARPNESS, View};
use super::reach;
use super::rules::Rules;
use super::scale::PlanetScale;
use super::sight::Sight;
use super::step::{self, LevelPlan};
use super::topology::{Level, SplitMark};
use super::uniform::LevelUniform;
use super::vertices::Vertices;

/// The finest level: edges of 0.4 m on an Earth-sized planet.
pub const FINEST: u32 = 17;

/// Most that the sharpness of a camera keeps where a view passes a cap, Q16.
const MOST_KEPT: i32 = q16(0.875);

/// Caps of a refinement: the sizes of its buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caps {
    /// Vertices.
    pub vertices: usize,
    /// Faces of one level.
    pub faces: usize,
}

impl Default for Caps {
    /// 8 million vertices, the control mesh's included, and 8 million faces a level. A camera that
    /// reaches them holds 3 GB: 172 bytes a vertex, and for each of them four edges of 40 bytes and
    /// three faces of 36.
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
    pub vertices: Vertices,
    /// The edge, in the level before its own, that each vertex of the run halves.
    pub origins: Vec<u32>,
    /// Edges and faces level by level. A face of any level that is not [`SplitMark::Split`] is a
    /// leaf.
    pub levels: Vec<Level>,
    /// The view's sharpness, less what the caps took, Q8.
    pub sharpness: u32,
    /// The first level whose splits were dropped because a cap was reached.
    pub capped: Option<u32>,
}

impl RefinedGround {
    /// The edge that a vertex halves, in the level before its own; `None` for a vertex of the control
    /// mesh.
    pub fn origin(&self, vertex: u32) -> Option<u32> {
        let place = (vertex as usize).checked_sub(self.vertices.base().len())?;
        Some(self.origins[place])
    }

    /// The ends of the edge that a vertex halves; `None` for a vertex of the control mesh.
    pub fn parents(&self, vertex: u32) -> Option<[u32; 2]> {
        let origin = self.origin(vertex)?;
        let above = self.vertices[vertex as usize].level - 1;
        let mesh = &self.levels[usize::from(above)].mesh;
        Some(mesh.edges[origin as usize].vertices)
    }
}

/// Refines the ground for a view. A camera whose ground would pass a cap gets coarser ground
/// everywhere: its sharpness is lowered until all fits, so that the ground under it stays as fine
/// as it can be. A disc, or a camera of the least sharpness, loses the whole level that would pass
/// the cap. The mesh stays whole.
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
    let mut refinement = Refinement {
        base,
        rules,
        view: View {
            sharpness: view.clamped_sharpness(),
            ..*view
        },
        caps,
        finest_edges,
    };
    loop {
        match refinement.run() {
            Ok(ground) => return ground,
            Err(sharpness) => refinement.view.sharpness = sharpness,
        }
    }
}

/// One try to refine the ground for a view.
struct Refinement<'a> {
    base: &'a Base,
    rules: &'a Rules,
    view: View,
    caps: &'a Caps,
    finest_edges: bool,
}

impl Refinement<'_> {
    /// The ground, or the sharpness to try next where it passes a cap.
    fn run(&self) -> Result<RefinedGround, u32> {
        let mut ground = self.start();
        let sight = Sight::new(&self.base.scale, &self.view);
        let finest = self.view.level.min(FINEST);
        for index in 0..finest {
            let level = &mut ground.levels[index as usize];
            let plan = step::mark(&sight, index, level, &ground.vertices);
            if plan.total.children == 0 {
                break;
            }
            let vertices = ground.vertices.len() + plan.total.mids as usize;
            let kept = self.kept(vertices, plan.total.children as usize);
            if kept < Q16 {
                if let Some(sharpness) = self.lowered(kept) {
                    return Err(sharpness);
                }
                unmark(level);
                ground.capped = Some(index);
                break;
            }
            // Without edges nothing can be split further, so only the last level may lack them.
            let edges = self.finest_edges || index + 1 < finest;
            self.grow(index, &plan, &mut ground, edges);
        }
        Ok(ground)
    }

    /// Level 0.
    fn start(&self) -> RefinedGround {
        let items = reach::items(self.base, &self.view);
        RefinedGround {
            scale: self.base.scale,
            vertices: Vertices::new(self.base.vertices.clone()),
            origins: Vec::new(),
            levels: vec![Level::new(self.base.level.clone(), items)],
            sharpness: self.view.sharpness,
            capped: None,
        }
    }

    /// Adds the level after a marked one.
    fn grow(&self, index: u32, plan: &LevelPlan, ground: &mut RefinedGround, edges: bool) {
        let uniform = LevelUniform {
            scale: &self.base.scale,
            rules: self.rules,
            level: index,
        };
        let level = &mut ground.levels[index as usize];
        let (next, halved) = step::grow(uniform, plan, level, &mut ground.vertices, edges);
        ground.origins.extend(halved);
        ground.levels.push(next);
    }

    /// Share of so many vertices and faces that the caps hold, Q16; 1 where they hold all.
    fn kept(&self, vertices: usize, faces: usize) -> i32 {
        let Caps {
            vertices: most_vertices,
            faces: most_faces,
        } = *self.caps;
        share(most_vertices, vertices).min(share(most_faces, faces))
    }

    /// The sharpness at which a share of the ground is left; `None` where it cannot be lowered.
    fn lowered(&self, kept: i32) -> Option<u32> {
        let is_camera = self.view.radius == 0;
        // The ground grows with the square of the sharpness.
        let lower = mul_q16(self.view.sharpness as i32, sqrt_q16(kept).min(MOST_KEPT)) as u32;
        let can_fall = is_camera && self.view.sharpness > SHARPNESS.0;
        can_fall.then_some(lower.max(SHARPNESS.0))
    }
}

/// A share of two numbers of items, Q16, at most 1.
fn share(part: usize, whole: usize) -> i32 {
    let [part, whole] = [part, whole].map(|n| n.min(i32::MAX as usize) as i32);
    ratio(part, whole)
}

/// Makes all faces and edges of a level leaves.
fn unmark(level: &mut Level) {
    for face in &mut level.faces {
        face.mark = SplitMark::Leaf;
    }
    for edge in &mut level.edges {
        edge.mark = SplitMark::Leaf;
    }
}
