//! The ground's own triangles around a point: the collider that fits what is drawn, to the last
//! bit.

use super::check::{check_length, checked};
use super::error::GroundError;
use super::patch::Patch;
use super::planet::{PlanetGround, quantised};
use crate::math::east_north;
use bevy::math::{DVec2, DVec3};
use core::f64::consts::FRAC_1_SQRT_2;
use pangaea_shaders::amplify::carve::{CarveCache, carve};
use pangaea_shaders::amplify::fixed::{GRAINS, Q16};
use pangaea_shaders::amplify::ground::{Caps, RefinedGround, refine_faces};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::show::show;
use pangaea_shaders::amplify::topology::{Face, Level, SplitMark};

/// Most edges of a level along the side of a collider: two and a half million triangles, or eight
/// times as many where they are small.
const MAX_EDGES: f64 = 1000.0;

/// Shortest side of a collider in m.
const SHORTEST_M: f64 = 1e-3;

/// How far around the square is refined, in edges of the level before. Triangles are of all sizes:
/// the first is nearly always enough.
const MARGINS_EDGES: [f64; 4] = [0.0, 2.0, 6.0, 20.0];

/// By how much corners may move when they become f32, relative to the largest coordinate.
const ROUNDING: f64 = 2.0 * f32::EPSILON as f64;

