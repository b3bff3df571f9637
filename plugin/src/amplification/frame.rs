//! Where a camera stands in the planet's axes, and what it sees.

use super::view::GroundView;
use crate::render::from_bevy;
use bevy::math::{DMat3, DQuat, DVec3};
use bevy::prelude::*;
use pangaea_shaders::amplify::fixed::{ONE, Q16};
use pangaea_shaders::amplify::ground::FINEST;
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::scale::PlanetScale;
use pangaea_shaders::gpu::GroundCamera;

/// A camera in the axes of a planet.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlanetFrame {
    /// From the planet's axes to the camera's: right, up, backwards.
    axes: DMat3,
    /// The camera's place from the planet's centre, metres.
    place: DVec3,
    /// Units of the world in a metre.
    metre: f64,
}

/// The lens of a camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    pub(super) clip_from_view: Mat4,
    /// Pixels from the bottom to the top.
    pub(super) height: f32,
}

impl PlanetFrame {
    /// The camera of a view over a planet of a radius in metres; `None` where a number is no
    /// number, or the planet is flat.
    pub(super) fn new(
        view: &GroundView,
        camera: &GlobalTransform,
        planet: &GlobalTransform,
        radius_m: f64,
    ) -> Option<Self> {
        let (scale, turn, centre) = planet.to_scale_rotation_translation();
        let metre = f64::from(scale.x) / radius_m;
        let from_world = dquat(turn.inverse());
        let off = (camera.translation() - centre).as_dvec3();
        let seen = || from_bevy_exact(from_world * off) / metre;
        let place = view.place.unwrap_or_else(seen);
        let to_camera = dquat(camera.rotation().inverse()) * dquat(turn);
        let axes = DMat3::from_cols(
            to_camera * DVec3::X,
            to_camera * DVec3::NEG_Z,
            to_camera * DVec3::Y,
        );
        let is_whole = place.is_finite() && axes.is_finite() && metre.is_finite();
        let is_outside = place.length() > radius_m / 2.0 && metre > 0.0;
        (is_whole && is_outside).then_some(Self { axes, place, metre })
    }

    /// The view that the ground is refined for.
    pub(super) fn view(&self, view: &GroundView, lens: &Lens, scale: &PlanetScale) -> View {
        let up = self.place.normalize();
        let direction = up.to_array().map(|x| (x * f64::from(ONE)).round() as i32);
        let altitude = (self.place.length() - f64::from(scale.radius_m)).max(0.0) as u32;
        // The camera looks along its -z.
        let ahead = -(self.axes.transpose() * DVec3::Z);
        let [x, y] = [lens.clip_from_view.x_axis.x, lens.clip_from_view.y_axis.y].map(f64::from);
        let diagonal = (1.0 / (x * x) + 1.0 / (y * y)).sqrt();
        let pixel = 2.0 / (y * f64::from(lens.height.max(1.0)));
        let edge = f64::from(view.pixels.clamp(1.0, 64.0));
        View {
            forward: ahead.to_array().map(|x| (x * f64::from(Q16)) as i32),
            field: (f64::from(Q16) / (1.0 + diagonal * diagonal).sqrt()) as i32,
            sharpness: (256.0 / (pixel * edge)).min(most_sharpness(view.leaves)) as u32,
            ..View::camera(scale, direction, altitude, FINEST)
        }
    }

    /// The camera that it is drawn for.
    pub(super) fn camera(&self, view: &GroundView, lens: &Lens) -> GroundCamera {
        let turn = Mat4::from_mat3(self.axes.as_mat3());
        let sun = view.sun.try_normalize().unwrap_or(DVec3::Z);
        GroundCamera {
            clip_from_planet: (lens.clip_from_view * turn).to_cols_array_2d(),
            position: self.place.to_array(),
            metre: self.metre as f32,
            sun: sun.as_vec3().to_array(),
            colours: view.colours,
            wireframe: view.wireframe,
        }
    }
}

/// Sharpness, Q8, at which no view of a grown planet has more leaves. They grow with its square; from
/// two metres over the ground, whence the most are seen, a camera of 60 degrees has 2.1 million at 117.
fn most_sharpness(leaves: u32) -> f64 {
    256.0 * 117.0 * (f64::from(clamped(leaves)) / 2.1e6).sqrt()
}

/// Leaves within their limits.
pub(super) fn clamped(leaves: u32) -> u32 {
    leaves.clamp(50_000, 4_000_000)
}

fn dquat(turn: Quat) -> DQuat {
    turn.as_dquat().normalize()
}

