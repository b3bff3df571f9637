//! A planet in a window.
//!
//! `cargo run -p bevy_pangaea --example minimal --features window`

use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::prelude::*;
use bevy_pangaea::prelude::*;

fn main() {
    App::new()
        .add_plugins((DefaultPlugins, PangaeaPlugins, PangaeaRenderPlugin))
        .add_systems(Startup, setup)
        .run();
}

fn setup(mut commands: Commands) {
    commands.spawn(PlanetRecipe {
        seed: 7,
        ..default()
    });
    let place = Transform::from_xyz(0.0, 1.0, 3.0).looking_at(Vec3::ZERO, Vec3::Y);
    commands.spawn((Camera3d::default(), Tonemapping::None, place));
}
