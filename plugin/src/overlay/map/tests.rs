//! Tests of maps and overlays on a small planet whose fields have closed forms.

use super::*;
use crate::crust::{Cover, Crust, CrustKind, Orogeny};
use crate::overlay::baked::tests::bake;
use crate::overlay::palette::{self, Rgba};
use crate::overlay::{BoundaryKind, Legend, LegendEntries, boundaries, colorize};
use crate::params::TectonicParams;
use crate::planet::Planet;
use crate::plate::{PlateId, PlateMotion, PlateRow, PlateStats, PlateTable};
use bevy::prelude::Entity;

/// Two plates that meet at the meridians 0 and 180. Elevation is 5 sin(latitude), the north is
/// continental, folds run from east to west.
struct SmallPlanet {
    planet: Planet,
    mesh: SphereMesh,
    surface: Surface,
    plates: PlateTable,
    params: TectonicParams,
}

/// A small planet whose eastern plate turns about the pole by `omega`.
fn small(omega: f64) -> SmallPlanet {
    let params = TectonicParams::default();
    let mesh = SphereMesh::fibonacci(4000).unwrap();
    let surface = Surface {
        crust: crust(&mesh, &params),
        plate: (mesh.points().iter())
            .map(|p| PlateId(u32::from(p.y > 0.0)))
            .collect(),
        cover: vec![Cover::One; mesh.len()],
        trench: vec![0.0; mesh.len()],
        ..Surface::default()
    };
    SmallPlanet {
        planet: Planet {
            radius: 6370.0,
            seed: 1,
        },
        mesh,
        surface,
        plates: PlateTable::new([row(0, 0.0), row(1, omega)]),
        params,
    }
}

fn crust(mesh: &SphereMesh, params: &TectonicParams) -> Crust {
    let mut crust = Crust::ocean(mesh.len(), params);
    for (i, p) in mesh.points().iter().enumerate() {
        crust.elevation[i] = (5.0 * p.z) as f32;
        if p.z > 0.0 {
            crust.kind[i] = CrustKind::Continental;
        }
        if p.z > 0.5 {
            crust.orogeny[i] = Orogeny::Andean;
        }
        crust.fold[i] = DVec3::new(-p.y, p.x, 0.0).normalize_or_zero().as_vec3();
    }
    crust
}

fn row(id: u32, speed: f64) -> PlateRow {
    PlateRow {
        id: PlateId(id),
        entity: Entity::PLACEHOLDER,
        motion: PlateMotion {
            axis: DVec3::Z,
            speed,
        },
        stats: PlateStats::default(),
        born: 0.0,
    }
}

impl SmallPlanet {
    fn input(&self) -> OverlayInput<'_> {
        OverlayInput {
            planet: &self.planet,
            mesh: &self.mesh,
            surface: &self.surface,
            plates: &self.plates,
            params: &self.params,
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

/// All maps of a planet, looked up and drawn by so many threads.
fn maps(small: &SmallPlanet, threads: usize) -> [Raster; Overlay::COUNT] {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().unwrap().install(|| {
        let map = MapProjection::new(&small.mesh, 96, 48);
        Overlay::ALL.map(|overlay| map.draw(overlay, &small.input()))
    })
}

#[test]
fn the_same_map_on_any_number_of_threads() {
    let small = small(0.01);
    assert_eq!(maps(&small, 1), maps(&small, 3));
}

#[test]
fn maps_drawn_together_are_those_drawn_alone() {
    let small = small(0.01);
    let bake = bake();
    let input = OverlayInput {
        bake: Some(&bake),
        ..small.input()
    };
    let map = MapProjection::new(&small.mesh, 96, 48);
    let mut drawn = Vec::new();
    let ended = map.draw_each(&Overlay::ALL, &input, |overlay, raster| {
        assert!(raster == map.draw(overlay, &input), "{overlay:?}");
        drawn.push(overlay);
        // An error ends it, whatever is drawn together.
        (overlay != Overlay::Rain).then_some(()).ok_or("enough")
    });
    assert_eq!(ended, Err("enough"));
    assert!(drawn[..] == Overlay::ALL[..drawn.len()] && drawn.ends_with(&[Overlay::Rain]));
}

/// The kind of boundary at a place, or beside it.
fn kind_near(small: &SmallPlanet, kinds: &[BoundaryKind], lat: f64, lon: f64) -> BoundaryKind {
    let sample = small.mesh.nearest(math::direction(lat, lon));
    let ring = small.mesh.ring(sample).iter();
    let near = ring.map(|&j| kinds[j as usize]);
    near.chain([kinds[sample as usize]])
        .find(|&kind| kind != BoundaryKind::None)
        .unwrap_or_default()
}

#[test]
fn boundaries_are_named_by_relative_motion() {
    // The eastern plate turns east: at longitude 0 it leaves, at 180 it comes.
    let small = small(0.01);
    let kinds = boundaries(&small.input());
    let at = |lon| kind_near(&small, &kinds, 10.0, lon);
    assert_eq!(at(0.0), BoundaryKind::Divergent);
    assert_eq!(at(180.0), BoundaryKind::Convergent);
    assert_eq!(at(90.0), BoundaryKind::None);
}

#[test]
fn plates_at_rest_only_have_transform_boundaries() {
    let kinds = boundaries(&small(0.0).input());
    let resting =
        |kind: &BoundaryKind| matches!(kind, BoundaryKind::None | BoundaryKind::Transform);
    assert!(kinds.iter().all(resting));
}

#[test]
fn every_overlay_colours_every_sample() {
    let small = small(0.01);
    let map = MapProjection::new(&small.mesh, 32, 16);
    for overlay in Overlay::ALL {
        let colors = colorize(overlay, &small.input());
        assert_eq!(colors.len(), small.mesh.len());
        assert!(colors.iter().all(|c| c[3] == 255), "{overlay:?}");
        assert_eq!(map.draw(overlay, &small.input()).rgb.len(), 3 * 32 * 16);
    }
}

#[test]
fn every_overlay_explains_itself() {
    let small = small(0.01);
    for overlay in Overlay::ALL {
        let Legend { title, entries, .. } = overlay.legend(&small.input());
        assert!(!title.is_empty());
        match entries {
            LegendEntries::Gradient { stops } => {
                assert!(stops.len() > 2 && stops.windows(2).all(|w| w[0].0 <= w[1].0));
            }
            LegendEntries::Classes(classes) => assert!(!classes.is_empty()),
        }
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
}

#[test]
fn folds_of_one_azimuth_have_one_colour_at_any_longitude() {
    let folds = colorize(Overlay::FoldDirection, &small(0.01).input());
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
