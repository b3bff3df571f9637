//! Cameras and planets into the render world.

use super::frame::{Lens, PlanetFrame, clamped};
use super::rows::GroundRows;
use super::view::{GroundStatus, GroundView, Reports};
use crate::query::Rules;
use bevy::prelude::*;
use bevy::render::Extract;
use bevy::render::sync_world::RenderEntity;
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::gpu::{BaseRows, GroundCamera};
use std::sync::Arc;

/// The ground of a camera in the render world.
#[derive(Component, Clone)]
pub(super) struct SeenGround {
    /// The camera in the main world.
    pub(super) camera: Entity,
    pub(super) rows: Arc<BaseRows>,
    pub(super) leaves: u32,
    pub(super) view: View,
    pub(super) rules: Rules,
    pub(super) looks: GroundCamera,
}

type CameraParts<'a> = (
    Entity,
    RenderEntity,
    &'a GroundView,
    &'a Camera,
    &'a GlobalTransform,
);

/// Takes what every camera sees.
pub(super) fn extract(
    cameras: Extract<Query<CameraParts>>,
    planets: Extract<Query<(&GroundRows, &GlobalTransform)>>,
    old: Query<Entity, With<SeenGround>>,
    reports: Res<Reports>,
    mut commands: Commands,
) {
    for entity in &old {
        commands.entity(entity).remove::<SeenGround>();
    }
    for (camera, entity, view, lens, at) in &cameras {
        let Ok((rows, planet)) = planets.get(view.planet) else {
            continue;
        };
        let scale = rows.rows.scale();
        let radius_m = f64::from(scale.radius_m);
        let (Some(frame), Some(lens)) =
            (PlanetFrame::new(view, at, planet, radius_m), lens_of(lens))
        else {
            let reason = "the camera stands in no place from which ground is seen";
            reports.say(camera, GroundStatus::Failed(reason.into()));
            continue;
        };
        commands.entity(entity).insert(SeenGround {
            camera,
            rows: rows.rows.clone(),
            leaves: clamped(view.leaves),
            view: frame.view(view, &lens, scale),
            rules: Rules::default(),
            looks: frame.camera(view, &lens),
        });
    }
}

/// The lens of a camera that draws into something.
fn lens_of(camera: &Camera) -> Option<Lens> {
    let clip_from_view = camera.clip_from_view();
    let size = camera.physical_viewport_size()?;
    clip_from_view.is_finite().then_some(Lens {
        clip_from_view,
        height: size.y as f32,
    })
}
