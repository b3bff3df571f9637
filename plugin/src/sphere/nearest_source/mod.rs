//! The nearest of many sources, for every sample.
//!
//! A search passes the number of a source on from sample to neighbour, the nearest samples first,
//! and each sample measures the straight distance to the source that it is offered. So distances
//! are not sums over edges, and do not show the lattice. They are exact wherever the samples that a
//! source is nearest to are connected within the domain. Where the domain is not convex the path
//! bends around its border, but the distance is still the straight one: less than the path's
//! length.
//!
//! ```text
//! bucket_queue  samples in order of distance, in constant time (Dial 1969)
//! field         what every sample knows: nearest source and distance, packed into one word
//! reach         nearest source within a reach, over links that are open, with memory
//! travel        source of least travel time on the whole sphere
//! ```
//!
//! `reach` and `travel` walk in the same way but compare in different units. Fronts and rims change
//! at every step and are followed by several threads at a time, which packed words of an f32 and a
//! number serve; the ages of the first ocean floor are f64 times with a speed for each source. One
//! unit for both would change which source wins near a tie.

mod bucket_queue;
mod field;
mod reach;
mod travel;

pub use field::{SourceField, UNREACHED};
pub use reach::{ReachedSamples, SourceScratch, extend_nearest_sources, nearest_sources};
pub(crate) use travel::{TravelSource, least_travel_times};

#[cfg(test)]
mod tests;