/// [`from_bevy`] of numbers of 64 bits.
fn from_bevy_exact(v: DVec3) -> DVec3 {
    debug_assert!(from_bevy(Vec3::Y) == DVec3::Z);
    DVec3::new(v.x, -v.z, v.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pangaea_shaders::amplify::synthetic::control_mesh;

    const RADIUS_M: f64 = 6_371_000.0;

    fn lens() -> Lens {
        Lens {
            clip_from_view: Mat4::perspective_infinite_reverse_rh(1.0, 16.0 / 9.0, 0.1),
            height: 1080.0,
        }
    }

    /// A camera over the planet's equator that looks north.
    fn frame(place: Option<DVec3>) -> (GroundView, PlanetFrame) {
        let view = GroundView {
            place,
            ..GroundView::of(Entity::PLACEHOLDER)
        };
        let camera = Transform::from_translation(Vec3::X * 1.001).looking_to(Vec3::Y, Vec3::X);
        let camera = GlobalTransform::from(camera);
        let frame = PlanetFrame::new(&view, &camera, &GlobalTransform::IDENTITY, RADIUS_M);
        (view, frame.expect("a camera outside"))
    }

    #[test]
    fn a_camera_stands_where_its_transform_says() {
        let (view, frame) = frame(None);
        assert!((frame.place - DVec3::X * 1.001 * RADIUS_M).length() < 1.0);
        let scale = PlanetScale::new(&control_mesh(RADIUS_M as u32, 2, 1));
        let seen = frame.view(&view, &lens(), &scale);
        // North is the planet's +z.
        let [x, y, z] = seen.forward;
        assert!(x.abs() < 3 && y.abs() < 3 && (z - Q16).abs() < 3);
        assert_eq!(seen.altitude.map(|altitude| altitude / 160), Some(637));
        // Edges of 8 pixels: half the picture is tan 0.5 = 0.5463 high.
        let pixel = 2.0 * 0.546_302_5 / 1080.0;
        assert!((f64::from(seen.sharpness) / 256.0 - 1.0 / (8.0 * pixel)).abs() < 0.1);
    }

    /// The sharpness of a camera with edges of so many pixels, and so many leaves.
    fn sharpness(pixels: f32, leaves: u32) -> f64 {
        let scale = PlanetScale::new(&control_mesh(RADIUS_M as u32, 2, 1));
        let (mut view, frame) = frame(None);
        (view.pixels, view.leaves) = (pixels, leaves);
        f64::from(frame.view(&view, &lens(), &scale).sharpness) / 256.0
    }

    #[test]
    fn ground_is_no_sharper_than_its_leaves_allow() {
        assert!((sharpness(1.0, 2_100_000) - 117.0).abs() < 0.1);
        assert!((sharpness(1.0, 525_000) - 58.5).abs() < 0.1);
        assert!(sharpness(64.0, 2_100_000) < 20.0);
    }

    #[test]
    fn a_place_of_its_own_comes_before_the_transform() {
        let place = DVec3::new(0.0, 0.0, RADIUS_M + 12.25);
        assert_eq!(frame(Some(place)).1.place, place);
    }

    #[test]
    fn ground_ahead_is_in_the_middle_of_the_picture() {
        let (view, frame) = frame(None);
        let camera = frame.camera(&view, &lens());
        let matrix = Mat4::from_cols_array_2d(&camera.clip_from_planet);
        let clip = matrix * Vec4::new(0.0, 0.0, 100.0, 1.0);
        let on_screen = clip.truncate() / clip.w;
        assert!(on_screen.x.abs() < 1e-4 && on_screen.y.abs() < 1e-4 && clip.w > 0.0);
        // What is farther from the centre is higher in the picture.
        let above = matrix * Vec4::new(10.0, 0.0, 100.0, 1.0);
        assert!(above.y > 0.0);
    }

    #[test]
    fn no_number_and_no_planet_have_no_frame() {
        let view = GroundView {
            place: Some(DVec3::NAN),
            ..GroundView::of(Entity::PLACEHOLDER)
        };
        let here = GlobalTransform::IDENTITY;
        assert!(PlanetFrame::new(&view, &here, &here, RADIUS_M).is_none());
        let flat = GlobalTransform::from(Transform::from_scale(Vec3::ZERO));
        let view = GroundView::of(Entity::PLACEHOLDER);
        assert!(PlanetFrame::new(&view, &here, &flat, RADIUS_M).is_none());
    }
}
