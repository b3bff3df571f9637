//! The processes of a step. One file is one process, one plugin and one section of paper 000.
//!
//! | file | paper 000 | reads | writes |
//! |---|---|---|---|
//! | [`drift`] | §3 | motions | frames |
//! | [`contact`] | §6 | frames, crust, motions | contacts, polarity |
//! | [`subduction`] | §4.1 | contacts | elevation, thickness, fold, orogeny |
//! | [`slab_pull`] | §4.1 | contacts | motions |
//! | [`collision`] | §4.2 | contacts, crust | frames, elevation, thickness, fold, orogeny |
//! | [`rifting`] | §4.4 | plates, crust | plates, frames, thickness |
//! | [`surface_processes`] | §4.5 | crust | elevation, thickness, ages, kind |
//! | [`margin`] | §4.5 | elevation, kind | elevation of ocean crust |
//! | [`terranes`] | §3 | frames, kinds, motions | terranes |
//! | [`commit`] | | crust | clock, ledger |
//!
//! New ocean crust (§4.3) belongs to [`resample`](crate::resample).

pub mod contact;

pub mod drift;

pub mod uplift;

pub mod subduction;

pub mod slab_pull;

pub mod collision;

pub mod rifting;

pub mod ocean_floor;

pub mod erosion;

pub mod relief_noise;

pub mod surface_processes;

pub mod margin;

pub mod commit;

pub mod terranes;

/// Raises `z` by `dz` km so that it approaches `ceiling` smoothly and never passes it: slope 1 far
/// below, all of the distance that is left for an endless `dz`. What is lowered (`dz` < 0) is
/// lowered in full.
#[inline]
pub fn saturating_rise(z: f32, dz: f32, ceiling: f32) -> f32 {
    let room = ceiling - z;
    if dz <= 0.0 {
        z + dz
    } else if room <= 0.0 {
        z
    } else {
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
