//! The ground's own triangles around a point: the collider that fits what is drawn, to the last bit.

use super::ground::east_north;
use super::patch::Patch;
use super::planet::quantised;
use super::{GroundError, PlanetGround, checked, spacing};
use bevy::math::DVec3;
use pangaea_shaders::amplify::carve::{Kept, carve};
use pangaea_shaders::amplify::fixed::{GRAINS, ONE, Q16};
use pangaea_shaders::amplify::ground::{Caps, Ground as Refined, refine_faces};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::vertex::Vertex;

/// Most edges of a level along the side of a collider: some ten million triangles.
const MOST_EDGES: f64 = 2000.0;

impl PlanetGround {
    /// The triangles of a level that reach into the square of `side_m` around a direction of any length; its sides run
    /// east and north. Every corner is a vertex of the ground, so colliders of neighbouring squares fit together.
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`]; [`GroundError::Length`] for a side shorter than 1 mm or
    /// longer than 2000 edges of the level.
    pub fn collider(&self, direction: DVec3, side_m: f64, level: u8) -> Result<Patch, GroundError> {
        let up = checked(direction, level)?;
        let radius = f64::from(self.base().planet.radius_m);
        let (min, max) = (1e-3, (MOST_EDGES * spacing(radius, level)).min(0.5 * radius));
        if !(min..=max).contains(&side_m) {
            return Err(GroundError::Length { what: "the side of the collider", value: side_m, min, max });
        }
        let (east, north) = east_north(up);
        let reach = (side_m * core::f64::consts::FRAC_1_SQRT_2).ceil() as u32;
        let sides = [east, north].map(|side| (side * f64::from(Q16)).round().to_array().map(|x| x as i32));
        let at = quantised(up);
        let view = View::square(at, sides, reach, u32::from(level));
        let refined = refine_faces(self.base(), self.rules(), &view, &Caps::default());
        let origin = up * (radius + self.leaf_at(at, level).height_m(at));
        Ok(self.cut(&refined, origin, side_m, level))
    }

    /// The finest triangles of a refinement that reach into a square around `origin`, with the corners they use.
    fn cut(&self, refined: &Refined, origin: DVec3, side_m: f64, level: u8) -> Patch {
        let radius = f64::from(self.base().planet.radius_m);
        let (east, north) = east_north(origin.normalize());
        let mut patch = Patch { origin, positions: Vec::new(), triangles: Vec::new() };
        let Some(finest) = refined.levels.get(usize::from(level)) else { return patch };
        let within = |vertex: &Vertex| {
            let offset =
                DVec3::from_array(vertex.direction.map(f64::from)) * (radius / f64::from(ONE)) - origin;
            offset.dot(east).abs().max(offset.dot(north).abs()) <= 0.5 * side_m
        };
        let within: Vec<bool> = refined.vertices.iter().map(within).collect();
        let mut kept = Kept::default();
        let mut place = |v: u32| {
            let vertex = &refined.vertices[v as usize];
            let ground = carve(&mut kept, &refined.planet, self.rules(), vertex).ground;
            // Rounding lets directions leave the sphere by up to 5 cm.
            let unit = DVec3::from_array(vertex.direction.map(f64::from)).normalize();
            (unit * (radius + f64::from(ground) / f64::from(GRAINS)) - origin).as_vec3()
        };
        let mut numbers = vec![u32::MAX; refined.vertices.len()];
        for face in finest.faces.iter().filter(|f| f.vertices.iter().any(|&v| within[v as usize])) {
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
        patch
    }
}
