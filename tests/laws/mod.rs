//! Laws: closed forms, conservation, and what the design says of each process.

mod collision;
mod convergence;
mod drift;
mod islands;
mod ledger;
mod ocean;
mod relief;
mod resample;
mod rift;
