use super::*;
use crate::crust::{Crust, Surface};
use crate::params::TectonicParams;
use crate::planet::Planet;
use crate::plate::{PlateId, PlateMotion, PlateRow, PlateStats, PlateTable};
use crate::sphere::SphereMesh;

struct World {
    planet: Planet,
    mesh: SphereMesh,
    surface: Surface,
    plates: PlateTable,
    params: TectonicParams,
}

impl World {
    /// A planet of two halves that turn against each other about the poles.
    fn new() -> Self {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let params = TectonicParams::default();
        let surface = Surface {
            version: 1,
            crust: Crust::ocean(mesh.len(), &params),
            plate: mesh
                .points()
                .iter()
                .map(|p| PlateId(u32::from(p.z > 0.0)))
                .collect(),
            trench: vec![0.0; mesh.len()],
            ..default()
        };
        let row = |id: u32, speed: f64| PlateRow {
            id: PlateId(id),
            entity: Entity::PLACEHOLDER,
            motion: PlateMotion::from_angular_velocity(DVec3::Z * speed),
            stats: PlateStats::default(),
            born: 0.0,
        };
        let plates = PlateTable::new([row(0, -0.01), row(1, 0.01)]);
        Self {
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

    fn lines(&self, globe: &Globe) -> Lines {
        let Self {
            planet,
            mesh,
            surface,
            plates,
            params,
        } = self;
        let input = OverlayInput {
            planet,
            mesh,
            surface,
            plates,
            params,
            bake: None,
        };
        collect(&input, globe, |i| surface.elevation(i))
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
    let lines = World::new().lines(&Globe {
        boundaries: true,
        ..default()
    });
    assert!((6.2..7.5).contains(&length(&lines)), "{}", length(&lines));
    assert!(
        lines.here.iter().all(|p| p[1].abs() < 0.06),
        "the planet's axis is y"
    );
    assert!(
        lines
            .colors
            .iter()
            .all(|&c| c == BoundaryKind::Transform.color())
    );
}

#[test]
fn the_selected_plate_is_outlined_even_without_boundaries() {
    let world = World::new();
    let lines = world.lines(&Globe {
        selected: Some(PlateId(1)),
        ..default()
    });
    assert!(lines.len() > 0 && lines.colors.iter().all(|&c| c == OUTLINE));
    assert_eq!(
        world
            .lines(&Globe {
                selected: Some(PlateId(9)),
                ..default()
            })
            .len(),
        0
    );
}

#[test]
fn nothing_asked_for_is_nothing_drawn() {
    let lines = World::new().lines(&Globe::default());
    assert_eq!(lines.len(), 0);
    assert_eq!(lines.into_mesh().count_vertices(), 4);
}

#[test]
fn arrows_point_along_the_motion() {
    let world = World::new();
    let lines = world.lines(&Globe {
        overlay: Overlay::Velocity,
        ..default()
    });
    assert!(lines.len() > 300, "{}", lines.len());
    // Of the three lines of an arrow the first is its shaft.
    for k in (0..lines.len()).step_by(3) {
        let tail = crate::render::from_bevy(lines.here[4 * k].into());
        let head = crate::render::from_bevy(lines.there[4 * k].into());
        let east = DVec3::Z.cross(tail);
        let sign = if tail.z > 0.0 { 1.0 } else { -1.0 };
        assert!(sign * (head - tail).dot(east) > 0.0, "{tail} {head}");
    }
}

#[test]
fn axes_are_drawn_only_where_there_are_any() {
    let mut world = World::new();
    let globe = Globe {
        overlay: Overlay::FoldDirection,
        ..default()
    };
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
    let bake = crate::overlay::baked::tests::bake();
    let World {
        planet,
        mesh,
        surface,
        plates,
        params,
    } = &World::new();
    let [globe, drainage] = [Overlay::Rivers, Overlay::Drainage].map(|overlay| Globe {
        overlay,
        ..default()
    });
    let input = OverlayInput {
        planet,
        mesh,
        surface,
        plates,
        params,
        bake: Some(&bake),
    };
    let lines = collect(&input, &globe, |i| surface.elevation(i));
    assert!(lines.len() > 100);
    // Land is the northern half; the planet's axis is y.
    assert!(lines.here.iter().all(|p| p[1] > -0.1));
    let widths: Vec<f32> = lines.sides.iter().map(|side| side[1]).collect();
    assert!(
        widths.is_sorted() && widths[0] < *widths.last().unwrap(),
        "high orders lie on top and are wider"
    );
    let discharges = collect(&input, &drainage, |i| surface.elevation(i));
    assert!(
        discharges.len() > 10 && discharges.len() < lines.len(),
        "{} of {} rivers are large",
        discharges.len(),
        lines.len()
    );
    assert!(discharges.here.iter().all(|p| lines.here.contains(p)));
    assert_eq!(
        collect(
            &OverlayInput {
                bake: None,
                ..input
            },
            &globe,
            |_| 0.0
        )
        .len(),
        0
    );
}
