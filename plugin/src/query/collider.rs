//! The ground's own triangles around a point: the collider that fits what is drawn, to the last
//! bit.

use super::patch::Patch;
use super::planet::quantised;
use super::{GroundError, PlanetGround, checked};
use crate::math::east_north;
use bevy::math::{DVec2, DVec3};
use core::f64::consts::FRAC_1_SQRT_2;
use pangaea_shaders::amplify::carve::{OceanCache, carve};
use pangaea_shaders::amplify::fixed::{GRAINS, Q16};
use pangaea_shaders::amplify::ground::{Caps, RefinedGround, refine_faces};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::topology::{Face, SplitMark};

/// Most edges of a level along the side of a collider: two and a half million triangles, where they
/// are small eight.
const MOST_EDGES: f64 = 1000.0;

/// How far around the square is refined, in edges of the level before. Triangles are of all sizes:
/// the first is nearly always enough.
const MARGINS: [f64; 4] = [0.0, 2.0, 6.0, 20.0];

impl PlanetGround {
    /// The triangles of a level that reach into the square of `side_m` around a direction of any
    /// length; its sides run east and north. They cover it all: whatever falls towards the planet's
    /// centre from above the square hits one. Every corner is a vertex of the ground, so colliders
    /// of neighbouring squares fit together.
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`]; [`GroundError::Length`] for a side
    /// shorter than 1 mm or longer than 1000 edges of the level or half the planet's radius, and
    /// for one with too many triangles.
    pub fn collider(&self, direction: DVec3, side_m: f64, level: u8) -> Result<Patch, GroundError> {
        let up = checked(direction, level)?;
        let radius = f64::from(self.base().scale.radius_m);
        let edge = f64::from(self.base().scale.edge) / 16.0 / f64::from(1_u32 << level);
        let (min, max) = (1e-3, (MOST_EDGES * edge).min(0.5 * radius));
        let refused = |max| GroundError::Length {
            what: "the side of the collider",
            value: side_m,
            min,
            max,
        };
        if !(min..=max).contains(&side_m) {
            return Err(refused(max));
        }
        let square = Square::new(up, radius, side_m);
        for margin in MARGINS {
            let refined = self.refined(&square, 2.0 * margin * edge, level);
            if refined.capped.is_some() {
                // Half the side has a quarter of the triangles.
                return Err(refused(0.5 * side_m));
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
    fn refined(&self, square: &Square, margin: f64, level: u8) -> RefinedGround {
        let side = |side: DVec3| (side * f64::from(Q16)).round().to_array().map(|x| x as i32);
        let reach = ((square.half + margin) / FRAC_1_SQRT_2).ceil() as u32;
        let sides = [side(square.east), side(square.north)];
        let view = View::square(quantised(square.up), sides, reach, u32::from(level));
        refine_faces(self.base(), self.rules(), &view, &Caps::default())
    }

    /// The finest triangles of a refinement that reach into a square, with the corners they use;
    /// none if some of the square was not refined so far.
    fn cut(&self, refined: &RefinedGround, square: &Square, level: u8) -> Option<Patch> {
        let places: Vec<_> = refined
            .vertices
            .iter()
            .map(|v| square.place(v.direction))
            .collect();
        let meets = |face: &&Face| square.meets(face.vertices.map(|v| places[v as usize]));
        let (finest, coarser) = refined.levels.get(..=usize::from(level))?.split_last()?;
        let mut leaves = coarser
            .iter()
            .flat_map(|level| &level.faces)
            .filter(|f| f.mark != SplitMark::Split);
        if leaves.any(|face| meets(&face)) {
            return None;
        }
        let height = self
            .leaf_at(quantised(square.up), level)
            .height_m(quantised(square.up));
        let origin = square.up * (square.radius + height);
        let mut patch = Patch {
            origin,
            positions: Vec::new(),
            triangles: Vec::new(),
        };
        let mut kept = OceanCache::default();
        let mut place = |v: u32| {
            let vertex = &refined.vertices[v as usize];
            let ground = carve(&mut kept, &refined.scale, vertex).ground;
            // Rounding lets directions leave the sphere by up to 5 cm.
            let unit = DVec3::from_array(vertex.direction.map(f64::from)).normalize();
            (unit * (square.radius + f64::from(ground) / f64::from(GRAINS)) - origin).as_vec3()
        };
        let mut numbers = vec![u32::MAX; refined.vertices.len()];
        for face in finest.faces.iter().filter(meets) {
            let corners = face.vertices.map(|v| {
                let number = &mut numbers[v as usize];
                if *number == u32::MAX {
                    *number = patch.positions.len() as u32;
                    patch.positions.push(place(v));
                }
                *number
            });
            patch.triangles.push(corners);
        }
        Some(patch)
    }
}

/// A square of the plane that touches the sea level at a point, as seen from the planet's centre:
/// there edges are straight whatever their ends' heights.
struct Square {
    up: DVec3,
    east: DVec3,
    north: DVec3,
    radius: f64,
    half: f64,
}

/// By how much corners may move when they become f32, relative to the largest coordinate.
const ROUNDING: f64 = 2.0 * f32::EPSILON as f64;

impl Square {
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
    /// north; none where it leads away.
    fn place(&self, direction: [i32; 3]) -> Option<DVec2> {
        let direction = DVec3::from_array(direction.map(f64::from));
        let ahead = direction.dot(self.up);
        let flat = DVec2::new(direction.dot(self.east), direction.dot(self.north));
        (ahead > 0.0).then(|| flat * (self.radius / ahead))
    }

    /// Whether a triangle reaches into the square: no side of either keeps them apart. (No edge of
    /// a control mesh is so long that a triangle could have a corner behind the planet, and another
    /// in a square.)
    fn meets(&self, corners: [Option<DVec2>; 3]) -> bool {
        let [Some(a), Some(b), Some(c)] = corners else {
            return false;
        };
        let reach = a.abs().max(b.abs()).max(c.abs()).max_element();
        let half = self.half + ROUNDING * reach;
        let apart = |axis: DVec2| {
            let [x, y, z] = [a, b, c].map(|corner| corner.dot(axis));
            let most = half * (axis.x.abs() + axis.y.abs());
            x.min(y).min(z) > most || x.max(y).max(z) < -most
        };
        ![
            DVec2::X,
            DVec2::Y,
            (b - a).perp(),
            (c - b).perp(),
            (a - c).perp(),
        ]
        .into_iter()
        .any(apart)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::{Ground, PatchTree};
    use crate::random::{Purpose, Stream};
    use pangaea_shaders::amplify::rules::Rules;
    use pangaea_shaders::amplify::synthetic::control_mesh;

    fn ground() -> PlanetGround {
        PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default()).unwrap()
    }

    /// The longest side of a level, as its error has it.
    fn longest(ground: &PlanetGround, level: u8) -> f64 {
        match ground.collider(DVec3::X, f64::INFINITY, level) {
            Err(GroundError::Length { max, .. }) => max,
            other => panic!("{other:?}"),
        }
    }

    /// Lets points fall on a collider from above its square, corners included.
    fn assert_covered(ground: &PlanetGround, up: DVec3, side: f64, level: u8) {
        let up = up.normalize();
        let patch = ground.collider(up, side, level).unwrap();
        let tree = PatchTree::new(patch).unwrap();
        let (east, north) = east_north(up);
        let stream = Stream::new(7, Purpose::ReliefSites, 0);
        for k in 0..200 {
            let share = |n: u64| match k {
                0..4 => 0.4999 * if (k >> n) & 1 == 0 { 1.0 } else { -1.0 },
                _ => stream.unit(2 * k + n) - 0.5,
            };
            let place = up * ground.radius_m() + (east * share(0) + north * share(1)) * side;
            let down = -place.normalize();
            let hit = tree
                .cast(down * -(ground.radius_m() + 3e5), down, 6e5)
                .unwrap();
            assert!(
                hit.is_some(),
                "a hole in {side} m of level {level} at {up}, {k}"
            );
        }
    }

    #[test]
    fn whatever_falls_on_the_square_hits_the_collider() {
        let ground = ground();
        let stream = Stream::new(8, Purpose::ReliefSites, 0);
        for (side, level) in [
            (0.1, 17),
            (0.001, 17),
            (64.0, 5),
            (64.0, 17),
            (1000.0, 14),
            (1e5, 9),
            (2e6, 3),
        ] {
            for k in 0..8 {
                assert_covered(&ground, stream.direction(2 * k), side, level);
            }
        }
        assert_covered(&ground, DVec3::Z, 64.0, 17);
        assert_covered(&ground, -DVec3::Z, 1e6, 0);
    }

    #[test]
    fn the_longest_side_is_one_that_is_made() {
        let ground = ground();
        assert_eq!(longest(&ground, 3), 0.5 * 6_370_000.0);
        for level in [5, 13] {
            let side = longest(&ground, level);
            assert_covered(&ground, DVec3::new(0.2, -0.5, 0.4), side, level);
        }
    }

    #[test]
    fn a_square_meets_what_crosses_it_and_nothing_else() {
        let square = Square::new(DVec3::X, 1000.0, 2.0);
        let meets =
            |corners: [[f64; 2]; 3]| square.meets(corners.map(|c| Some(DVec2::from_array(c))));
        assert!(
            meets([[-50.0, -50.0], [50.0, -50.0], [0.0, 90.0]]),
            "it lies within"
        );
        assert!(
            meets([[-9.0, 0.1], [9.0, 0.0], [9.0, 0.2]]),
            "a sliver lies across"
        );
        assert!(
            meets([[0.5, 0.5], [9.0, 9.0], [9.0, 8.0]]),
            "a corner lies within"
        );
        assert!(!meets([[1.1, -5.0], [1.1, 5.0], [9.0, 0.0]]), "beside it");
        assert!(
            !meets([[0.0, 2.1], [2.1, 0.0], [9.0, 9.0]]),
            "across a corner"
        );
        assert!(!square.meets([Some(DVec2::ZERO), Some(DVec2::X), None]));
        assert_eq!(square.place([-5, 0, 0]), None);
        assert_eq!(square.place([10, 2, -1]), Some(DVec2::new(200.0, -100.0)));
    }
}
