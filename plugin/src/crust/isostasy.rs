//! Airy isostasy: how high crust of a given thickness floats.
//!
//! `z(e) = k (e - e_0)` with the thickness e_0 that floats at sea level. Under water the load of
//! the sea makes the slope steeper: `k_w = (z_0 - z_a) / (e_0 - e_o)` is fixed by the ocean floor,
//! whose crust of thickness e_o rests at the abyssal elevation z_a. Above water k is (rho_m -
//! rho_c) / rho_m. Source: Airy 1855; densities of Turcotte and Schubert, Geodynamics, §2.2.

use crate::params::TectonicParams;

/// The law for one set of parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isostasy {
    /// Thickness that floats at sea level, e_0, in km.
    pub sea_level_thickness: f32,
    /// Elevation per thickness above sea level.
    pub slope_land: f32,
    /// Elevation per thickness below sea level.
    pub slope_sea: f32,
    /// Thickness per elevation above and below sea level: a division is dear in a sweep.
    inverse: [f32; 2],
}

impl Isostasy {
    /// The law that `params` describes.
    pub fn new(params: &TectonicParams) -> Self {
        let e0 = params.sea_level_thickness;
        let slope_sea = -params.abyss_elevation / (e0 - params.ocean_thickness);
        Self {
            sea_level_thickness: e0 as f32,
            slope_land: params.isostasy as f32,
            slope_sea: slope_sea as f32,
            inverse: [(1.0 / params.isostasy) as f32, (1.0 / slope_sea) as f32],
        }
    }

    /// Elevation in km at which crust of thickness `e` km floats.
    #[inline]
    pub fn elevation(&self, e: f32) -> f32 {
        let excess = e - self.sea_level_thickness;
        excess
            * if excess > 0.0 {
                self.slope_land
            } else {
                self.slope_sea
            }
    }

    /// Thickness in km of crust that floats at elevation `z` km, the inverse of
    /// [`Self::elevation`].
    #[inline]
    pub fn thickness(&self, z: f32) -> f32 {
        self.sea_level_thickness + self.load(z)
    }

    /// How much thicker crust of elevation `z` km becomes when it is raised by `dz` km.
    #[inline]
    pub fn thickening(&self, z: f32, dz: f32) -> f32 {
        // Crust that crosses sea level has a part of the way on either slope.
        self.load(z + dz) - self.load(z)
    }

    /// Thickness above that which floats at sea level.
    #[inline]
    fn load(&self, z: f32) -> f32 {
        z * if z > 0.0 {
            self.inverse[0]
        } else {
            self.inverse[1]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ocean_floor_and_sea_level_float_where_they_should() {
        let params = TectonicParams::default();
        let law = Isostasy::new(&params);
        assert!(
            (law.elevation(params.ocean_thickness as f32) as f64 - params.abyss_elevation).abs()
                < 1e-5
        );
        assert_eq!(law.elevation(law.sea_level_thickness), 0.0);
        for z in [-6.0_f32, -3.0, -0.1, 0.0, 0.5, 4.0, 9.0] {
            assert!((law.elevation(law.thickness(z)) - z).abs() < 1e-5);
        }
        assert!((law.thickening(1.0, 0.5) - 0.5 / law.slope_land).abs() < 1e-4);
    }
}
