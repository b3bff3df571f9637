//! Patches of ground behind the horizon are not drawn: half of a globe from afar, most of it from
//! near.

use super::axes::from_bevy;
use super::cap::SphericalCap;
use super::parts::{GlobeParts, visibility};
use super::task::GlobeTask;
use bevy::math::DVec3;
use bevy::prelude::*;

/// Hides patches that no 3D camera sees; without a camera all are shown.
pub(super) fn hide_far_side(
    cameras: Query<&GlobalTransform, With<Camera3d>>,
    globes: Query<(&GlobeParts, &GlobeTask, &GlobalTransform)>,
    mut patches: Query<(&SphericalCap, &mut Visibility)>,
) {
    for (parts, task, place) in &globes {
        // Cameras in planet coordinates, where one unit is one radius.
        let local = place.affine().inverse();
        let eyes: Vec<DVec3> = cameras
            .iter()
            .map(|eye| from_bevy(local.transform_point3(eye.translation())))
            .collect();
        let (lowest, highest) = task.radii();
        for &patch in &parts.patches {
            let Ok((cap, mut visible)) = patches.get_mut(patch) else {
                continue;
            };
            let seen = |&eye: &DVec3| cap.seen_from(eye, lowest, highest);
            visible.set_if_neq(visibility(eyes.is_empty() || eyes.iter().any(seen)));
        }
    }
}
