//! The costs of everything, on two cores, with 40 plates.
//!
//! # Steps
//!
//! Milliseconds; the figures of paper 000 in brackets. A step is 2 My.
//!
//! | samples | spacing | step | resample, every 10 to 60 steps | rift |
//! |---|---|---|---|---|
//! | 60,000 | 92 km | 5.8 (190) | 26 (580) | 3.1 (230) |
//! | 100,000 | 71 km | 7.8 (280) | 39 (1,220) | 4.4 (210) |
//! | 250,000 | 45 km | 17 (1,240) | 98 (3,580) | 8.9 (1,500) |
//! | 500,000 | 32 km | 27 (1,900) | 177 (13,100) | 15 (7,700) |
//!
//! Steps are cut into time slices: a frame is held no longer than
//! [`ClockControls::frame_budget`], 8 ms by default, plus the rest of one chunk of work. A slow
//! machine makes slow time, not long frames.
//!
//! # A new planet
//!
//! It is built by threads of its own, half as many as the machine has; the frame in which it is put
//! onto its entity only moves columns there and spawns plates and terranes.
//! [`PlanetState::spawn`] waits for all of it.
//!
//! # The ground
//!
//! | work | time | where |
//! |---|---|---|
//! | base mesh of 230,000 vertices, once per seed | 0.7 s | in the background |
//! | climate | 0.09 s | in the background |
//! | rivers | 0.05 s | in the background |
//! | whole bake, with control maps | 0.15 to 0.25 s | in the background |
//! | the ground of a bake, made ready for questions | 0.1 to 0.2 s | where [`PlanetGround`] is made |
//! | height of the finest level at a fresh point, sea and land | 0.2 and 0.35 ms | where it is asked for |
//! | height near the last one | 16 µs | where it is asked for |
//! | collider of 64 m at 0.4 m | 30 to 40 ms | where it is asked for |
//!
//! Bakes have threads of their own, and a planet without [`BakeSettings`] is not baked.
//!
//! # Memory
//!
//! A sample of crust is [`Crust::BYTES`] bytes, 44, in the state and once more in each [`Surface`]
//! that someone holds. [`PlanetState`] is a copy of all of it; saves are taken from one, so they
//! may be written on another thread.
//!
//! # Measure it
//!
//! [`StageTimings`] on a planet has the milliseconds of every stage, and `pangaea bench` prints
//! these tables for the machine that it runs on.
//!
//! [`Crust::BYTES`]: crate::crust::Crust::BYTES
//! [`BakeSettings`]: crate::control::BakeSettings
//! [`ClockControls::frame_budget`]: crate::planet::ClockControls::frame_budget
//! [`PlanetGround`]: crate::query::PlanetGround
//! [`PlanetState::spawn`]: crate::spawn::PlanetState::spawn
//! [`PlanetState`]: crate::spawn::PlanetState
//! [`StageTimings`]: crate::schedule::StageTimings
//! [`Surface`]: crate::crust::Surface
