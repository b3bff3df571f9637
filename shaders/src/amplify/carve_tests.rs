//! Water ends where the ground rises over it.

use super::*;

fn corner(ground: i32, water: i32) -> Carved {
    Carved { ground, water }
}

#[test]
fn a_dry_triangle_has_no_water() {
    assert_eq!(
        sheet([corner(5, 5), corner(7, NO_WATER), corner(9, 3)]),
        None
    );
}

#[test]
fn water_stays_level_under_its_banks() {
    // A lake at 100, a bank that knows it, a hill that knows a river far above.
    let corners = [corner(90, 100), corner(101, 100), corner(400, 350)];
    assert_eq!(sheet(corners), Some([100; 3]));
    let hill = [
        corner(90, 100),
        corner(400, NO_WATER),
        corner(300, NO_WATER),
    ];
    assert_eq!(sheet(hill), Some([100; 3]));
}

#[test]
fn a_river_keeps_its_fall() {
    let corners = [corner(90, 100), corner(88, 98), corner(103, 99)];
    assert_eq!(sheet(corners), Some([100, 98, 99]));
}

#[test]
fn water_ends_at_ground_that_lies_lower() {
    let corners = [corner(90, 100), corner(60, NO_WATER), corner(103, NO_WATER)];
    assert_eq!(sheet(corners), Some([100, 60, 100]));
}
