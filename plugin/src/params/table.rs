//! The table of parameters: name, default, limits and unit, and in words meaning and source.

use super::{OceanFloor, ParamInfo, ProcessSwitches};
use bevy::prelude::*;

macro_rules! params {
    ($($group:literal { $( $(#[doc = $doc:literal])+ $name:ident = $default:literal in $min:literal..$max:literal, $unit:literal; )+ })+) => {
        /// Parameters of the tectonic model of one planet, and which processes run.
        ///
        /// ```
        /// use bevy_pangaea::prelude::*;
        ///
        /// let mut params = TectonicParams::default();
        /// params.set("erosion", 0.05)?;
        /// assert_eq!(params.erosion, 0.05);
        /// let refused = params.set("erosion", -1.0).unwrap_err().to_string();
        /// assert_eq!(refused, "erosion = -1 is outside of 0..=5 km/My");
        /// # Ok::<(), bevy_pangaea::params::ParamError>(())
        /// ```
        #[derive(Component, Clone, Debug, PartialEq, Reflect)]
        #[derive(serde::Serialize, serde::Deserialize)]
        #[serde(default, deny_unknown_fields)]
        #[reflect(Component, Default, Serialize, Deserialize)]
        #[type_path = "bevy_pangaea::params"]
        pub struct TectonicParams {
            $($(
                $(#[doc = $doc])+
                #[doc = concat!("\n\nLimits ", $min, " to ", $max, " ", $unit, ", default ", $default, ".")]
                pub $name: f64,
            )+)+
            /// Which processes run.
            pub processes: ProcessSwitches,
            /// How ocean floor sinks.
            pub ocean_floor: OceanFloor,
        }

        impl Default for TectonicParams {
            fn default() -> Self {
                Self {
                    $($( $name: $default as f64, )+)+
                    processes: ProcessSwitches::default(),
                    ocean_floor: OceanFloor::default(),
                }
            }
        }

        impl TectonicParams {
            /// All parameters, by group.
            pub const TABLE: &'static [ParamInfo] = &[
                $($( ParamInfo {
                    name: stringify!($name),
                    group: $group,
                    min: $min as f64,
                    max: $max as f64,
                    default: $default as f64,
                    unit: $unit,
                    doc: concat!($($doc),+),
                    get: |params| params.$name,
                    set: |params, value| params.$name = value,
                }, )+)+
            ];
        }
    };
}

params! {
    "Time" {
        /// Time step δt. Paper 000, Appendix A.
        time_step = 2.0 in 0.1..5.0, "My";
        /// Fewest steps between two resamplings. Paper 000 §4.3.
        resample_min_steps = 10.0 in 1.0..100.0, "steps";
        /// Most steps between two resamplings. Paper 000 §4.3.
        resample_max_steps = 60.0 in 1.0..200.0, "steps";
    }
    "Elevations" {
        /// Elevation z_r of the highest oceanic ridges. Paper 000, Appendix A.
        ridge_elevation = -1.0 in -6.0..0.0, "km";
        /// Elevation z_a of abyssal plains. Paper 000, Appendix A.
        abyss_elevation = -6.0 in -9.0..-2.0, "km";
        /// Elevation z_t of oceanic trenches. Paper 000, Appendix A.
        trench_elevation = -10.0 in -15.0..-6.0, "km";
        /// Highest continental elevation z_c. Paper 000, Appendix A.
        summit_elevation = 10.0 in 2.0..20.0, "km";
    }
    "Motion" {
        /// Highest plate speed v_0. Paper 000, Appendix A.
        max_speed = 100.0 in 1.0..300.0, "km/My";
        /// Slab pull ε: how fast a subducting front as long as the planet's radius turns the
        /// plate's axis. Paper 000 §4.1 asks for ε much below 1; at this value a plate with a long
        /// front turns by some degrees in 10 My.
        slab_pull = 0.002 in 0.0..0.1, "rad/My";
        /// Age below which a plate is not pulled, so that a young rift stays open. Plates of the
        /// beginning were born at 0.
        slab_pull_grace = 20.0 in 0.0..500.0, "My";
    }
    "Subduction" {
        /// Base uplift u_0 of an overriding plate. Paper 000, Appendix A.
        uplift = 0.6 in 0.0..5.0, "km/My";
        /// Subduction distance r_s: where the uplift has faded to 0. Paper 000, Appendix A.
        subduction_distance = 1800.0 in 100.0..5000.0, "km";
        /// Share of the subduction distance at which the uplift really ends: 1 is the paper's,
        /// which lifts whole continents to 2 km. The Andes and their foreland reach 600 to 1000 km
        /// from the trench.
        subduction_reach = 0.55 in 0.05..1.0, "";
        /// Distance d_c from the front at which the uplift peaks. Arcs stand 100 to 300 km from the
        /// trench (paper 001 §4.2.1).
        uplift_peak = 300.0 in 10.0..2000.0, "km";
        /// Weight of the distance profile f: 0 ignores it, 1 is the paper's.
        weight_distance = 1.0 in 0.0..1.0, "";
        /// Weight of the speed g: 0 ignores it, 1 is the paper's.
        weight_speed = 1.0 in 0.0..1.0, "";
        /// Weight of the subducting relief h: 0 ignores it, 1 is the paper's.
        weight_relief = 1.0 in 0.0..1.0, "";
        /// Continental crust that rises faster than this is being folded: its orogeny becomes
        /// Andean. At this value the young belts of a planet are some hundred km wide, as the Andes
        /// are.
        orogeny_rate = 0.02 in 0.0..1.0, "km/My";
        /// Fold rate β: how fast the relative motion turns the fold direction. At this value a
        /// front of full speed turns it within about 10 My.
        fold_rate = 0.001 in 0.0..0.1, "1/km";
        /// Width over which subducting crust bends down to the trench; seismic profiles show 150 to
        /// 200 km.
        trench_width = 180.0 in 20.0..600.0, "km";
        /// Speed of approach from which on a trench has its full depth. Most of Earth's trenches
        /// approach faster.
        trench_speed = 20.0 in 0.1..300.0, "km/My";
        /// Age by which the older of two ocean plates must exceed the other before a front turns
        /// over.
        polarity_hysteresis = 30.0 in 0.0..200.0, "My";
        /// Age up to which the belt of a collision stays Himalayan above a subduction zone: a young
        /// belt keeps its relief.
        himalayan_memory = 60.0 in 0.0..1000.0, "My";
    }
    "Collision" {
        /// Interpenetration of continents at which a terrane breaks off and is sutured. Paper 000
        /// §6.
        collision_trigger = 300.0 in 20.0..2000.0, "km";
        /// Collision distance r_c. Paper 000, Appendix A.
        collision_distance = 4200.0 in 100.0..10000.0, "km";
        /// Share of the collision distance at which the surge really ends: 1 is the paper's, which
        /// makes belts of 2000 km and more when continents meet; Earth's widest, Tibet, reaches
        /// 1500 km from the suture.
        collision_reach = 0.25 in 0.05..1.0, "";
        /// Average initial area A_0 of a plate as a share of the planet's: 1/40.
        plate_share = 0.025 in 0.001..1.0, "";
        /// Collision coefficient Δ_c. Paper 000, Appendix A.
        collision_coefficient = 1.3e-5 in 0.0..1e-3, "1/km";
        /// Highest surge of one collision: the Δ_c A of a continent would be 100 km and more. Tibet
        /// stands 5 km high.
        collision_surge_max = 4.0 in 0.0..15.0, "km";
        /// Least share of the surge at the suture at which crust counts as folded: the belt is
        /// narrower than the radius of influence.
        collision_belt_share = 0.1 in 0.0..1.0, "";
        /// Area of the smallest terrane that breaks off its slab; smaller islands are forced down
        /// or scraped off.
        terrane_min_area = 20000.0 in 0.0..1e7, "km²";
    }
    "Ocean floor" {
        /// Half-distance σ at which a ridge of average speed has lost half of its height.
        ridge_width = 320.0 in 20.0..3000.0, "km";
        /// Time in which young ocean floor sinks by 1/e of its height above the abyss. 36 My fit
        /// the depths of Earth's oceans (Stein and Stein 1992, model GDH1).
        subsidence_time = 36.0 in 1.0..1000.0, "My";
        /// Oceanic dampening ε_o, used by the paper's printed form only. Paper 000, Appendix A.
        ocean_damping = 0.04 in 0.0..1.0, "km/My";
        /// Sediment accretion ε_t: fastest filling of floor that lies too deep. Paper 000, Appendix
        /// A.
        sediment = 0.3 in 0.0..5.0, "km/My";
        /// Width of the continental rise: sediment from the land lifts the floor beside a
        /// continent. Passive margins reach the abyssal plain 200 to 500 km off the shelf.
        margin_width = 250.0 in 0.0..1000.0, "km";
        /// Thickness of oceanic crust; seismic mean of 7 km.
        ocean_thickness = 7.0 in 3.0..15.0, "km";
    }
    "Continents" {
        /// Continental erosion ε_c. Paper 000, Appendix A, has 0.03, which leaves land 2 km high on
        /// average after 250 My; at this value it is 1.2 to 1.6 km (Earth's is 0.84 km). At more
        /// than this old planets lose their land to the sea.
        erosion = 0.06 in 0.0..5.0, "km/My";
        /// Widest gap between continents that do not diverge which their crust fills by stretching;
        /// wider ones become sea floor. Continental rifts are 30 to 100 km wide before they break.
        widest_crack = 120.0 in 0.0..2000.0, "km";
        /// Thickness of crust that floats at sea level; 33 km on Earth.
        sea_level_thickness = 33.2 in 20.0..60.0, "km";
        /// Elevation gained per thickness of crust on land: (3.3 - 2.78) / 3.3, densities of mantle
        /// and crust.
        isostasy = 0.158 in 0.05..0.5, "";
        /// Time in which the elevation of thickened or thinned crust follows; glacial rebound is
        /// much faster, thermal adjustment slower.
        isostasy_time = 8.0 in 0.5..200.0, "My";
        /// Amplitude of the low-frequency coherent noise of the relief: its drift in a My. The
        /// paper gives none; this adds some hundred metres in 100 My.
        noise_amplitude = 0.015 in 0.0..0.2, "km/My";
        /// Wavelength of that noise.
        noise_wavelength = 1800.0 in 200.0..10000.0, "km";
        /// Period over which that noise wanders through its two patterns: what it raises it lowers
        /// again.
        noise_period = 160.0 in 5.0..5000.0, "My";
    }
    "Rifting" {
        /// Mean number of riftings λ_0 in a time step of a wholly continental plate of average
        /// initial area. At this value a planet of 40 plates with 30 % land rifts about once in 12
        /// to 25 My, which keeps the mean age of its ocean floor at 80 to 105 My.
        rift_rate = 0.01 in 0.0..10.0, "";
        /// Share of λ that a wholly oceanic plate keeps.
        rift_oceanic_share = 0.3 in 0.0..1.0, "";
        /// Chance that a plate rifts in two; 1 leaves triple junctions out. On Earth most rifts are
        /// lines.
        rift_in_two = 0.75 in 0.0..1.0, "";
        /// Chance that it rifts in two or three, where that is more; else it breaks in four.
        rift_up_to_three = 0.93 in 0.0..1.0, "";
        /// Speed at which fragments open, far from the pole.
        rift_speed = 60.0 in 1.0..300.0, "km/My";
        /// Width of the zone that a rift thins on either side.
        rift_width = 200.0 in 0.0..1000.0, "km";
        /// Share of its thickness that continental crust at a new rift loses; stretched margins
        /// lose a tenth to a half.
        rift_thinning = 0.15 in 0.0..0.9, "";
        /// Amplitude of the warp of rift lines and initial borders, relative to the distance of the
        /// centroids.
        border_warp = 0.3 in 0.0..1.0, "";
    }
}
