use super::boundaries::OUTLINE;
use super::*;
use crate::crust::{Crust, Surface};
use crate::overlay::BoundaryKind;
use crate::overlay::baked::tests::bake;
use crate::params::TectonicParams;
use crate::planet::Planet;
use crate::plate::{PlateId, PlateMotion, PlateRow, PlateStats, PlateTable};
use crate::render::axes::from_bevy;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A planet of two halves that turn against each other about the poles.
struct TwoHalves {
    planet: Planet,
    mesh: SphereMesh,
    surface: Surface,
    plates: PlateTable,
    params: TectonicParams,
}

impl TwoHalves {
    fn new() -> Self {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let params = TectonicParams::default();
        let half = |p: &DVec3| PlateId(u32::from(p.z > 0.0));
        let surface = Surface {
            version: 1,
            crust: Crust::ocean(mesh.len(), &params),
            plate: mesh.points().iter().map(half).collect(),
            trench: vec![0.0; mesh.len()],
            ..default()
        };
        Self {
            planet: Planet {
                radius: 6370.0,
                seed: 1,
            },
            mesh,
            surface,
            plates: PlateTable::new([row(0, -0.01), row(1, 0.01)]),
            params,
        }
    }

    fn input<'a>(&'a self, bake: Option<&'a Bake>) -> OverlayInput<'a> {
        OverlayInput {
            planet: &self.planet,
            mesh: &self.mesh,
            surface: &self.surface,
            plates: &self.plates,
            params: &self.params,
            bake,
        }
    }

    fn lines(&self, globe: &Globe) -> Lines {
        self.lines_with(globe, None)
    }

    fn lines_with(&self, globe: &Globe, bake: Option<&Bake>) -> Lines {
        collect(&self.input(bake), globe, |i| self.surface.elevation(i))
    }
}

fn row(id: u32, speed: f64) -> PlateRow {
    PlateRow {
        id: PlateId(id),
        entity: Entity::PLACEHOLDER,
        motion: PlateMotion::from_angular_velocity(DVec3::Z * speed),
        stats: PlateStats::default(),
        born: 0.0,
    }
}

/// A globe that shows an overlay.
fn showing(overlay: Overlay) -> Globe {
    Globe {
        overlay,
        ..default()
    }
}

/// Length of all lines in radians.
fn length(lines: &Lines) -> f32 {
    lines
        .here
        .chunks(4)
        .zip(lines.there.chunks(4))
        .map(|(a, b)| Vec3::from(a[0]).distance(b[0].into()))
        .sum()
}

#[test]
fn the_boundary_between_two_halves_goes_once_round_the_equator() {
    let lines = TwoHalves::new().lines(&Globe {
        boundaries: true,
        ..default()
    });
    assert!((6.2..7.5).contains(&length(&lines)), "{}", length(&lines));
    let is_equator = |p: &[f32; 3]| p[1].abs() < 0.06;
    assert!(lines.here.iter().all(is_equator), "the planet's axis is y");
    let transform = BoundaryKind::Transform.color();
    assert!(lines.colors.iter().all(|&c| c == transform));
}

#[test]
fn the_selected_plate_is_outlined_even_without_boundaries() {
    let [outline, nothing] = [1, 9].map(|plate| {
        TwoHalves::new().lines(&Globe {
            selected: Some(PlateId(plate)),
            ..default()
        })
    });
    assert!(outline.len() > 0 && outline.colors.iter().all(|&c| c == OUTLINE));
    assert_eq!(nothing.len(), 0, "there is no such plate");
}

#[test]
fn nothing_asked_for_is_nothing_drawn() {
    let lines = TwoHalves::new().lines(&Globe::default());
    assert_eq!(lines.len(), 0);
    assert_eq!(lines.into_mesh().count_vertices(), 4);
}

#[test]
fn arrows_point_along_the_motion() {
    let world = TwoHalves::new();
    let lines = world.lines(&showing(Overlay::Velocity));
    assert!(lines.len() > 300, "{}", lines.len());
    // Of the three lines of an arrow the first is its shaft.
    for k in (0..lines.len()).step_by(3) {
        let tail = from_bevy(lines.here[4 * k].into());
        let head = from_bevy(lines.there[4 * k].into());
        let east = DVec3::Z.cross(tail);
        let sign = if tail.z > 0.0 { 1.0 } else { -1.0 };
        assert!(sign * (head - tail).dot(east) > 0.0, "{tail} {head}");
    }
}

#[test]
fn axes_are_drawn_only_where_there_are_any() {
    let mut world = TwoHalves::new();
    let globe = showing(Overlay::FoldDirection);
    assert_eq!(world.lines(&globe).len(), 0);
    for (fold, p) in world.surface.crust.fold.iter_mut().zip(world.mesh.points()) {
        if p.x > 0.9 {
            *fold = DVec3::Z.cross(*p).normalize().as_vec3();
        }
    }
    let lines = world.lines(&globe);
    assert!(lines.len() > 10 && lines.here.iter().all(|p| p[0] > 0.85));
}

#[test]
fn rivers_run_down_to_the_sea_in_lines() {
    let globe = showing(Overlay::Rivers);
    let lines = TwoHalves::new().lines_with(&globe, Some(&bake()));
    assert!(lines.len() > 100);
    // Land is the northern half; the planet's axis is y.
    assert!(lines.here.iter().all(|p| p[1] > -0.1));
    let widths: Vec<f32> = lines.sides.iter().map(|side| side[1]).collect();
    assert!(widths.is_sorted(), "high orders lie on top");
    assert!(widths[0] < *widths.last().unwrap(), "and are wider");
}

#[test]
fn only_large_rivers_are_lines_of_discharge() {
    let planet = TwoHalves::new();
    let bake = bake();
    let [rivers, discharges] = [Overlay::Rivers, Overlay::Drainage]
        .map(|overlay| planet.lines_with(&showing(overlay), Some(&bake)));
    assert!((11..rivers.len()).contains(&discharges.len()));
    assert!(discharges.here.iter().all(|p| rivers.here.contains(p)));
}

#[test]
fn without_a_bake_there_are_no_rivers() {
    assert_eq!(TwoHalves::new().lines(&showing(Overlay::Rivers)).len(), 0);
}
