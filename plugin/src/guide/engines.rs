//! Tiles of a planet in Unreal, Unity, Godot and Blender.
//!
//! # Tiles
//!
//! Single squares, exported one by one, have a projection each and do not meet. `pangaea export
//! --tiles COLUMNSxROWS` ([`TileBlock`] in code) cuts one square map into tiles:
//!
//! ```sh
//! pangaea export planet.pangaea --region=-33,-70,8 --pixels 1009 --tiles 4x4 --out land.png
//! ```
//!
//! writes `land_0_0.png` in the north west to `land_3_3.png` in the south east, each 8 km wide, and
//! the manifest `land.json`. `--pixels` are vertices to a side, the outer ones on the edges, so
//! neighbours share them to the last bit; the spacing is SIZE / (pixels - 1). All greys have one
//! range, that of the whole block, or the one of `--range=LOW,HIGH`, which makes blocks that are
//! exported one after the other alike. 16 bits over 10 km are steps of 15 cm; `.exr` and `.tif`
//! hold metres in 32-bit floats.
//!
//! | format | for |
//! |---|---|
//! | `.png` | Unreal, Blender |
//! | `.r16`, `.raw`: 16-bit little endian, rows from the north | Unity, Unreal, Godot (Terrain3D) |
//! | `.exr`: f32 in m | Godot (Terrain3D), Blender |
//! | `.glb`: mesh in m | Blender, Godot, Unity (glTFast), Unreal |
//! | `.tif`: f32 in m, georeferenced | GIS programs |
//!
//! Heightmaps are flat: the map is azimuthal equidistant, true to scale at its middle; 100 km away
//! lengths across are off by 0.004 % on a planet of 6370 km, at 1000 km by 0.4 %. A mesh is curved
//! as the planet is.
//!
//! # The manifest
//!
//! `generator`, `radius_m`, `lat`, `lon` (the middle of the block), `level`, `tiles`, `vertices`,
//! `tile_m`, `spacing_m`; `lowest_m`, `highest_m` of all ground, `sea_level_m`; for greys `min_m`
//! and `max_m`, black and white, and `sea_level_grey`. For each of `files` its column and row, its sides from
//! the middle of the block (`west_m`, `north_m`, `east_m`, `south_m`), the middle (`lat`, `lon`),
//! and its place in `engines`; what tiles have in common there is in `engines` of the manifest
//! itself. The sea is at height 0 in each.
//!
//! # Unreal
//!
//! Landscape mode, *Import from File*, `.png` or `.r16`; sides of 505, 1009, 2017, 4033 vertices
//! fill whole components. Scale: `engines.unreal.scale`. Location: the tile's `engines.unreal`, in
//! cm: x east, y south. A grey is at z = (grey - 32768) / 128 · scale + location.
//!
//! # Unity
//!
//! A terrain for each `.raw`; sides of 2^n + 1 vertices. *Import Raw*: 16 bit, byte order Windows,
//! *Flip Vertically* on, resolution and terrain size as `engines.unity` says. Position: the tile's
//! `engines.unity`: x east, z north, y the height of black. Unity divides greys by 65,536.
//!
//! # Godot
//!
//! Terrain3D imports `.exr` in metres (scale 1, offset 0), or `.r16` with `r16_range` and
//! `r16_size`. Its `vertex_spacing` is that of `engines.godot`; the tile's `engines.godot` is the
//! place of its first vertex in m: x east, z south. Divide by the spacing where vertices are asked
//! for. Godot reads PNG with 8 bits: not for heights. A `.glb` is imported as it is, at the origin.
//!
//! # Blender
//!
//! A `.glb` is imported as it is, at the origin: all tiles of a block count from its middle at sea
//! level. Or a plane of `plane_size`, subdivided, at the tile's `engines.blender`, with a modifier
//! *Displace* of `displace_strength` and mid level 0, its picture `.exr` or `.png` of colour space
//! *Non-Color*.
//!
//! # Figures, read back
//!
//! ```
//! use bevy::math::DVec3;
//! use bevy_pangaea::io::export;
//! use bevy_pangaea::query::{AzimuthalEquidistant, Ground, GroundError, TileBlock};
//!
//! /// A planet whose land rises to the north, 1 m to 100 m.
//! struct Ramp;
//!
//! impl Ground for Ramp {
//!     fn radius_m(&self) -> f64 {
//!         1e6
//!     }
//!
//!     fn height(&self, direction: DVec3, _level: u8) -> Result<f32, GroundError> {
//!         Ok((0.01 * self.radius_m() * direction.z.asin()) as f32)
//!     }
//! }
//!
//! # let folder = tempfile::tempdir()?;
//! # let folder = folder.path();
//! let about = AzimuthalEquidistant::new(0.0, 0.0, Ramp.radius_m())?;
//! let block = TileBlock::new(about, 8000.0, 9, [1, 2])?;
//! export(&Ramp, block, &folder.join("land.raw"))?;
//! let manifest: serde_json::Value =
//!     serde_json::from_slice(&std::fs::read(folder.join("land.json"))?)?;
//!
//! // The last vertex of the northern tile lies on the equator, at the sea.
//! let bytes = std::fs::read(folder.join("land_0_0.raw"))?;
//! let grey = f64::from(u16::from_le_bytes([bytes[160], bytes[161]]));
//! let figure = |pointer: &str| manifest.pointer(pointer).and_then(|v| v.as_f64()).unwrap();
//! assert!((grey - figure("/sea_level_grey")).abs() <= 0.5);
//!
//! let unreal_cm = (grey - 32_768.0) / 128.0 * figure("/engines/unreal/scale/2")
//!     + figure("/files/0/engines/unreal/2");
//! let unity_m = grey / 65_536.0 * figure("/engines/unity/terrain_size/1")
//!     + figure("/files/0/engines/unity/1");
//! assert!(unreal_cm.abs() < 0.2 && unity_m.abs() < 0.002);
//!
//! // The southern tile begins where the northern one ends.
//! assert_eq!(figure("/files/0/south_m"), figure("/files/1/north_m"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`TileBlock`]: crate::query::TileBlock
