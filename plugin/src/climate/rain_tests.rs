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

/// Rain of a season by vertex numbers, as the header of the file tells it.
fn season_by_number(
    mesh: &SphereMesh,
    belts: &WindBelts,
    temperature: &[f32],
    height: &[f32],
) -> Vec<f32> {
    let by_place = columns(mesh, belts, temperature, height);
    let mut columns = by_place.clone();
    for (&i, column) in belts.order.iter().zip(by_place) {
        columns[i as usize] = column;
    }
    let mut water: Vec<f32> = columns.iter().map(|c| 0.7 * c.capacity).collect();
    let mut rain = vec![0.0; mesh.len()];
    for &i in [&belts.order; 3].into_iter().flatten() {
        let k = i as usize;
        let upwind = belts.upwind[k];
        let way = (upwind.distance * 6370.0).max(1.0);
        let [a, b] = upwind.from.map(|j| water[j as usize]);
        let carried = a + (b - a) * upwind.weight;
        let mixed = (ring_mean(mesh, &water, i) - carried) * (way / (300.0 + way));
        (water[k], rain[k]) = columns[k].pass(carried + mixed, way);
    }
    rain
}

#[test]
fn sweeps_by_place_rain_as_those_by_number() {
    let points = crate::sphere::poisson_disk(5, 0.03);
    let mesh = SphereMesh::from_points(points).unwrap();
    let noise = crate::noise::Noise::new(5, crate::random::Purpose::Relief, 0);
    let height = parallel::map(mesh.len(), |i| {
        noise.fractal(mesh.point(i), 3.0, 4) as f32 * 3.0
    });
    let temperature: Vec<f32> = height.iter().map(|z| 20.0 - 8.0 * z.max(0.0)).collect();
    for belts in &Winds::new(&mesh).seasons {
        let by_place = season(&mesh, belts, &temperature, &height);
        let by_number = season_by_number(&mesh, belts, &temperature, &height);
        assert!(by_place.iter().any(|&mm| mm > 100.0));
        let bits = |rain: &[f32]| rain.iter().map(|mm| mm.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&by_place), bits(&by_number));
    }
}
