//! Horton–Strahler order of rivers, and the basins that they drain.
//!
//! A vertex into which nothing drains has order 1. Where the highest order from upstream comes
//! once, the river keeps it; where it comes twice, it rises by one (Strahler 1957).

use super::flood::{NO_VERTEX, Routes};

/// Horton–Strahler order of every vertex on land; 0 elsewhere.
pub(super) fn strahler(routes: &Routes) -> Vec<u8> {
    strahler_of(routes, |_| true)
}

/// Horton–Strahler order of those vertices that are channels, 0 elsewhere. A channel must drain to
/// a channel, or end.
pub(super) fn strahler_of(routes: &Routes, is_channel: impl Fn(u32) -> bool) -> Vec<u8> {
    let n = routes.receiver.len();
    let mut upstream = vec![Tributaries::default(); n];
    let mut order = vec![0; n];
    // Upstream first: all tributaries have joined before a vertex takes its order.
    for &i in routes.order.iter().rev().filter(|&&i| is_channel(i)) {
        let own = upstream[i as usize].order_below();
        order[i as usize] = own;
        let to = routes.receiver[i as usize];
        if to != NO_VERTEX {
            upstream[to as usize].join(own);
        }
    }
    order
}

/// The tributaries that meet at a vertex.
#[derive(Clone, Copy, Default)]
struct Tributaries {
    /// Highest of their orders; 0 at a spring.
    highest: u8,
    /// Whether several tributaries have it.
    is_shared: bool,
}

impl Tributaries {
    fn join(&mut self, order: u8) {
        if order > self.highest {
            self.highest = order;
            self.is_shared = false;
        } else if order == self.highest {
            self.is_shared = true;
        }
    }

    /// Order of the river below the confluence.
    fn order_below(self) -> u8 {
        if self.is_shared {
            self.highest.saturating_add(1)
        } else {
            self.highest.max(1)
        }
    }
}

/// The basin of every vertex: the coast or sink that it drains to. [`NO_VERTEX`] in the sea and on
/// coasts without a river.
pub(super) fn basins(routes: &Routes) -> Vec<u32> {
    let mut basin = vec![NO_VERTEX; routes.receiver.len()];
    // Downstream first: the basin of the receiver is known.
    for &i in &routes.order {
        let to = routes.receiver[i as usize];
        if to == NO_VERTEX {
            basin[i as usize] = i;
            continue;
        }
        if basin[to as usize] == NO_VERTEX {
            basin[to as usize] = to;
        }
        basin[i as usize] = basin[to as usize];
    }
    basin
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_rise_where_equals_meet() {
        // 6 and 5 meet in 3 (order 2); 7 joins at 2 without effect; 4 is a twin of 3's order after
        // 8 and 9.
        let routes = Routes {
            order: vec![1, 2, 4, 3, 7, 5, 6, 8, 9],
            receiver: vec![NO_VERTEX, 0, 1, 2, 1, 3, 3, 2, 4, 4],
            depressions: vec![],
        };
        let order = strahler(&routes);
        assert_eq!(order, [0, 3, 2, 2, 2, 1, 1, 1, 1, 1]);
        assert_eq!(basins(&routes), [0; 10]);
    }

    #[test]
    fn a_sink_is_its_own_basin() {
        let routes = Routes {
            order: vec![2, 1],
            receiver: vec![NO_VERTEX, 2, NO_VERTEX, NO_VERTEX],
            depressions: vec![],
        };
        assert_eq!(basins(&routes), [NO_VERTEX, 2, 2, NO_VERTEX]);
    }
}
