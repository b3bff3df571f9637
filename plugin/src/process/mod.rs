//! The processes of a step. One file is one process, one plugin and one section of paper 000.
//!
//! | file | paper 000 | in a word |
//! |---|---|---|
//! | [`drift`] | §3 | frames rotate with their plates |
//! | [`contact`] | §6 | where plates meet, and which goes under |
//! | [`subduction`], [`uplift`] | §4.1 | overriding plates rise |
//! | [`slab_pull`] | §4.1 | plates turn towards their fronts |
//! | [`collision`] | §4.2 | terranes break off and are sutured |
//! | [`rifting`] | §4.4 | plates break |
//! | [`surface_processes`], [`erosion`], [`ocean_floor`], [`relief_noise`] | §4.5 | crust wears, sinks, floats and ages |
//! | [`margin`] | §4.5 | sediment slopes beside continents |
//! | [`commit`], [`terranes`] | | clock and ledger; terranes as entities |
//!
//! The header of each file has its equations, units and policies; [`writes`](fn@writes) is the list
//! of what each stage may write.
//!
//! New ocean crust (§4.3) belongs to [`resample`](crate::resample).

mod writes;

pub use writes::writes;

pub mod contact;

pub mod drift;

#[doc(hidden)]
pub mod uplift;

pub mod subduction;

pub mod slab_pull;

pub mod collision;

pub mod rifting;

#[doc(hidden)]
pub mod ocean_floor;

#[doc(hidden)]
pub mod erosion;

#[doc(hidden)]
pub mod relief_noise;

pub mod surface_processes;

pub mod margin;

pub mod commit;

pub mod terranes;

/// Raises `z` by `dz` km so that it approaches `ceiling` smoothly and never passes it: slope 1 far
/// below, all of the distance that is left for an endless `dz`. A `dz` < 0 lowers in full.
#[inline]
pub fn saturating_rise(z: f32, dz: f32, ceiling: f32) -> f32 {
    let room = ceiling - z;
    if dz <= 0.0 {
        z + dz
    } else if room <= 0.0 {
        z
    } else {
        // Half the harmonic mean of both: less than either.
        z + dz * room / (dz + room)
    }
}

#[cfg(test)]
mod tests {
    use super::saturating_rise;

    #[test]
    fn uplift_saturates_smoothly() {
        assert_eq!(saturating_rise(1.0, 0.0, 10.0), 1.0);
        assert!((saturating_rise(0.0, 1e-3, 10.0) - 1e-3).abs() < 1e-6);
        assert!(saturating_rise(0.0, 1e6, 10.0) <= 10.0);
        assert!(saturating_rise(9.0, 130.0, 10.0) > 9.9);
        assert_eq!(saturating_rise(11.0, 1.0, 10.0), 11.0);
        assert_eq!(saturating_rise(1.0, -0.5, 10.0), 0.5);
        let mut last = -5.0;
        for k in 0..100 {
            let next = saturating_rise(-5.0, k as f32, 10.0);
            assert!(next >= last);
            last = next;
        }
    }
}