impl PlanetGround {
    /// The triangles of a level that reach into the square of `side_m` around a direction of any
    /// length; its sides run east and north. They cover it all: a body that falls towards the
    /// planet's centre from above the square hits one. Every corner is a vertex of the ground, so
    /// colliders of neighbouring squares fit together.
    ///
    /// ```
    /// use bevy::math::DVec3;
    /// use bevy_pangaea::query::{PlanetGround, Rules};
    /// use pangaea_shaders::amplify::synthetic::control_mesh;
    ///
    /// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
    /// let patch = ground.collider(DVec3::new(0.2, 0.5, 0.3), 2000.0, 12)?;
    /// let below = patch.triangles.iter().flatten().all(|&i| (i as usize) < patch.positions.len());
    /// assert!(below && !patch.triangles.is_empty());
    /// # Ok::<(), bevy_pangaea::query::GroundError>(())
    /// ```
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`]; [`GroundError::Length`] for a side
    /// shorter than 1 mm or longer than 1000 edges of the level or half the planet's radius, and
    /// for one with too many triangles.
    pub fn collider(&self, direction: DVec3, side_m: f64, level: u8) -> Result<Patch, GroundError> {
        const WHAT: &str = "the side of the collider";
        let up = checked(direction, level)?;
        let radius = f64::from(self.base().scale.radius_m);
        // The planet's edge is in sixteenths of a metre.
        let edge = f64::from(self.base().scale.edge) / 16.0 / f64::from(1_u32 << level);
        let longest = (MAX_EDGES * edge).min(0.5 * radius);
        check_length(WHAT, side_m, [SHORTEST_M, longest])?;
        let square = TangentSquare::new(up, radius, side_m);
        // Where a refinement leaves a hole in the square, a wider one is tried.
        for margin in MARGINS_EDGES {
            let refined = self.refined(&square, 2.0 * margin * edge, level);
            if refined.capped.is_some() {
                return Err(GroundError::Length {
                    what: WHAT,
                    value: side_m,
                    min: SHORTEST_M,
                    // Half the side has a quarter of the triangles.
                    max: 0.5 * side_m,
                });
            }
            if let Some(patch) = self.cut(&refined, &square, level) {
                return Ok(patch);
            }
        }
        Err(GroundError::Unavailable(
            "the ground's triangles are too uneven for a collider".into(),
        ))
    }

    /// The ground of a square and of `margin` m around it.
    fn refined(&self, square: &TangentSquare, margin: f64, level: u8) -> RefinedGround {
        let sides = [square.east, square.north];
        let sides = sides.map(|side| (side * f64::from(Q16)).round().to_array().map(|x| x as i32));
        // The view is a circle: it must hold the corners of the square.
        let reach = ((square.half + margin) / FRAC_1_SQRT_2).ceil() as u32;
        let view = View::square(quantised(square.up), sides, reach, u32::from(level));
        refine_faces(self.base(), self.rules(), &view, &Caps::default())
    }

    /// The finest triangles of a refinement that reach into a square, with the corners they use;
    /// `None` if a part of the square was not refined so far.
    fn cut(&self, refined: &RefinedGround, square: &TangentSquare, level: u8) -> Option<Patch> {
        let places = PlanePlaces::new(refined, square);
        let meets = |face: &Face| square.meets(face.vertices.map(|v| places.of(v)));
        let levels = refined.levels.get(..=usize::from(level))?;
        let (finest, coarser) = levels.split_last()?;
        // Where a coarser triangle was not split the finest ones do not cover the square.
        let mut unsplit = coarser
            .iter()
            .flat_map(Level::faces)
            .filter(|(_, split)| split.mark != SplitMark::Split);
        if unsplit.any(|(face, _)| meets(face)) {
            return None;
        }
        let at = quantised(square.up);
        let height = self.leaf_at(at, level).height_m(at);
        let origin = square.up * (square.radius + height);
        let mut builder = PatchBuilder::new(refined, self.rules(), square.radius, origin);
        for (face, _) in finest.faces().filter(|(face, _)| meets(face)) {
            builder.push(face);
        }
        Some(builder.patch)
    }
}

/// Places in a square's plane of the vertices of a refinement, as [`TangentSquare::place`] has them.
struct PlanePlaces<'a> {
    refined: &'a RefinedGround,
    square: &'a TangentSquare,
    /// Of the vertices that the refinement made. Those of the control mesh are many, and few are
    /// asked for.
    grown: Vec<Option<DVec2>>,
}

impl<'a> PlanePlaces<'a> {
    fn new(refined: &'a RefinedGround, square: &'a TangentSquare) -> Self {
        let grown = refined.vertices.grown().iter();
        Self {
            refined,
            square,
            grown: grown.map(|v| square.place(v.direction)).collect(),
        }
    }

    fn of(&self, vertex: u32) -> Option<DVec2> {
        let base = self.refined.vertices.base();
        match base.get(vertex as usize) {
            Some(vertex) => self.square.place(vertex.direction),
            None => self.grown[vertex as usize - base.len()],
        }
    }
}

/// A patch that grows by faces of a refinement.
struct PatchBuilder<'a> {
    refined: &'a RefinedGround,
    rules: &'a Rules,
    radius_m: f64,
    kept: CarveCache,
    /// Number in the patch of every vertex, or `u32::MAX`.
    numbers: Vec<u32>,
    patch: Patch,
}

impl<'a> PatchBuilder<'a> {
    fn new(refined: &'a RefinedGround, rules: &'a Rules, radius_m: f64, origin: DVec3) -> Self {
        Self {
            refined,
            rules,
            radius_m,
            kept: CarveCache::default(),
            numbers: vec![u32::MAX; refined.vertices.len()],
            patch: Patch {
                origin,
                positions: Vec::new(),
                triangles: Vec::new(),
            },
        }
    }

    fn push(&mut self, face: &Face) {
        let corners = face.vertices.map(|v| self.number(v));
        self.patch.triangles.push(corners);
    }

    /// The number of a vertex in the patch, which gets its position when it is met first.
    fn number(&mut self, v: u32) -> u32 {
        let known = self.numbers[v as usize];
        if known != u32::MAX {
            return known;
        }
        let number = self.patch.positions.len() as u32;
        self.numbers[v as usize] = number;
        let vertex = &self.refined.vertices[v as usize];
        let scale = &self.refined.scale;
        let carved = carve(&mut self.kept, scale, self.rules, vertex);
        // The patch is cut from the finest level of its refinement.
        let level = self.refined.levels.len() as u32 - 1;
        let ground = show(scale, self.rules, vertex, carved, level).ground;
        // Rounding lets directions leave the sphere by up to 5 cm.
        let unit = DVec3::from_array(vertex.direction.map(f64::from)).normalize();
        let place = unit * (self.radius_m + f64::from(ground) / f64::from(GRAINS));
        let position = (place - self.patch.origin).as_vec3();
        self.patch.positions.push(position);
        number
    }
}

/// A square of the plane that touches the sea level at a point, as seen from the planet's centre:
/// there edges are straight whatever their ends' heights.
struct TangentSquare {
    up: DVec3,
    east: DVec3,
    north: DVec3,
    /// Radius of the planet in m.
    radius: f64,
    /// Half the side in m.
    half: f64,
}

impl TangentSquare {
    fn new(up: DVec3, radius: f64, side: f64) -> Self {
        let (east, north) = east_north(up);
        Self {
            up,
            east,
            north,
            radius,
            half: 0.5 * side,
        }
    }

    /// Where the line from the centre along a direction meets the plane, m to the east and to the
    /// north; `None` where it leads away.
    fn place(&self, direction: [i32; 3]) -> Option<DVec2> {
        let direction = DVec3::from_array(direction.map(f64::from));
        let ahead = direction.dot(self.up);
        let flat = DVec2::new(direction.dot(self.east), direction.dot(self.north));
        (ahead > 0.0).then(|| flat * (self.radius / ahead))
    }

    /// Whether a triangle reaches into the square: no side of either separates them (the theorem of
    /// separating axes). No edge of a control mesh is so long that a triangle could have a corner
    /// behind the planet, and another in a square.
    fn meets(&self, corners: [Option<DVec2>; 3]) -> bool {
        let [Some(a), Some(b), Some(c)] = corners else {
            return false;
        };
        let reach = a.abs().max(b.abs()).max(c.abs()).max_element();
        // Grown by what corners may move, or a body could fall between two colliders.
        let half = self.half + ROUNDING * reach;
        let sides = [(b - a).perp(), (c - b).perp(), (a - c).perp()];
        let axes = [DVec2::X, DVec2::Y].into_iter().chain(sides);
        !axes
            .into_iter()
            .any(|axis| separates(axis, [a, b, c], half))
    }
}

/// Whether a triangle and the square of half a side about the origin lie apart along an axis.
fn separates(axis: DVec2, triangle: [DVec2; 3], half: f64) -> bool {
    let [x, y, z] = triangle.map(|corner| corner.dot(axis));
    let most = half * (axis.x.abs() + axis.y.abs());
    x.min(y).min(z) > most || x.max(y).max(z) < -most
}

#[cfg(test)]
#[path = "collider_tests.rs"]
mod tests;
