//! How ocean floor sinks and fills with age (paper 000 §4.5).
//!
//! *Relaxing* (default): floor above the elevation at which its crust floats sinks towards it by
//! 1/e in 36 My, the cooling of Earth's plates (Stein and Stein 1992); floor below it is filled at
//! most at eps_t. Old floor rests at z_a.
//!
//! *Paper*: the printed `z' = z - (1 - z/z_t) eps_o dt`, which ends at z_t, and `z' = z + eps_t dt`
//! for floor below z_a.

use crate::params::{OceanFloor, TectonicParams};

/// The law of one set of parameters, for one time step.
#[derive(Clone, Copy, Debug)]
pub struct Subsidence {
    form: OceanFloor,
    /// Whether floor sinks.
    subside: bool,
    /// Whether sediment fills.
    fill: bool,
    /// Share of the height above balance that is lost in a step.
    sinking: f32,
    /// Most that sediment fills in a step, in km.
    sediment: f32,
    /// Dampening in a step at elevation 0, in km.
    damping: f32,
    /// z_t in km.
    trench: f32,
    /// z_a in km.
    abyss: f32,
}

impl Subsidence {
    /// The law that `params` describes.
    pub fn new(params: &TectonicParams) -> Self {
        let dt = params.time_step;
        Self {
            form: params.ocean_floor,
            subside: params.processes.subsidence,
            fill: params.processes.sediment,
            sinking: (1.0 - crate::math::exp(-dt / params.subsidence_time)) as f32,
            sediment: (params.sediment * dt) as f32,
            damping: (params.ocean_damping * dt) as f32,
            trench: params.trench_elevation as f32,
            abyss: params.abyss_elevation as f32,
        }
    }

    /// Elevation in km after one step of floor at `z` km whose crust floats at `balance` km.
    #[inline]
    pub fn step(&self, z: f32, balance: f32) -> f32 {
        match self.form {
            OceanFloor::Relaxing if z >= balance => {
                if self.subside {
                    z - (z - balance) * self.sinking
                } else {
                    z
                }
            }
            OceanFloor::Relaxing => {
                if self.fill {
                    z + (balance - z).min(self.sediment)
                } else {
                    z
                }
            }
            OceanFloor::Paper => {
                let sunk = if self.subside {
                    z - (1.0 - z / self.trench) * self.damping
                } else {
                    z
                };
                // Sediment fills trenches up to the abyss, and no higher.
                let deep = self.fill && sunk < self.abyss;
                if deep {
                    (sunk + self.sediment).min(self.abyss)
                } else {
                    sunk
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_relaxes_by_one_e_in_the_subsidence_time() {
        let params = TectonicParams::default();
        let law = Subsidence::new(&params);
        let mut z = -1.0;
        for _ in 0..18 {
            z = law.step(z, -6.0);
        }
        assert!(
            (z + 6.0 - 5.0 * crate::math::exp(-1.0) as f32).abs() < 1e-4,
            "{z}"
        );
        for _ in 0..500 {
            z = law.step(z, -6.0);
            assert!(z >= -6.0);
        }
        assert!((z + 6.0).abs() < 1e-3);
    }

    #[test]
    fn sediment_fills_from_below_and_stops_at_balance() {
        let params = TectonicParams::default();
        let law = Subsidence::new(&params);
        assert!((law.step(-9.0, -6.0) - (-9.0 + 0.6)).abs() < 1e-6);
        assert_eq!(law.step(-6.1, -6.0), -6.0);
    }

    #[test]
    fn the_printed_form_ends_in_the_trench() {
        let mut params = TectonicParams {
            ocean_floor: OceanFloor::Paper,
            ..Default::default()
        };
        params.processes.sediment = false;
        let law = Subsidence::new(&params);
        assert!((law.step(0.0, -6.0) + 0.08).abs() < 1e-6);
        assert_eq!(law.step(-10.0, -6.0), -10.0);
    }
}
