//! Tests of maps and overlays on a small planet whose fields have closed forms.

use super::super::{Legend, LegendEntries, colorize};
use super::*;
use crate::crust::{Cover, Crust, Orogeny};
use crate::params::TectonicParams;
use crate::planet::Planet;
use crate::plate::{PlateMotion, PlateRow, PlateStats, PlateTable};
use bevy::prelude::Entity;

struct Small {
    planet: Planet,
    mesh: SphereMesh,
    surface: Surface,
    plates: PlateTable,
    params: TectonicParams,
}

/// Two plates that meet at the meridians 0 and 180; the eastern one turns about the pole by
/// `omega`. Elevation is 5 sin(latitude), the north is continental.
fn small(omega: f64) -> Small {
    let params = TectonicParams::default();
    let mesh = SphereMesh::fibonacci(4000).unwrap();
    let mut surface = Surface {
        crust: Crust::ocean(mesh.len(), &params),
        ..Surface::default()
    };
    for (i, p) in mesh.points().iter().enumerate() {
        surface.crust.elevation[i] = (5.0 * p.z) as f32;
        surface.crust.kind[i] = if p.z > 0.0 {
            CrustKind::Continental
        } else {
            CrustKind::Oceanic
        };
        surface.crust.orogeny[i] = if p.z > 0.5 {
            Orogeny::Andean
        } else {
            Orogeny::None
        };
        surface.crust.fold[i] = DVec3::new(-p.y, p.x, 0.0).normalize_or_zero().as_vec3();
        surface.plate.push(PlateId(u32::from(p.y > 0.0)));
    }
    surface.cover = vec![Cover::One; mesh.len()];
    surface.trench = vec![0.0; mesh.len()];
    let row = |id, speed| PlateRow {
        id: PlateId(id),
        entity: Entity::PLACEHOLDER,
        motion: PlateMotion {
            axis: DVec3::Z,
            speed,
        },
        stats: PlateStats::default(),
        born: 0.0,
    };
    let plates = PlateTable::new([row(0, 0.0), row(1, omega)]);
    Small {
        planet: Planet {
            radius: 6370.0,
            seed: 1,
        },
        mesh,
        surface,
        plates,
        params,
    }
}

impl Small {
    fn input(&self) -> OverlayInput<'_> {
        let Self {
            planet,
            mesh,
            surface,
            plates,
            params,
        } = self;
        OverlayInput {
            planet,
            mesh,
            surface,
            plates,
            params,
            bake: None,
        }
    }
}

#[test]
fn maps_have_north_up_and_greenwich_in_the_middle() {
    let small = small(0.0);
    let map = MapProjection::new(&small.mesh, 64, 32);
    let elevation = map.elevation(&small.surface);
    for y in 0..32 {
        let lat = (90.0 - (y as f64 + 0.5) * 180.0 / 32.0).to_radians();
        for x in 0..64 {
            let error = f64::from(elevation[y * 64 + x]) - 5.0 * math::sin(lat);
            assert!(error.abs() < 0.02, "{x} {y}: {error}");
        }
    }
    let plates = map.interpolate(|i| small.surface.plate[i].0 as f32);
    assert!(
        plates[16 * 64 + 16] < 0.01,
        "90 W lies in the western plate"
    );
    assert!(
        plates[16 * 64 + 48] > 0.99,
        "90 E lies in the eastern plate"
    );
}

#[test]
fn the_same_map_on_any_number_of_threads() {
    let small = small(0.01);
    let draw = || {
        let map = MapProjection::new(&small.mesh, 96, 48);
        Overlay::ALL.map(|overlay| map.draw(overlay, &small.input()))
    };
    let pool = |n| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(n)
            .build()
            .unwrap()
    };
    assert_eq!(pool(1).install(draw), pool(3).install(draw));
}

#[test]
fn boundaries_are_named_by_relative_motion() {
    // The eastern plate turns east: at longitude 0 it leaves, at 180 it comes.
    let small = small(0.01);
    let kinds = boundaries(&small.input());
    let at = |lat, lon| {
        let sample = small.mesh.nearest(math::direction(lat, lon));
        let foreign = small
            .mesh
            .ring(sample)
            .iter()
            .find(|&&j| kinds[j as usize] != BoundaryKind::None);
        foreign.map_or(kinds[sample as usize], |&j| kinds[j as usize])
    };
    assert_eq!(at(10.0, 0.0), BoundaryKind::Divergent);
    assert_eq!(at(10.0, 180.0), BoundaryKind::Convergent);
    assert_eq!(at(10.0, 90.0), BoundaryKind::None);
    let resting = boundaries(&self::small(0.0).input());
    assert!(
        resting
            .iter()
            .all(|k| matches!(k, BoundaryKind::None | BoundaryKind::Transform))
    );
}

#[test]
fn every_overlay_colours_every_sample_and_explains_itself() {
    let small = small(0.01);
    let map = MapProjection::new(&small.mesh, 32, 16);
    for overlay in Overlay::ALL {
        let colors = colorize(overlay, &small.input());
        assert_eq!(colors.len(), small.mesh.len());
        assert!(colors.iter().all(|c| c[3] == 255), "{overlay:?}");
        let Legend { title, entries, .. } = overlay.legend(&small.input());
        assert!(!title.is_empty());
        match entries {
            LegendEntries::Gradient { stops } => {
                assert!(stops.len() > 2 && stops.windows(2).all(|w| w[0].0 <= w[1].0));
            }
            LegendEntries::Classes(classes) => assert!(!classes.is_empty()),
        }
        assert_eq!(map.draw(overlay, &small.input()).rgb.len(), 3 * 32 * 16);
    }
}

#[test]
fn colours_follow_the_values() {
    let small = small(0.01);
    let input = small.input();
    let north = small.mesh.nearest(DVec3::Z) as usize;
    let south = small.mesh.nearest(-DVec3::Z) as usize;
    assert_eq!(
        colorize(Overlay::Elevation, &input)[north],
        palette::HYPSOMETRIC.at(small.surface.elevation(north))
    );
    let age = colorize(Overlay::OceanAge, &input);
    assert_ne!(age[north], age[south], "continents have no ocean age");
    assert_eq!(age[south], palette::AGE.at(0.0));
    // Folds run east-west everywhere: one colour, whatever the longitude.
    let folds = colorize(Overlay::FoldDirection, &input);
    let east_west = palette::axis_hue(90.0);
    let far = |a: Rgba, b: Rgba| (0..3).any(|k| a[k].abs_diff(b[k]) > 2);
    assert!(!folds.iter().any(|&c| far(c, east_west)));
}

#[test]
fn a_surface_of_another_mesh_draws_nothing() {
    let mut small = small(0.0);
    let map = MapProjection::new(&small.mesh, 8, 4);
    small.surface = Surface::default();
    assert!(colorize(Overlay::Slope, &small.input()).is_empty());
    assert!(
        map.draw(Overlay::Slope, &small.input())
            .rgb
            .iter()
            .all(|&b| b == 0)
    );
}
