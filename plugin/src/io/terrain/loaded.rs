//! A planet of a file, and what its user should know of it.

use crate::spawn::PlanetState;

/// A planet of a file, and what its user should know of it.
pub struct LoadedPlanet {
    /// The planet.
    pub planet: PlanetState,
    /// Voids of its maps that its own climate fills, and doubts of their units, a line each that
    /// names the file.
    pub notes: Vec<String>,
}

impl From<PlanetState> for LoadedPlanet {
    /// A planet of which there is nothing to say.
    fn from(planet: PlanetState) -> Self {
        let notes = Vec::new();
        Self { planet, notes }
    }
}
