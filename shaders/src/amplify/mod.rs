//! Amplification: the planet's ground from 52 km to half a metre, in exact integers (paper 002).
//!
//! A control mesh is refined level by level: an edge gets a vertex in its middle, a face becomes
//! four. Rules see the kinds of an edge's ends (river, lake, gully, coast, sea, ground) and give
//! the new vertex its ground; faces lay tributaries and gullies along their inner edges. What is
//! not split stays a leaf and is drawn.
//!
//! # The passes
//!
//! One file is one pass: columns in, columns out, and a list of items, each of which reads what it
//! needs and writes itself alone, so any number of items can be done at once and in any order. All of
//! them run on the CPU. They use no operation that WGSL's 32-bit integers lack (products of 64 bits
//! are built from halves, see [`fixed`]), so a compute pass can have the same bits.
//!
//! | pass | once per | reads | writes |
//! |---|---|---|---|
//! | [`mark::mark_split`] | face | view ([`sight`]), corners | split or leaf |
//! | [`mark::mark_halo`] | face | which neighbours are split | halo |
//! | [`count`] | edge, face | its faces' marks; its own | its mark; sums of 256 items |
//! | [`scan`] | sum | the sums before it | what is made before its items |
//! | [`place`] | edge, face | its sum | places of vertices, halves, children; lists of items |
//! | [`edge_split`] | edge | ends, opposite corners | the new vertex: place, heading of its river, kind, ground, water (R1 to R5, lakes) |
//! | [`face_decide`] | face | corners, new vertices, corners beyond | its inner edges (Ia to Ic) |
//! | [`vertex_resolve`] | new vertex | its two faces' decisions, rivers beside it | kind, nearest river |
//! | [`face_split::grow_halves`] | edge | ends, new vertex, its faces' children | its halves |
//! | [`face_split::grow_inner`] | face | its edges and new vertices | its inner edges |
//! | [`face_split::grow_faces`] | face | its edges' halves | its children |
//! | [`carve`] | vertex | itself | final ground and water |
//! | [`show`] | vertex | itself, view | ground and water that a level shows of it |
//! | [`emit`] | leaf, triangle | split edges; water of its corners | triangles of ground and of water |
//!
//! [`step`] runs the passes of one level, [`ground::refine`] all levels of a view. Level 0 is the
//! control mesh itself ([`base`]), which no run copies or renumbers; where most of it is out of sight
//! the CPU runs over what a view may [`reach`]. A run keeps apart what a level *is* ([`LevelMesh`],
//! written once by the level above) and what becomes of it ([`EdgeSplit`], [`FaceSplit`]).
//!
//! [`local`] answers for a single direction: [`lazy`] calls the same functions for no more vertices
//! than the answer depends on.
//!
//! [`LevelMesh`]: topology::LevelMesh
//! [`EdgeSplit`]: topology::EdgeSplit
//! [`FaceSplit`]: topology::FaceSplit
//!
//! ```
//! use pangaea_shaders::amplify::base::Base;
//! use pangaea_shaders::amplify::carve::carve_all;
//! use pangaea_shaders::amplify::ground::{Caps, refine};
//! use pangaea_shaders::amplify::mark::View;
//! use pangaea_shaders::amplify::rules::Rules;
//! use pangaea_shaders::amplify::synthetic::control_mesh;
//!
//! let base = Base::new(&control_mesh(6_371_000, 3, 1))?;
//! let at = base.vertices[7].direction;
//! let ground = refine(&base, &Rules::default(), &View::disc(at, 50, 17), &Caps::default());
//! let carved = carve_all(&ground.scale, &Rules::default(), &ground.vertices);
//! assert_eq!(carved.len(), ground.vertices.len());
//! # Ok::<(), pangaea_shaders::amplify::base::BadMesh>(())
//! ```
//!
//! # Why no view changes a bit
//!
//! A vertex is named by its path from the control mesh. It depends on its edge, on the two faces
//! beside it, on their decisions, and these on the faces' new vertices and on the corners beyond.
//! Faces are split within c·ℓ of the camera, where what it does not see counts as farther by no
//! more than [`sight`] bounds, so all of them exist wherever the edge is split ([`mark`]); those
//! that are not split themselves are halo: their midpoints are made and their inner edges decided
//! as if they were. Nothing reads anything finer than its own level, and a vertex, once settled,
//! never changes. Buffers are laid out by prefix sums, never by the order of the work.
//!
//! # Symbols
//!
//! | paper | here | unit |
//! |---|---|---|
//! | λ, ℓ | level of an edge 0..=16, [`PlanetScale::edge_grains`](scale::PlanetScale::edge_grains) | ℓ₀ / 2^λ, grains of 1/1024 m |
//! | p | [`Vertex::direction`](vertex::Vertex::direction) | 1 / [`ONE`](fixed::ONE) of the radius: 3.1 mm on Earth |
//! | h | `height`, then [`Carved::ground`](carve::Carved::ground) | grains above sea level |
//! | h_w | `water`, then [`Carved::water`](carve::Carved::water), also under dry ground | grains |
//! | h_r, d_r | `river` (a segment), `river_distance`, `river_along` | grains, Q16 |
//! | valley | `section`: height of its side, share of the ground's own | grains, Q16 |
//! | φ | [`Vertex::flow`](vertex::Vertex::flow), root of `discharge` | Q16; discharge 2⁻³² of 200,000 m³/s |
//! | e_r | `valley` | `ValleyShape`, 0..4 |
//! | C, A, W, P, B | `crust`, `worn`, `wetness`, `plateau`, `hills` | grains, Q16 |
//! | ξ, χ | [`seed::share`] of the vertex's seed | Q16 |
//! | r, t, l, s, g | [`VertexKind`](control::VertexKind) | |
//! | 𝓡, 𝓣 | [`EdgeKind`](rules::EdgeKind) | |
//! | β | [`face_decide`] | |
//!
//! # Precision
//!
//! Directions leave the sphere by less than 16 units (5 cm on Earth) over 17 levels, nearly all of
//! it at the coarse ones; the middle of a fine edge is right to half a unit a component. Faces keep
//! their orientation by a bound on the sideways displacement that is proved in [`edge_split`]'s
//! tests. Heights are right to a grain, 1 mm.
//!
//! # Twins
//!
//! [`twins`] lists the modules that have a twin in WGSL beside them. Products of 64 bits are taken
//! as such here, by [`fixed`] and [`arith`], and by halves there: the only functions that differ.
//!
//! Every pass over a level has one: [`columns::PASSES`]. Their buffers hold the columns in [`rows`] of
//! words. On a GPU level 0 is whole, numbers of items are never read
//! back ([`scan`] writes the next level's), and a leaf's triangles are counted with what it makes.

pub mod arith;
pub mod curve;
pub mod fixed;
pub mod geometry;
pub mod seed;

pub mod control;
pub mod scale;
pub mod topology;
pub mod vertex;
pub mod vertices;

pub mod segment;

pub mod rules;
pub mod uniform;

mod sparse;

pub mod base;
pub mod locate;

pub mod view;

pub mod sight;

pub mod reach;

pub mod mark;

pub mod count;
pub mod rows;
pub mod scan;

pub mod place;

pub mod edge_split;
pub mod face_decide;
pub mod face_split;
pub mod vertex_resolve;

pub mod step;

pub mod carve;
pub mod show;

pub mod emit;

pub mod ground;

pub mod lazy;
pub mod local;

pub mod synthetic;

pub mod columns;
pub mod twins;

#[cfg(test)]
mod tests;
