//! From the symbols of the papers to the items of this crate.
//!
//! # The crust: paper 000, Table 1
//!
//! | symbol | meaning | item |
//! |---|---|---|
//! | x_C | crust type | [`CrustKind`], [`Crust::kind`] |
//! | e | thickness in km | [`Crust::thickness`] |
//! | z | elevation in km | [`Crust::elevation`] |
//! | a_o | age of ocean crust in My | [`Crust::ocean_age`] |
//! | **r** | direction of the ridge | [`Crust::ridge`] |
//! | a_c | age of the orogeny in My | [`Crust::orogeny_age`] |
//! | o | type of the orogeny | [`Orogeny`], [`Crust::orogeny`] |
//! | **f** | direction of the folds | [`Crust::fold`] |
//!
//! # Plates: paper 000 §3
//!
//! | symbol | meaning | item |
//! |---|---|---|
//! | P_i | plate | [`Plate`], [`PlateId`] |
//! | C | its crust | the samples whose [`Crust::frame`] it carries: [`Frames::plate`] |
//! | M | its triangulation | [`SphereMesh`], one for all plates |
//! | G | its rigid geodetic movement | [`PlateMotion`] |
//! | **w** | axis of rotation | [`PlateMotion::axis`] |
//! | ω | angular speed in rad/My | [`PlateMotion::speed`] |
//! | s(**p**) = ω **w** × **p** | velocity of a point | [`PlateMotion::angular_velocity`] × **p** |
//! | R | terrane | [`Terrane`] |
//! | **c**_i, **q** | centroids | [`PlateStats::centroid`], [`Terrane::centroid`] |
//! | A | area in km² | [`PlateStats::area`], [`Terrane::area`] |
//! | x_P | share of continental crust | [`PlateStats::continental`] |
//!
//! # Processes: paper 000 §4
//!
//! | § | equation | module |
//! |---|---|---|
//! | 4.1 | uplift u = u_0 f(d) g(v) h(z_i), folds **f** | [`process::subduction`] |
//! | 4.1 | slab pull **w**_i(t + δt) | [`process::slab_pull`] |
//! | 4.2 | radius r, surge Δz, folds | [`process::collision`] |
//! | 4.3 | new ocean crust, ridge profile z_Γ | [`resample`] |
//! | 4.4 | chance of rifting P, fragments | [`process::rifting`] |
//! | 4.5 | erosion, dampening, sediment, noise | [`process::surface_processes`] |
//! | 6 | contacts between plates, resampling | [`plate::contact`], [`resample`] |
//! | 7.1 | authoring | [`authoring`] |
//!
//! # Constants: paper 000, Appendix A
//!
//! | symbol | meaning | item | paper | default |
//! |---|---|---|---|---|
//! | δt | time step | [`TectonicParams::time_step`] | 2 My | 2 My |
//! | R | planet radius | [`PlanetRecipe::radius`], [`Planet::radius`] | 6370 km | 6370 km |
//! | z_r | highest ridges | [`TectonicParams::ridge_elevation`] | -1 km | -1 km |
//! | z_a | abyssal plains | [`TectonicParams::abyss_elevation`] | -6 km | -6 km |
//! | z_t | trenches | [`TectonicParams::trench_elevation`] | -10 km | -10 km |
//! | z_c | highest continents | [`TectonicParams::summit_elevation`] | 10 km | 10 km |
//! | r_s | subduction distance | [`TectonicParams::subduction_distance`] | 1800 km | 1800 km |
//! | r_c | collision distance | [`TectonicParams::collision_distance`] | 4200 km | 4200 km |
//! | Δ_c | collision coefficient | [`TectonicParams::collision_coefficient`] | 1.3e-5 /km | 1.3e-5 /km |
//! | v_0 | highest plate speed | [`TectonicParams::max_speed`] | 100 mm/y | 100 km/My |
//! | ε_o | dampening of ocean floor | [`TectonicParams::ocean_damping`] | 0.04 mm/y | 0.04 km/My |
//! | ε_c | continental erosion | [`TectonicParams::erosion`] | 0.03 mm/y | 0.06 km/My |
//! | ε_t | sediment | [`TectonicParams::sediment`] | 0.3 mm/y | 0.3 km/My |
//! | u_0 | subduction uplift | [`TectonicParams::uplift`] | 0.6 mm/y | 0.6 km/My |
//!
//! Constants that the paper names without a value:
//!
//! | symbol | meaning | item |
//! |---|---|---|
//! | A_0 | average initial area of a plate | [`TectonicParams::plate_share`] of the planet's |
//! | β | fold rate | [`TectonicParams::fold_rate`] |
//! | ε | slab pull | [`TectonicParams::slab_pull`] |
//! | λ_0 | mean number of riftings | [`TectonicParams::rift_rate`] |
//! | Γ | fracture, ridge | the `line` of [`TectonicCommand::RiftPlate`] |
//!
//! [`TectonicParams::TABLE`] has them all with limits, units and sources.
//!
//! # Paper 002
//!
//! | word | item |
//! |---|---|
//! | control maps | [`Bake`], made of a [`Surface`] |
//! | river network, drainage | [`hydrology`] |
//! | crust hyper-amplification | [`PlanetGround`] |
//! | rules | [`Rules`]; `Rules::PAPER` as printed, `Rules::RELEASE` as in the authors' source |
//!
//! [`authoring`]: crate::authoring
//! [`hydrology`]: crate::hydrology
//! [`plate::contact`]: crate::plate::contact
//! [`process::collision`]: crate::process::collision
//! [`process::rifting`]: crate::process::rifting
//! [`process::slab_pull`]: crate::process::slab_pull
//! [`process::subduction`]: crate::process::subduction
//! [`process::surface_processes`]: crate::process::surface_processes
//! [`resample`]: crate::resample
//! [`Bake`]: crate::control::Bake
//! [`Crust::elevation`]: crate::crust::Crust::elevation
//! [`Crust::fold`]: crate::crust::Crust::fold
//! [`Crust::frame`]: crate::crust::Crust::frame
//! [`Crust::kind`]: crate::crust::Crust::kind
//! [`Crust::ocean_age`]: crate::crust::Crust::ocean_age
//! [`Crust::orogeny_age`]: crate::crust::Crust::orogeny_age
//! [`Crust::orogeny`]: crate::crust::Crust::orogeny
//! [`Crust::ridge`]: crate::crust::Crust::ridge
//! [`Crust::thickness`]: crate::crust::Crust::thickness
//! [`CrustKind`]: crate::crust::CrustKind
//! [`Frames::plate`]: crate::crust::Frames::plate
//! [`Orogeny`]: crate::crust::Orogeny
//! [`PlanetGround`]: crate::query::PlanetGround
//! [`PlanetRecipe::radius`]: crate::planet::PlanetRecipe::radius
//! [`Planet::radius`]: crate::planet::Planet::radius
//! [`PlateId`]: crate::plate::PlateId
//! [`PlateMotion::angular_velocity`]: crate::plate::PlateMotion::angular_velocity
//! [`PlateMotion::axis`]: crate::plate::PlateMotion::axis
//! [`PlateMotion::speed`]: crate::plate::PlateMotion::speed
//! [`PlateMotion`]: crate::plate::PlateMotion
//! [`PlateStats::area`]: crate::plate::PlateStats::area
//! [`PlateStats::centroid`]: crate::plate::PlateStats::centroid
//! [`PlateStats::continental`]: crate::plate::PlateStats::continental
//! [`Plate`]: crate::plate::Plate
//! [`Rules`]: crate::query::Rules
//! [`SphereMesh`]: crate::sphere::SphereMesh
//! [`Surface`]: crate::crust::Surface
//! [`TectonicCommand::RiftPlate`]: crate::authoring::TectonicCommand::RiftPlate
//! [`TectonicParams::TABLE`]: crate::params::TectonicParams::TABLE
//! [`TectonicParams::abyss_elevation`]: crate::params::TectonicParams::abyss_elevation
//! [`TectonicParams::collision_coefficient`]: crate::params::TectonicParams::collision_coefficient
//! [`TectonicParams::collision_distance`]: crate::params::TectonicParams::collision_distance
//! [`TectonicParams::erosion`]: crate::params::TectonicParams::erosion
//! [`TectonicParams::fold_rate`]: crate::params::TectonicParams::fold_rate
//! [`TectonicParams::max_speed`]: crate::params::TectonicParams::max_speed
//! [`TectonicParams::ocean_damping`]: crate::params::TectonicParams::ocean_damping
//! [`TectonicParams::plate_share`]: crate::params::TectonicParams::plate_share
//! [`TectonicParams::ridge_elevation`]: crate::params::TectonicParams::ridge_elevation
//! [`TectonicParams::rift_rate`]: crate::params::TectonicParams::rift_rate
//! [`TectonicParams::sediment`]: crate::params::TectonicParams::sediment
//! [`TectonicParams::slab_pull`]: crate::params::TectonicParams::slab_pull
//! [`TectonicParams::subduction_distance`]: crate::params::TectonicParams::subduction_distance
//! [`TectonicParams::summit_elevation`]: crate::params::TectonicParams::summit_elevation
//! [`TectonicParams::time_step`]: crate::params::TectonicParams::time_step
//! [`TectonicParams::trench_elevation`]: crate::params::TectonicParams::trench_elevation
//! [`TectonicParams::uplift`]: crate::params::TectonicParams::uplift
//! [`Terrane::area`]: crate::plate::Terrane::area
//! [`Terrane::centroid`]: crate::plate::Terrane::centroid
//! [`Terrane`]: crate::plate::Terrane
