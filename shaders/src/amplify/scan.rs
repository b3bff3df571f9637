//! Pass: exclusive prefix sums, which give every item that makes others its place among them.

use super::topology::NONE;

/// Gives each item that makes `count` others the place of the first, from `start` on; [`NONE`] to
/// one that makes none. Returns how many are made.
#[inline]
pub fn scan<T>(
    items: &mut [T],
    start: u32,
    count: impl Fn(&T) -> u32,
    place: impl Fn(&mut T, u32),
) -> u32 {
    let mut next = start;
    for item in items {
        let made = count(item);
        place(item, if made == 0 { NONE } else { next });
        next += made;
    }
    next - start
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_follow_one_another() {
        let mut items = [(2, 0), (0, 0), (1, 0), (4, 0)];
        assert_eq!(scan(&mut items, 10, |i| i.0, |i, place| i.1 = place), 7);
        assert_eq!(items.map(|i| i.1), [10, NONE, 12, 13]);
    }
}
