//! The settings of a planet's bakes.

use super::bake::{BakeError, BakeRules};
use crate::climate::ClimateMaps;
use crate::hydrology::BASE_SPACING;
use bevy::prelude::*;
use bevy::reflect::{ReflectDeserialize, ReflectSerialize};

/// Asks for bakes of a planet, and says how. Maps that replace fields of the climate are the
/// planet's own [`ClimateMaps`].
///
/// ```
/// use bevy::prelude::*;
/// use bevy_pangaea::control::{BakePlugin, BakeSettings};
///
/// let mut app = App::new();
/// app.add_plugins(BakePlugin);
/// // A base mesh four times as coarse: a sixteenth of the vertices.
/// let fine = BakeSettings::default();
/// let coarse = BakeSettings { spacing: 4.0 * fine.spacing, ..fine };
/// assert!(coarse.check().is_ok());
/// app.world_mut().spawn(coarse); // beside a `Planet`
/// ```
#[derive(Component, Clone, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[reflect(Component, Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[require(ClimateMaps)]
#[serde(default, deny_unknown_fields)]
pub struct BakeSettings {
    /// Smallest distance of the base mesh's vertices in radians.
    pub spacing: f64,
    /// Network and rivers.
    pub rules: BakeRules,
}

impl BakeSettings {
    /// Refuses a spacing that is not a finite number above 0.
    ///
    /// # Errors
    /// [`BakeError::Spacing`].
    pub fn check(&self) -> Result<(), BakeError> {
        let spacing = self.spacing;
        if spacing > 0.0 && spacing.is_finite() {
            Ok(())
        } else {
            Err(BakeError::Spacing(spacing))
        }
    }

    /// Whether both ask for the same bake. Numbers are compared by their bits: NaN never equals
    /// itself, and the planet would be baked for ever.
    pub(super) fn asks_for_the_same(&self, other: &Self) -> bool {
        let BakeRules { network, rivers } = &self.rules;
        self.spacing.to_bits() == other.spacing.to_bits()
            && rivers.discharge.to_bits() == other.rules.rivers.discharge.to_bits()
            && rivers.order == other.rules.rivers.order
            && *network == other.rules.network
    }
}

impl Default for BakeSettings {
    fn default() -> Self {
        Self {
            spacing: BASE_SPACING,
            rules: BakeRules::default(),
        }
    }
}

#[cfg(test)]
#[path = "settings_tests.rs"]
mod tests;
