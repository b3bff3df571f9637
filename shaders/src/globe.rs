//! The WGSL of the globe: ground, sea, air and lines of a planet seen from orbit.
//!
//! Two kinds of source, told apart by their headers:
//! - *libraries* (`#define_import_path pangaea_shaders::...`) hold pure functions and import
//!   nothing, so other passes can reuse them and they can be validated alone;
//! - *passes* have entry points and bindings, and import the renderer's view and mesh.
//!
//! ```
//! use pangaea_shaders::globe::{LIBRARIES, PASSES};
//!
//! for library in LIBRARIES {
//!     let import_path = library.path.replace('/', "::").replace(".wgsl", "");
//!     assert!(library.wgsl.contains(&format!("#define_import_path {import_path}")));
//! }
//! assert!(PASSES.iter().all(|pass| pass.wgsl.contains("@fragment")));
//! ```

/// A source of WGSL with the path it is known by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WgslSource {
    /// Path for error messages, and the import path with `::` for `/` where the source is a
    /// library.
    pub path: &'static str,
    /// The text.
    pub wgsl: &'static str,
}

/// Library `pangaea_shaders::globe::sample`: unpacking of samples, tangent basis, displacement and
/// normal.
pub const SAMPLE: &str = include_str!("globe/sample.wgsl");

/// Library `pangaea_shaders::globe::light`: sun, twilight, gloss of the sea, air, highlights.
pub const LIGHT: &str = include_str!("globe/light.wgsl");

/// Library `pangaea_shaders::globe::coast`: noise that makes coasts ragged between the samples.
pub const COAST: &str = include_str!("globe/coast.wgsl");

/// Pass: ground and sea, displaced and lit; with the definition `WIREFRAME` triangle edges in one
/// colour.
pub const SURFACE: &str = include_str!("globe/surface.wgsl");

/// Pass: the shell of air around the globe, blended premultiplied.
pub const ATMOSPHERE: &str = include_str!("globe/atmosphere.wgsl");

/// Pass: lines of constant width in pixels.
pub const LINE: &str = include_str!("globe/line.wgsl");

/// Libraries, in the order in which they may be composed.
pub const LIBRARIES: [WgslSource; 3] = [
    WgslSource {
        path: "pangaea_shaders/globe/sample.wgsl",
        wgsl: SAMPLE,
    },
    WgslSource {
        path: "pangaea_shaders/globe/light.wgsl",
        wgsl: LIGHT,
    },
    WgslSource {
        path: "pangaea_shaders/globe/coast.wgsl",
        wgsl: COAST,
    },
];

/// Passes.
pub const PASSES: [WgslSource; 3] = [
    WgslSource {
        path: "pangaea_shaders/globe/surface.wgsl",
        wgsl: SURFACE,
    },
    WgslSource {
        path: "pangaea_shaders/globe/atmosphere.wgsl",
        wgsl: ATMOSPHERE,
    },
    WgslSource {
        path: "pangaea_shaders/globe/line.wgsl",
        wgsl: LINE,
    },
];
