//! The state that each stage of a step may write: the one list that tests and documents follow.

use crate::schedule::Stage;

/// Names of all that a stage may write: [columns of the crust](crate::crust::Crust::COLUMNS), and
///
/// | name | state |
/// |---|---|
/// | `frames` | [`Frames`](crate::crust::Frames) |
/// | `plates` | which plates there are, their motions and times of birth |
/// | `polarity` | [`PolarityMemory`](crate::plate::polarity::PolarityMemory) |
/// | `ledger` | [`Ledger`](crate::crust::Ledger) |
/// | `clock` | [`GeologicClock`](crate::planet::GeologicClock) |
/// | `numbers` | [`PlateNumbers`](crate::planet::PlateNumbers) |
///
/// Commands write whatever they are told to. Caches and surfaces are no state.
pub fn writes(stage: Stage) -> &'static [&'static str] {
    match stage {
        Stage::Commands | Stage::Projection => &[],
        Stage::Drift => &["frames"],
        Stage::Contact => &["polarity"],
        Stage::Subduction => &[
            "elevation",
            "thickness",
            "fold",
            "orogeny",
            "orogeny_age",
            "ledger",
        ],
        Stage::SlabPull => &["plates"],
        Stage::Collision => &[
            "frame",
            "frames",
            "elevation",
            "thickness",
            "fold",
            "orogeny",
            "orogeny_age",
            "ledger",
            "plates",
            "polarity",
        ],
        Stage::Rifting => &[
            "frame",
            "frames",
            "plates",
            "thickness",
            "ledger",
            "numbers",
            "polarity",
        ],
        Stage::SurfaceProcesses => &[
            "elevation",
            "thickness",
            "ocean_age",
            "orogeny_age",
            "kind",
            "orogeny",
            "ledger",
        ],
        Stage::Resample => &[
            "frame",
            "frames",
            "kind",
            "thickness",
            "elevation",
            "ocean_age",
            "ridge",
            "orogeny_age",
            "orogeny",
            "fold",
            "plates",
            "polarity",
            "ledger",
            "clock",
        ],
        Stage::Commit => &["clock", "ledger"],
    }
}
