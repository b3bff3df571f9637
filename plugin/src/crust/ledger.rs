//! The account of continental crust: every change of area and volume has a cause.
//!
//! Areas are in km², volumes (thickness x area) in km³, both of continental crust. Area and volume
//! are also measured independently at the end of each step and at each resample; what no cause
//! explains is the largest relative difference seen, [`Ledger::unexplained_max`]. (Tests measure
//! before and after each stage.)

use super::Crust;
use crate::named::named_enum;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use serde::{Deserialize, Serialize};

named_enum! {
    /// Why continental crust grew or shrank. The list is closed but for [`Custom`](Self::Custom):
    /// resampling is no cause. Names are those of files; saves know causes by their place, so that
    /// new ones come last.
    #[derive(Serialize, Deserialize)]
    pub enum Cause {
        /// Ocean crust of an overriding plate rose above the sea and became land.
        ArcGrowth = "arc_growth",
        /// Crust thickened above a subducting slab.
        SubductionUplift = "subduction_uplift",
        /// Crust thickened in a continental collision.
        CollisionUplift = "collision_uplift",
        /// Crust slid under crust: its area is lost, its thickness is added to what lies above.
        Stacking = "stacking",
        /// Crust was forced down a subduction zone.
        ForcedSubduction = "forced_subduction",
        /// Crust was thinned along a rift.
        Rifting = "rifting",
        /// Rock was worn down.
        Erosion = "erosion",
        /// A root too thick to be carried fell into the mantle.
        Delamination = "delamination",
        /// Low-frequency noise of the relief.
        Noise = "noise",
        /// A user's command.
        Command = "command",
        /// A geological process that is not the plugin's own.
        Custom = "custom",
    }
}

/// A change of continental area and volume, or a measured amount of both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Reflect)]
pub struct Amount {
    /// Area in km².
    pub area: f64,
    /// Volume in km³.
    pub volume: f64,
}

/// The bookings since the planet was made, and how well they explain the measured changes.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::crust::Cause;
///
/// fn audit(ledgers: Query<&Ledger>) {
///     for ledger in &ledgers {
///         let worn = ledger.of(Cause::Erosion).volume;
///         info!("erosion took {:.0} km³; unexplained: {:e}", -worn, ledger.unexplained_max);
///     }
/// }
/// # bevy::ecs::system::assert_is_system(audit);
/// ```
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Ledger {
    /// Continental crust that the planet began with.
    pub initial: Amount,
    /// Sum of changes by cause, in the order of [`Cause::ALL`].
    pub booked: [Amount; Cause::COUNT],
    /// Area in km² that the last resample could not place, less than half a sample: carried to the
    /// next.
    pub carried_area: f64,
    /// Largest share of the continental area that was unexplained at a step's end or a resample.
    pub unexplained_max: f64,
    /// Largest share of the continental volume that was unexplained at a step's end.
    pub unexplained_volume_max: f64,
}

impl Ledger {
    /// Books a change.
    pub fn book(&mut self, cause: Cause, area: f64, volume: f64) {
        let entry = &mut self.booked[cause as usize];
        entry.area += area;
        entry.volume += volume;
    }

    /// The sum of all bookings for `cause`.
    pub fn of(&self, cause: Cause) -> Amount {
        self.booked[cause as usize]
    }

    /// The continental crust that there should be now.
    pub fn expected(&self) -> Amount {
        self.booked.iter().fold(self.initial, |sum, entry| Amount {
            area: sum.area + entry.area,
            volume: sum.volume + entry.volume,
        })
    }

    /// Compares the expected amount with a measured one and remembers the worst difference.
    /// Returns the relative difference of area and of volume.
    pub fn check(&mut self, measured: Amount) -> (f64, f64) {
        let expected = self.expected();
        // Where nothing is expected, differences count in whole km² and km³.
        let relative = |a: f64, b: f64| (a - b).abs() / b.abs().max(1.0);
        let area = relative(measured.area, expected.area);
        let volume = relative(measured.volume, expected.volume);
        self.unexplained_max = self.unexplained_max.max(area);
        self.unexplained_volume_max = self.unexplained_volume_max.max(volume);
        (area, volume)
    }
}

/// Continental area and volume of a state on a planet of `radius` km, summed in sample order.
pub fn measure(crust: &Crust, mesh: &SphereMesh, radius: f64) -> Amount {
    let parts = parallel::map_chunks(crust.len(), |range| {
        let (mut area, mut volume) = (0.0, 0.0);
        for i in range.filter(|&i| crust.is_continental(i)) {
            area += mesh.areas()[i];
            volume += mesh.areas()[i] * f64::from(crust.thickness[i]);
        }
        (area, volume)
    });
    let square = radius * radius;
    // Chunk by chunk in their order: the same bits on any number of threads.
    let (area, volume) = parts
        .iter()
        .fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
    Amount {
        area: area * square,
        volume: volume * square,
    }
}
