//! The growth preset.
use super::base::BaseMesh; use super::coast::Site; use super::flood::Routes; use super::terrain::Terrain;
/// How the network of rivers is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RiverNetwork { /// d
 #[default] Drainage, /// g
 Grown }
pub(super) fn grow(_b:&BaseMesh,_s:&[Site],_g:&[i32],_t:&Terrain)->Routes{Routes::default()}
