use super::*;

/// Grains in a km.
const KM: i32 = 1000 * GRAINS;

#[test]
fn deep_rivers_are_those_of_much_water() {
    assert_eq!(depth(0.0), 0);
    assert_eq!(depth(1.0), 276);
    // The Mississippi at its mouth: some 17,000 m3/s and 5 m in the mean.
    assert!((4.0..8.0).contains(&(f64::from(depth(17_000.0)) / 1024.0)));
}

/// The profile of a chain 5 -> 4 -> 3 -> 2 -> 1 -> 0, the coast; 3 is a sill, 4 a hollow behind
/// it.
fn chain(discharge: f64) -> Profile {
    let routes = Routes {
        order: vec![1, 2, 3, 4, 5],
        receiver: vec![NO_VERTEX, 0, 1, 2, 3, 4],
        depressions: vec![],
    };
    let channels = Channels {
        routes: &routes,
        ground: &[0, KM / 10, KM / 5, KM, KM / 2, 2 * KM],
        discharge: &[discharge; 6],
        network: RiverNetwork::Drainage,
    };
    channels.profile(&[])
}

#[test]
fn sills_dam_lakes_behind_weak_rivers() {
    let weak = chain(1.0);
    assert_eq!(weak.level[3], KM - incision(1.0));
    assert_eq!(weak.level[4], weak.level[3]);
    assert_eq!(weak.lake[3..], [NO_LAKE, 0, NO_LAKE]);
    // The water would be 450 m deep, but for the sediment.
    assert_eq!(weak.bed[4], weak.level[4] - GREATEST_LAKE_DEPTH);
    let lake = Lake {
        level: weak.level[3],
        outlet: 3,
        sink: 4,
        vertices: 1,
    };
    assert_eq!(weak.lakes, [lake]);
}

#[test]
fn sills_are_breached_where_the_river_can() {
    let strong = chain(40_000.0);
    assert!(strong.lakes.is_empty());
    assert_eq!(strong.level[3..5], [KM / 2 - MIN_FALL, KM / 2]);
    for k in 1..6 {
        assert!(strong.level[k] >= strong.level[k - 1] + MIN_FALL);
        assert!(strong.bed[k] > strong.bed[k - 1]);
    }
}
