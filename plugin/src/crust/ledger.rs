//! The account of continental crust: every change of area and volume has a cause.
//!
//! Areas are in km², volumes (thickness x area) in km³, both of continental crust. Area and volume
//! are also measured independently at the end of each step and at each resample; what no cause
//! explains is the largest relative difference seen, [`Ledger::unexplained_max`]. (Tests measure
//! before and after each stage.)

use bevy::prelude::*;

/// Why continental crust grew or shrank. The list is closed: resampling is no cause.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect, serde::Serialize, serde::Deserialize,
)]
#[repr(u8)]
pub enum Cause {
    /// Ocean crust of an overriding plate rose above the sea and became land.
    ArcGrowth,
    /// Crust thickened above a subducting slab.
    SubductionUplift,
    /// Crust thickened in a continental collision.
    CollisionUplift,
    /// Crust slid under crust: its area is lost, its thickness is added to what lies above.
    Stacking,
    /// Crust was forced down a subduction zone.
    ForcedSubduction,
    /// Crust was thinned along a rift.
    Rifting,
    /// Rock was worn down.
    Erosion,
    /// A root too thick to be carried fell into the mantle.
    Delamination,
    /// Low-frequency noise of the relief.
    Noise,
    /// A user's command.
    Command,
    /// A geological process that is not the plugin's own.
    Custom,
}

impl Cause {
    /// All causes in the order in which files list them.
    pub const ALL: [Self; 11] = [
        Self::ArcGrowth,
        Self::SubductionUplift,
        Self::CollisionUplift,
        Self::Stacking,
        Self::ForcedSubduction,
        Self::Rifting,
        Self::Erosion,
        Self::Delamination,
        Self::Noise,
        Self::Command,
        Self::Custom,
    ];

    /// Name in files, in snake case.
    pub fn name(self) -> &'static str {
        match self {
            Self::ArcGrowth => "arc_growth",
            Self::SubductionUplift => "subduction_uplift",
            Self::CollisionUplift => "collision_uplift",
            Self::Stacking => "stacking",
            Self::ForcedSubduction => "forced_subduction",
            Self::Rifting => "rifting",
            Self::Erosion => "erosion",
            Self::Delamination => "delamination",
            Self::Noise => "noise",
            Self::Command => "command",
            Self::Custom => "custom",
        }
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

/// What was booked since the planet was made, and how well it explains what was measured.
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Ledger {
    /// Continental crust that the planet began with.
    pub initial: Amount,
    /// Sum of changes by cause, in the order of [`Cause::ALL`].
    pub booked: [Amount; 11],
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

    /// What was booked for `cause`.
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
        let relative = |a: f64, b: f64| (a - b).abs() / b.abs().max(1.0);
        let area = relative(measured.area, expected.area);
        let volume = relative(measured.volume, expected.volume);
        self.unexplained_max = self.unexplained_max.max(area);
        self.unexplained_volume_max = self.unexplained_volume_max.max(volume);
        (area, volume)
    }
}

/// Continental area and volume of a state on a planet of `radius` km, summed in sample order.
pub fn measure(crust: &super::Crust, mesh: &crate::sphere::SphereMesh, radius: f64) -> Amount {
    let parts = crate::parallel::map_chunks(crust.len(), |range| {
        let (mut area, mut volume) = (0.0, 0.0);
        for i in range.filter(|&i| crust.is_continental(i)) {
            area += mesh.areas()[i];
            volume += mesh.areas()[i] * f64::from(crust.thickness[i]);
        }
        (area, volume)
    });
    let square = radius * radius;
    let (area, volume) = parts
        .iter()
        .fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
    Amount {
        area: area * square,
        volume: volume * square,
    }
}
