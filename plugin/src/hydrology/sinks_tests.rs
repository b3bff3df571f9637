use super::*;
use crate::hydrology::coast::{ShoreClass, regularise};
use crate::hydrology::flood::priority_flood;
use crate::hydrology::flow::accumulate;
use crate::math;
use bevy::math::DVec3;

/// Runoff of every vertex on land in m³ per year.
const SUPPLY: u64 = 1_000_000;

/// Height in km of land with a bowl about `centre`, 1.3 km deep, its rim 0.25 rad wide.
fn bowl_km(p: DVec3, centre: DVec3) -> f64 {
    let r = math::angle_between(p, centre) / 0.25;
    let bowl = if r < 1.0 { -1.5 * (1.0 - r * r) } else { 0.0 };
    1.2 + p.z + bowl
}

/// Closed basins and what drains to them.
struct Basins {
    mesh: SphereMesh,
    ground: Vec<i32>,
    routes: Routes,
    closed: Vec<ClosedLake>,
    discharge: Vec<u64>,
}

/// The bowl north of a sea in the south, with a loss of open water in m³ per year and vertex.
fn basins(loss: i64) -> Basins {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let centre = math::direction(50.0, 20.0);
    let ground = mesh.points().iter().map(|&p| match p.z {
        z if z < 0.0 => -1_000_000,
        _ => (bowl_km(p, centre) * 1_024_000.0) as i32,
    });
    let mut ground: Vec<i32> = ground.collect();
    let shore = regularise(&mesh, &mut ground);
    let mut routes = priority_flood(&mesh, &shore, &ground);
    let is_land = |class: &ShoreClass| *class == ShoreClass::Land;
    let supply: Vec<u64> = shore
        .iter()
        .map(|class| if is_land(class) { SUPPLY } else { 0 })
        .collect();
    let balance = WaterBalance {
        mesh: &mesh,
        radius: 6370.0,
        ground: &ground,
        supply: &supply,
        loss: &vec![loss; mesh.len()],
    };
    let closed = close_basins(&balance, &mut routes);
    Basins {
        discharge: accumulate(&routes, &supply),
        mesh,
        ground,
        routes,
        closed,
    }
}

#[test]
fn a_wet_basin_spills() {
    let wet = basins(-900_000);
    assert!(wet.closed.is_empty());
    let receivers = wet.routes.receiver.iter().zip(&wet.discharge);
    let ends = receivers.filter(|(receiver, _)| **receiver == NO_VERTEX);
    let to_sea: u64 = ends.map(|(_, discharge)| discharge).sum();
    assert_eq!(to_sea, wet.routes.order.len() as u64 * SUPPLY);
}

#[test]
fn a_dry_basin_holds_a_lake_that_balances() {
    let dry = basins(20_000_000);
    assert_eq!(dry.closed.len(), 1, "{:?}", dry.closed);
    let lake = &dry.closed[0];
    let sink = lake.vertices[0] as usize;
    assert_eq!(dry.routes.receiver[sink], NO_VERTEX);
    let inflow = dry.discharge[sink];
    let each = 20_000_000 + SUPPLY;
    let cost = lake.vertices.len() as u64 * each;
    assert!(cost <= inflow && inflow < cost + each, "{cost} {inflow}");
    let is_under_water = |i: &u32| dry.ground[*i as usize] < lake.level;
    assert!(lake.vertices.iter().all(is_under_water));
}

#[test]
fn a_closed_basin_is_ordered_downstream_first() {
    let dry = basins(20_000_000);
    let mut rank = vec![0; dry.mesh.len()];
    for (k, &i) in dry.routes.order.iter().enumerate() {
        rank[i as usize] = k;
    }
    let receiver = |i: u32| dry.routes.receiver[i as usize];
    for &i in &dry.routes.order {
        let to = receiver(i);
        let ends = to == NO_VERTEX || receiver(to) == NO_VERTEX;
        assert!(ends || rank[to as usize] < rank[i as usize]);
    }
}
