//! `pangaea render`: the globe as a PNG file, and the eight orbit views of a machine without a
//! display.

use crate::cli::{RenderArgs, ViewsArgs};
use crate::error::CliError;
use crate::ground::replace_maps;
use crate::inputs::Inputs;
use crate::interrupt;
use crate::landscape::Landscape;
use crate::offscreen::{Offscreen, OffscreenError};
use crate::output::{Files, check_file, print, write_file};
use crate::source::PlanetSource;
use crate::values::CameraSpec;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::io::planet_files;
use bevy_pangaea::io::png::rgb_png;
use bevy_pangaea::math;
use bevy_pangaea::overlay::{Overlay, Raster};
use bevy_pangaea::render::{Globe, from_bevy, to_bevy};
use thiserror::Error;

/// Why there is no picture.
#[derive(Debug, Error)]
pub enum PictureError {
    /// The globe could not be drawn.
    #[error(transparent)]
    Offscreen(#[from] OffscreenError),
    /// The picture could not be encoded.
    #[error("cannot encode the picture: {0}")]
    Encode(String),
}

impl From<PictureError> for CliError {
    fn from(error: PictureError) -> Self {
        Self::Failed(error.to_string())
    }
}

/// Where the eight orbit views are taken from: from four sides, in both hemispheres.
const ORBIT_VIEWS: [(&str, f64, f64); 8] = [
    ("orbit-1", 12.0, 0.0),
    ("orbit-2", -14.0, 45.0),
    ("orbit-3", 20.0, 90.0),
    ("orbit-4", -20.0, 135.0),
    ("orbit-5", 14.0, 180.0),
    ("orbit-6", -12.0, -135.0),
    ("orbit-7-north", 78.0, -90.0),
    ("orbit-8-south", -78.0, -45.0),
];

/// Altitude below which a camera sees the ground, metres.
const GROUND_BELOW_M: f64 = 1e6;

/// Height of the orbit in planet radii.
const ORBIT_ALTITUDE: f64 = 2.1;

/// Size of the orbit views in pixels.
const ORBIT_SIZE: (u32, u32) = (1280, 720);

/// Draws the picture that `pangaea render` is asked for, and writes it.
///
/// # Errors
/// [`CliError`]; nothing is written then.
pub fn render(args: &RenderArgs) -> Result<(), CliError> {
    interrupt::watch();
    // All that can be refused is refused before the planet grows.
    let source = PlanetSource::new(args.planet.as_deref(), &args.growth)?;
    let climate = args.climate.load()?;
    check_file(&args.out, &inputs(args))?;
    let radius = source.radius();
    let view = view(&args.camera, radius);
    let mut offscreen = Offscreen::new(args.size).map_err(PictureError::from)?;
    let mut planet = source.planet()?;
    replace_maps(&mut planet.climate, &climate);
    offscreen.show(planet);
    let picture = if sees_ground(args) {
        offscreen.landscape(view, &landscape(args, radius, &view))
    } else {
        let globe = Globe {
            overlay: args.overlay.unwrap_or(Overlay::Elevation),
            sun: sun(&view),
            ..default()
        };
        offscreen.picture(view, globe)
    };
    // An interrupt is the reason that is told.
    interrupt::check()?;
    let picture = picture.map_err(PictureError::from)?;
    write_file(&args.out, &png(&picture)?)
}

/// Whether the picture is one of the ground: the camera is low, and no overlay is asked for.
fn sees_ground(args: &RenderArgs) -> bool {
    args.overlay.is_none() && args.camera.altitude_m < GROUND_BELOW_M
}

/// The ground as the picture shows it.
fn landscape(args: &RenderArgs, radius: f64, view: &Transform) -> Landscape {
    let CameraSpec {
        lat,
        lon,
        altitude_m,
        ..
    } = args.camera;
    Landscape {
        up: math::direction(lat, lon),
        place: math::direction(lat, lon) * (1000.0 * radius + altitude_m),
        altitude_m,
        sun: sun(view),
        pixels: args.pixels,
        colours: args.colours,
        wireframe: args.wireframe,
    }
}

/// The files that are read: those of a planet or of a recipe, and the maps.
fn inputs(args: &RenderArgs) -> Inputs {
    let planet = args.planet.as_deref().map(planet_files);
    let planet = planet.into_iter().flatten();
    Inputs::new(
        planet
            .chain(args.growth.files())
            .chain(args.climate.files()),
    )
}

/// Grows a planet, draws it from eight sides, and says where the pictures are.
///
/// # Errors
/// [`CliError`]; nothing is written then.
pub fn views(args: &ViewsArgs) -> Result<(), CliError> {
    interrupt::watch();
    let source = PlanetSource::new(None, &args.growth)?;
    let names = ORBIT_VIEWS.map(|(name, ..)| format!("{name}.png"));
    // The adapter and the folder are tried before the planet grows.
    let inputs = Inputs::new(args.growth.files());
    let mut files = Files::new(&args.out, &names, None, &inputs)?;
    let mut offscreen = Offscreen::new(ORBIT_SIZE).map_err(PictureError::from)?;
    let radius = source.radius();
    offscreen.show(source.planet()?);
    for (name, (_, lat, lon)) in names.iter().zip(ORBIT_VIEWS) {
        let picture = orbit_view(&mut offscreen, radius, lat, lon);
        interrupt::check()?;
        files.add(name, picture?);
    }
    let list: String = files
        .write()?
        .iter()
        .map(|path| format!("{}\n", path.display()))
        .collect();
    print(&list)
}

/// The planet that is on show, from an orbit above `lat` and `lon`, as a PNG file.
fn orbit_view(
    offscreen: &mut Offscreen,
    radius: f64,
    lat: f64,
    lon: f64,
) -> Result<Vec<u8>, PictureError> {
    let altitude_m = ORBIT_ALTITUDE * radius * 1000.0;
    let camera = CameraSpec {
        lat,
        lon,
        altitude_m,
        heading: 0.0,
        pitch: -90.0,
    };
    let view = view(&camera, radius);
    let globe = Globe {
        overlay: Overlay::Elevation,
        sun: sun(&view),
        ..default()
    };
    png(&offscreen.picture(view, globe)?)
}

/// Where the camera stands and looks on a planet of `radius` km.
///
/// Heading is clockwise from north, pitch above the horizon; -90 looks straight down, with the
/// heading up.
fn view(camera: &CameraSpec, radius: f64) -> Transform {
    let up = math::direction(camera.lat, camera.lon);
    // At a pole the longitude says which way is east.
    let east = math::direction(0.0, camera.lon + 90.0);
    let north = up.cross(east);
    let (sin, cos) = math::sin_cos(camera.heading.to_radians());
    let ahead = north * cos + east * sin;
    let right = east * cos - north * sin;
    let (sin, cos) = math::sin_cos(camera.pitch.to_radians());
    let forward = ahead * cos + up * sin;
    let top = right.cross(forward);
    let axes = Mat3::from_cols(to_bevy(right), to_bevy(top), to_bevy(-forward));
    Transform {
        translation: to_bevy(up * (1.0 + camera.altitude_m / (1000.0 * radius))),
        rotation: Quat::from_mat3(&axes).normalize(),
        scale: Vec3::ONE,
    }
}

/// Direction of a sun behind the camera's left shoulder: the terminator is seen, two thirds of the
/// disc are lit.
fn sun(view: &Transform) -> DVec3 {
    let up = view.translation.normalize();
    let left = view.rotation * Vec3::NEG_X;
    let side = (left - up * left.dot(up)).normalize_or(up.any_orthonormal_vector());
    from_bevy(0.62 * up + 0.7 * side + 0.35 * side.cross(up)).normalize()
}

fn png(raster: &Raster) -> Result<Vec<u8>, PictureError> {
    rgb_png(raster).map_err(|error| PictureError::Encode(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(lat: f64, lon: f64, heading: f64, pitch: f64) -> Transform {
        view(
            &CameraSpec {
                lat,
                lon,
                altitude_m: 6_370_000.0,
                heading,
                pitch,
            },
            6370.0,
        )
    }

    #[test]
    fn a_camera_over_africa_looks_down_with_north_up() {
        let view = camera(0.0, 0.0, 0.0, -90.0);
        assert!((view.translation - Vec3::new(2.0, 0.0, 0.0)).length() < 1e-6);
        assert!((*view.forward() - Vec3::NEG_X).length() < 1e-6);
        assert!((*view.up() - Vec3::Y).length() < 1e-6);
        // East (planet +y) is to the right.
        assert!((*view.right() - to_bevy(DVec3::Y)).length() < 1e-6);
    }

    #[test]
    fn heading_and_pitch_turn_the_view() {
        let east = camera(0.0, 0.0, 90.0, 0.0);
        assert!((*east.forward() - to_bevy(DVec3::Y)).length() < 1e-6);
        assert!((*east.up() - Vec3::X).length() < 1e-6);
        let pole = camera(90.0, 0.0, 0.0, -90.0);
        assert!((*pole.forward() - Vec3::NEG_Y).length() < 1e-6 && pole.rotation.is_finite());
    }

    #[test]
    fn the_sun_lights_what_the_camera_sees() {
        for (lat, lon) in [(0.0, 0.0), (60.0, 100.0), (-90.0, 0.0)] {
            let view = camera(lat, lon, 30.0, -90.0);
            let sun = to_bevy(sun(&view));
            let lit = sun.dot(view.translation.normalize());
            assert!((0.5..0.8).contains(&lit), "{lit}");
            assert!(sun.dot(*view.left()) > 0.5 && sun.dot(*view.up()) > 0.2);
        }
    }
}
