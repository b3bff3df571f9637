//! Laws: closed forms, conservation, and the rules of each process.

mod amplified;
mod climate;
mod collision;
mod consumption;
mod convergence;
mod drift;
mod hydrology;
mod islands;
mod ledger;
mod ocean;
mod relief;
mod resample;
mod rift;
mod water;
