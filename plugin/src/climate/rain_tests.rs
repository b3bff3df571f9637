use super::*;

#[test]
fn capacity_doubles_within_11_degrees() {
    assert!((capacity(15.0) - 1.0).abs() < 0.01);
    assert!((1.8..2.2).contains(&(capacity(26.0) / capacity(15.0))));
    assert!((1.9..2.5).contains(&(capacity(5.0) / capacity(-5.0))));
}

#[test]
fn water_is_spent_on_land_and_regained_at_sea() {
    let land = Column {
        capacity: 1.0,
        zone: Zone {
            rising: 1.0,
            sinking: 0.0,
        },
        recycling: 0.5,
        is_sea: false,
    };
    let (left, rain) = land.pass(0.6, 50.0);
    assert!(left < 0.6 && rain > 0.0);
    let half_recycled = (0.6 - left) * MM_PER_YEAR / 50.0;
    assert!((half_recycled / (0.5 * rain) - 1.0).abs() < 1e-3);
    let sea = Column {
        is_sea: true,
        ..land
    };
    assert!(sea.pass(0.1, 50.0).0 > 0.1);
    // Lifted air rains more, and the air behind the crest less.
    let crest = Column {
        capacity: 0.3,
        ..land
    };
    let (behind, much) = crest.pass(0.6, 50.0);
    assert!(much > 3.0 * rain && land.pass(behind, 50.0).1 < 0.75 * rain);
}
