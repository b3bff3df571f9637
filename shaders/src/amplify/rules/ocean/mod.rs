//! The ocean floor's relief, laid on once the subdivision is done (paper 000 §5).

use super::super::vertex::Vertex;
use super::preset::Rules;

/// Offset of the sea floor at a vertex, grains.
pub fn relief(_rules: &Rules, _vertex: &Vertex, _radius_m: u32) -> i32 {
    0
}
