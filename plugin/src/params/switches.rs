//! Choices rather than numbers: which processes run, and by which law ocean floor sinks.

use super::ParamError;
use bevy::prelude::*;

/// Which processes run; each can be switched at any time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
#[reflect(Default, Serialize, Deserialize)]
pub struct ProcessSwitches {
    /// Plates move.
    pub drift: bool,
    /// Overriding plates rise (paper 000 §4.1).
    pub subduction: bool,
    /// Subducting plates turn towards their fronts (§4.1).
    pub slab_pull: bool,
    /// Terranes are sutured (§4.2).
    pub collision: bool,
    /// New ocean floor and even samples (§4.3).
    pub resample: bool,
    /// Plates break by themselves (§4.4).
    pub rifting: bool,
    /// Continents wear down (§4.5).
    pub erosion: bool,
    /// Ocean floor sinks with age (§4.5).
    pub subsidence: bool,
    /// Trenches and deep floor fill (§4.5).
    pub sediment: bool,
    /// Coherent noise (§4.5).
    pub noise: bool,
}

impl Default for ProcessSwitches {
    fn default() -> Self {
        Self::all(true)
    }
}

impl ProcessSwitches {
    /// Names of the switches, in order.
    pub const NAMES: [&'static str; 10] = [
        "drift",
        "subduction",
        "slab_pull",
        "collision",
        "resample",
        "rifting",
        "erosion",
        "subsidence",
        "sediment",
        "noise",
    ];

    /// All on or all off.
    pub fn all(on: bool) -> Self {
        Self {
            drift: on,
            subduction: on,
            slab_pull: on,
            collision: on,
            resample: on,
            rifting: on,
            erosion: on,
            subsidence: on,
            sediment: on,
            noise: on,
        }
    }

    /// The switch of that name.
    pub fn get_mut(&mut self, name: &str) -> Result<&mut bool, ParamError> {
        Ok(match name {
            "drift" => &mut self.drift,
            "subduction" => &mut self.subduction,
            "slab_pull" => &mut self.slab_pull,
            "collision" => &mut self.collision,
            "resample" => &mut self.resample,
            "rifting" => &mut self.rifting,
            "erosion" => &mut self.erosion,
            "subsidence" => &mut self.subsidence,
            "sediment" => &mut self.sediment,
            "noise" => &mut self.noise,
            _ => return Err(ParamError::Unknown(name.to_string())),
        })
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
