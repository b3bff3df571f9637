//! The WGSL of the passes as assets.

use bevy::asset::{Handle, uuid_handle};
use bevy::prelude::*;
use bevy::shader::Shader;
use pangaea_shaders::globe as wgsl;

/// The libraries, in the order of [`wgsl::LIBRARIES`].
const LIBRARIES: [Handle<Shader>; 3] = [
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a01"),
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a02"),
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a03"),
];
/// Ground, sea and edges of triangles.
pub(super) const SURFACE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a11");
/// Air.
pub(super) const ATMOSPHERE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a12");
/// Lines.
pub(super) const LINE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a13");

/// Puts all shaders under their handles.
pub(super) fn insert(shaders: &mut Assets<Shader>) {
    let handles = LIBRARIES.into_iter().chain([SURFACE, ATMOSPHERE, LINE]);
    let sources = wgsl::LIBRARIES.into_iter().chain(wgsl::PASSES);
    for (handle, source) in handles.zip(sources) {
        // The handles are constants, never reserved or freed, so the insertion cannot fail.
        let _ = shaders.insert(&handle, Shader::from_wgsl(source.wgsl, source.path));
    }
}
