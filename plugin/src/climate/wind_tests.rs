use super::*;

#[test]
fn belts_blow_as_on_earth() {
    for lat in [5.0, 15.0, 25.0] {
        let (u, v) = wind(lat);
        assert!(u < 0.0 && v < 0.0, "trades at {lat}: {u} {v}");
        assert_eq!(wind(-lat), (u, -v));
    }
    let (u, v) = wind(47.0);
    assert!(u > 0.9 && v > 0.0);
    assert!(wind(75.0).0 < 0.0);
}

fn belts(mesh: &SphereMesh) -> WindBelts {
    let places: Vec<_> = mesh.points().iter().map(|&p| math::lat_lon(p)).collect();
    WindBelts::new(mesh, &places, 0.0)
}

/// Holds the point upwind of vertex `i` against the wind there.
fn assert_upwind(mesh: &SphereMesh, i: u32, upwind: Upwind) {
    let p = mesh.point(i);
    let [a, b] = upwind.from.map(|j| mesh.point(j));
    let at = a.lerp(b, f64::from(upwind.weight)) - p;
    let (east, north) = east_north(p);
    let (u, v) = wind(math::lat_lon(p).0);
    let to = (east * u + north * v).normalize();
    let cosine = at.normalize().dot(to);
    assert!(cosine < -0.99, "{i}: {cosine}");
    assert!((f64::from(upwind.distance) / at.dot(-to) - 1.0).abs() < 1e-3);
}

#[test]
fn upwind_points_lie_against_the_wind() {
    let mesh = SphereMesh::fibonacci(4000).unwrap();
    let winds = belts(&mesh);
    for i in 0..mesh.len() as u32 {
        if math::lat_lon(mesh.point(i)).0.abs() <= 85.0 {
            assert_upwind(&mesh, i, winds.upwind[i as usize]);
        }
    }
    let mut seen = winds.order.clone();
    seen.sort_unstable();
    assert!(seen.iter().enumerate().all(|(i, &j)| i as u32 == j));
}

#[test]
fn upwind_comes_first_nearly_everywhere() {
    let mesh = SphereMesh::fibonacci(4000).unwrap();
    let winds = belts(&mesh);
    let mut rank = vec![0; mesh.len()];
    for (k, &i) in winds.order.iter().enumerate() {
        rank[i as usize] = k;
    }
    let is_after = |j: u32, i: usize| rank[j as usize] > rank[i];
    let late = (0..mesh.len()).filter(|&i| winds.upwind[i].from.iter().any(|&j| is_after(j, i)));
    let count = late.count();
    assert!(count < mesh.len() / 5, "{count}");
}
