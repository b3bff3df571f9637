//! The ground under a flight: its height, and when it is drawn instead of the globe.

use super::background::Background;
use super::flight::Flight;
use super::globe::sky;
use super::messages::MessageLog;
use super::orbit::OrbitCamera;
use super::state::{Look, ShownPlanet};
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::amplification::{GroundStatus, GroundView};
use bevy_pangaea::control::{Bake, PlanetBake};
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::{Globe, from_bevy};
use std::sync::Arc;

/// Level of the ground that a camera keeps above.
const LEVEL: u8 = 13;
/// Near plane of the camera that circles the globe, radii.
const ORBIT_NEAR: f64 = 0.01;
/// Leaves of the ground, and pixels of their edges.
const LEAVES: u32 = 1_500_000;
const PIXELS: f32 = 8.0;

/// The ground of the planet on show.
#[derive(Resource, Default)]
pub struct LandBelow {
    ground: Option<(Arc<Bake>, PlanetGround)>,
    job: Option<(Arc<Bake>, Background<PlanetGround>)>,
}

/// Makes the ground of the last bake, in the background, while somebody flies.
pub fn prepare(
    mut land: ResMut<LandBelow>,
    shown: Res<ShownPlanet>,
    flights: Query<(), With<Flight>>,
    bakes: Query<&PlanetBake>,
) {
    if let Some((bake, mut job)) = land.job.take() {
        match job.take() {
            Some(Ok(ground)) => land.ground = Some((bake, ground)),
            Some(Err(_)) => {}
            None => land.job = Some((bake, job)),
        }
    }
    let bake = shown.0.and_then(|planet| bakes.get(planet).ok());
    let Some(PlanetBake(bake)) = bake.filter(|_| !flights.is_empty()) else {
        return;
    };
    let is_known = land
        .ground
        .as_ref()
        .is_some_and(|(known, _)| Arc::ptr_eq(known, bake));
    if !is_known && land.job.is_none() {
        let wanted = bake.clone();
        let job = Background::start(move || {
            PlanetGround::of_bake(&wanted, Rules::default()).map_err(|error| error.to_string())
        });
        land.job = Some((bake.clone(), job));
    }
}

impl LandBelow {
    /// Height of the ground or of the water over it in metres; 0 where it is not known.
    pub fn height(&self, up: DVec3) -> f64 {
        let sample = self
            .ground
            .as_ref()
            .map(|(_, ground)| ground.sample(up, LEVEL));
        match sample {
            Some(Ok(here)) => f64::from(here.height_m.max(here.water_m)),
            _ => 0.0,
        }
    }
}

type Flying<'a> = (
    Entity,
    &'a Transform,
    Option<&'a Flight>,
    Option<&'a GroundView>,
    &'a mut Projection,
);

/// Lets the camera of a flight see the ground.
pub fn see(
    shown: Res<ShownPlanet>,
    look: Res<Look>,
    mut cameras: Query<Flying, With<OrbitCamera>>,
    planets: Query<(&Planet, &Globe)>,
    mut commands: Commands,
) {
    let Ok((camera, at, flight, view, mut projection)) = cameras.single_mut() else {
        return;
    };
    let Some(flight) = flight else {
        set_near(&mut projection, ORBIT_NEAR);
        if view.is_some() {
            commands
                .entity(camera)
                .remove::<(GroundView, GroundStatus)>();
        }
        return;
    };
    let Some((entity, (planet, globe))) = shown.0.zip(shown.0.and_then(|p| planets.get(p).ok()))
    else {
        return;
    };
    let radius_m = planet.radius * 1000.0;
    set_near(
        &mut projection,
        (flight.height * 0.05).min(50_000.0) / radius_m,
    );
    let wanted = GroundView {
        place: Some(flight.place(radius_m)),
        pixels: PIXELS,
        leaves: LEAVES,
        sun: sun(&look, globe, at),
        wireframe: look.wireframe,
        ..GroundView::of(entity)
    };
    if view != Some(&wanted) {
        commands.entity(camera).insert(wanted);
    }
}

/// Where the sun stands over a flight: behind the viewer's left shoulder, or where it stands over the
/// globe.
fn sun(look: &Look, globe: &Globe, at: &Transform) -> DVec3 {
    if !look.sun_follows {
        return globe.sun;
    }
    let up = at.translation.normalize();
    from_bevy(up * 0.75 + at.back() * 0.3 - at.right() * 0.55).normalize()
}

/// Hides the globe and shows the sky once the ground of a flight is drawn.
pub fn hide_globe(
    shown: Res<ShownPlanet>,
    cameras: Query<(Option<&Flight>, Option<&GroundStatus>), With<OrbitCamera>>,
    mut planets: Query<&mut Visibility, With<Planet>>,
    mut sky_colour: ResMut<ClearColor>,
) {
    let Ok((flight, status)) = cameras.single() else {
        return;
    };
    let drawn = matches!(status, Some(GroundStatus::Drawn(_)));
    let over_ground = flight.filter(|_| drawn);
    if let Some(mut visibility) = shown.0.and_then(|planet| planets.get_mut(planet).ok()) {
        visibility.set_if_neq(match over_ground {
            Some(_) => Visibility::Hidden,
            None => Visibility::Inherited,
        });
    }
    let wanted = sky(over_ground.map(Flight::altitude));
    if sky_colour.0 != wanted {
        sky_colour.0 = wanted;
    }
}

/// Tells why the ground of a flight cannot be drawn, once.
pub fn tell(
    cameras: Query<&GroundStatus, (With<Flight>, Changed<GroundStatus>)>,
    mut log: ResMut<MessageLog>,
) {
    for status in &cameras {
        if let GroundStatus::Failed(reason) = status {
            log.error(format!("the ground cannot be drawn: {reason}"));
        }
    }
}

/// Sets the near plane of a lens.
fn set_near(projection: &mut Mut<Projection>, near: f64) {
    let Projection::Perspective(lens) = &**projection else {
        return;
    };
    let wanted = PerspectiveProjection {
        near: near as f32,
        ..lens.clone()
    };
    if lens.near != wanted.near {
        **projection = Projection::Perspective(wanted);
    }
}
