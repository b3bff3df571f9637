//! Kinds of crust and of mountain building (paper 000, Table 1).

use crate::named::named_enum;
use serde::{Deserialize, Serialize};

named_enum! {
    /// Type of the crust, x_C in the paper. It says what is continental; the sign of the elevation
    /// does not: a shelf is continental crust under water.
    #[derive(Default, Serialize, Deserialize)]
    pub enum CrustKind {
        /// Dense, thin, young crust; it subducts.
        #[default]
        Oceanic = "oceanic",
        /// Light, thick crust; it resists subduction.
        Continental = "continental",
    }
}

named_enum! {
    /// Type of the last mountain building, o in the paper.
    #[derive(Default, Serialize, Deserialize)]
    pub enum Orogeny {
        /// Never folded.
        #[default]
        None = "none",
        /// Folded above a subduction zone.
        Andean = "andean",
        /// Folded by a continental collision.
        Himalayan = "himalayan",
    }
}
