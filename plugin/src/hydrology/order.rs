//! Horton–Strahler order of rivers, and the basins that they drain.
//!
//! A vertex into which nothing drains has order 1. Where the highest order from upstream comes
//! once, the river keeps it; where it comes twice, it rises by one (Strahler 1957).

use super::flood::{NONE, Routes};

/// Horton–Strahler order of every vertex on land; 0 elsewhere.
pub fn strahler(routes: &Routes) -> Vec<u8> {
    strahler_of(routes, |_| true)
}

/// Horton–Strahler order of those vertices that are channels, 0 elsewhere. What is downstream of a
/// channel must be one.
pub fn strahler_of(routes: &Routes, is_channel: impl Fn(u32) -> bool) -> Vec<u8> {
    let n = routes.receiver.len();
    // Highest order from upstream, and whether it came more than once.
    let mut highest = vec![(0u8, false); n];
    let mut order = vec![0u8; n];
    for &i in routes.order.iter().rev().filter(|&&i| is_channel(i)) {
        let (top, twice) = highest[i as usize];
        let own = if twice {
            top.saturating_add(1)
        } else {
            top.max(1)
        };
        order[i as usize] = own;
        let to = routes.receiver[i as usize];
        if to != NONE {
            let (top, twice) = &mut highest[to as usize];
            if own > *top {
                (*top, *twice) = (own, false);
            } else if own == *top {
                *twice = true;
            }
        }
    }
    order
}

/// The basin of every vertex: the coast or sink that it drains to. [`NONE`] in the sea and on
/// coasts without a river.
pub fn basins(routes: &Routes) -> Vec<u32> {
    let mut basin = vec![NONE; routes.receiver.len()];
    for &i in &routes.order {
        let to = routes.receiver[i as usize];
        if to == NONE {
            basin[i as usize] = i;
            continue;
        }
        if basin[to as usize] == NONE {
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
            receiver: vec![NONE, 0, 1, 2, 1, 3, 3, 2, 4, 4],
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
            receiver: vec![NONE, 2, NONE, NONE],
            depressions: vec![],
        };
        assert_eq!(basins(&routes), [NONE, 2, 2, NONE]);
    }
}
