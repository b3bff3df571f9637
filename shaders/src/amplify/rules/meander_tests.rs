use super::*;
use crate::amplify::fixed::ONE;
use crate::amplify::synthetic::control_mesh;

const EAST: [i16; 3] = [0, 32_767, 0];

/// A river's vertex so many metres east and north of the point where x is 1.
fn at(east: f64, north: f64, heading: [i16; 3]) -> Vertex {
    let unit = f64::from(ONE) / 6_371_000.0;
    Vertex {
        direction: [ONE, (east * unit) as i32, (north * unit) as i32],
        heading,
        kind: VertexKind::River,
        ..Vertex::default()
    }
}

#[test]
fn every_flow_meanders_on_one_level() {
    let scale = PlanetScale::new(&control_mesh(6_371_000, 6, 1));
    let rules = Rules::default();
    for flow in (1_500..30_000).step_by(7) {
        let width = 2_147.0 * f64::from(flow) / 65_536.0;
        let spans = (0..17).map(|level| scale.edge_grains(level));
        let due: Vec<i32> = (0..)
            .zip(spans)
            .filter(|&(level, span)| is_due(&rules, level, span, flow))
            .map(|(_, span)| span)
            .collect();
        assert_eq!(due.len(), 1, "{flow}");
        let widths = f64::from(due[0]) / 1024.0 / width;
        assert!((8.99..18.01).contains(&widths), "{flow}: {widths}");
    }
    assert!((0..17).all(|level| !is_due(&Rules::PAPER, level, scale.edge_grains(level), 5_000)));
}

#[test]
fn a_rivers_own_vertices_have_the_way_to_the_bend() {
    let apex = Vertex {
        bend: Bend::OUT,
        ..at(500.0, 866.0, EAST)
    };
    let own = at(0.0, 0.0, EAST);
    assert_eq!(headings([&own, &apex]), [[0; 3], EAST]);
    assert_eq!(headings([&own, &own]), [EAST; 2]);
    assert!(is_bent([&own, &apex]) && !is_bent([&own, &own]));
}

#[test]
fn slow_rivers_bend_and_steep_ones_do_not() {
    let scale = PlanetScale::new(&control_mesh(6_371_000, 4, 1));
    let far = at(500.0, 866.0, [0; 3]);
    let share_of = |fall: i32| {
        let up = Vertex {
            water: fall * 1024,
            ..at(0.0, 0.0, [0; 3])
        };
        let down = at(1000.0, 0.0, [0; 3]);
        let bent = (0..4000).filter(|&seed| bends(&scale, [&up, &down], &far, 0, seed * 7919));
        bent.count() as f64 / 4000.0
    };
    // Per mille of fall on a kilometre; from 1 to 10 the chance falls evenly from 0.95 to 0.
    for (fall, share) in [
        (0, 0.95),
        (1, 0.95),
        (4, 0.633),
        (7, 0.317),
        (10, 0.0),
        (50, 0.0),
    ] {
        let found = share_of(fall);
        assert!((found - share).abs() < 0.03, "{fall}: {found}");
    }
}

#[test]
fn bends_are_sharp_enough_and_no_loops_round_the_country() {
    let scale = PlanetScale::new(&control_mesh(6_371_000, 4, 1));
    let [up, down] = [0.0, 1000.0].map(|east| at(east, 0.0, [0; 3]));
    let bends_over = |east, north| {
        let far = at(east, north, [0; 3]);
        (0..100).any(|seed| bends(&scale, [&up, &down], &far, 0, seed))
    };
    assert!(bends_over(500.0, 800.0));
    // Behind the upper end; and farther than 2.9 lengths round.
    assert!(!bends_over(-50.0, 800.0));
    assert!(!bends_over(500.0, 1500.0));
}

#[test]
fn an_apex_falls_and_keeps_the_discharge() {
    let bed = |bed: i32, water: i32| Vertex {
        bed,
        water,
        ..at(0.0, 0.0, EAST)
    };
    let made = apex(
        &at(500.0, 400.0, [0; 3]),
        [&bed(5000, 7000), &bed(4000, 6500)],
        77,
    );
    assert_eq!((made.kind, made.discharge), (VertexKind::River, 77));
    assert_eq!([made.height, made.bed, made.water], [4500, 4500, 6750]);
}

#[test]
fn halves_of_a_bend_run_out_of_the_river_and_back() {
    // Kinds by middle, slot, and whether the half's own end is wet.
    assert_eq!(half_of_bend(Bend::OUT, 0, true), Some(false));
    assert_eq!(half_of_bend(Bend::OUT, 1, true), Some(true));
    assert_eq!(half_of_bend(Bend::BACK, 0, true), Some(true));
    assert_eq!(half_of_bend(Bend::BACK, 1, true), Some(false));
    for bend in [Bend::NONE, Bend::UPPER, Bend::LIMB] {
        assert_eq!(half_of_bend(bend, 0, true), None);
    }
    assert_eq!(half_of_bend(Bend::OUT, 1, false), None);
}
