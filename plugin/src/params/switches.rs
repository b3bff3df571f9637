//! Choices rather than numbers: which processes run, and by which law ocean floor sinks.

use super::ParamError;
use bevy::prelude::*;

/// Makes the switches from one table: the fields, their names, and the way from a name to a field.
macro_rules! switches {
    ($( $(#[doc = $doc:literal])+ $name:ident; )+) => {
        /// Which processes run; each can be switched at any time.
        ///
        /// ```
        /// use bevy_pangaea::prelude::*;
        ///
        /// let mut params = TectonicParams::default();
        /// params.processes.rifting = false;
        /// *params.processes.get_mut("noise")? = false;
        /// # Ok::<(), bevy_pangaea::params::ParamError>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Reflect)]
        #[derive(serde::Serialize, serde::Deserialize)]
        #[serde(default, deny_unknown_fields)]
        #[reflect(Default, Serialize, Deserialize)]
        pub struct ProcessSwitches {
            $( $(#[doc = $doc])+ pub $name: bool, )+
        }

        impl ProcessSwitches {
            /// Names of the switches, in order.
            pub const NAMES: [&'static str; Self::COUNT] = [$( stringify!($name), )+];

            /// Number of switches.
            pub const COUNT: usize = [$( stringify!($name), )+].len();

            /// All on or all off.
            pub fn all(on: bool) -> Self {
                Self { $( $name: on, )+ }
            }

            /// The switch of that name.
            ///
            /// # Errors
            /// [`ParamError::Unknown`]
            pub fn get_mut(&mut self, name: &str) -> Result<&mut bool, ParamError> {
                match name {
                    $( stringify!($name) => Ok(&mut self.$name), )+
                    _ => Err(ParamError::Unknown(name.to_string())),
                }
            }
        }
    };
}

switches! {
    /// Plates move.
    drift;
    /// Overriding plates rise (paper 000 §4.1).
    subduction;
    /// Subducting plates turn towards their fronts (§4.1).
    slab_pull;
    /// Terranes are sutured (§4.2).
    collision;
    /// New ocean floor and even samples (§4.3).
    resample;
    /// Plates break by themselves (§4.4).
    rifting;
    /// Continents wear down (§4.5).
    erosion;
    /// Ocean floor sinks with age (§4.5).
    subsidence;
    /// Trenches and deep floor fill (§4.5).
    sediment;
    /// Coherent noise (§4.5).
    noise;
}

impl Default for ProcessSwitches {
    fn default() -> Self {
        Self::all(true)
    }
}

/// How ocean floor sinks with age.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[reflect(Default)]
pub enum OceanFloor {
    /// It relaxes towards the elevation at which its crust floats.
    #[default]
    Relaxing,
    /// The form printed in paper 000 §4.5, in which old floor ends in a trench.
    Paper,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn switches_have_names() {
        let mut switches = ProcessSwitches::default();
        for name in ProcessSwitches::NAMES {
            *switches.get_mut(name).unwrap() = false;
        }
        assert_eq!(switches, ProcessSwitches::all(false));
    }
}
