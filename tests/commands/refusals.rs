//! Commands that no planet may accept: each is refused in one line and changes nothing.

use super::planet;
use bevy::math::DVec3;
use bevy_pangaea::authoring::CommandError;
use bevy_pangaea::math::{any_tangent, lat_lon};
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::order::{paint, paint_all, rift, set_crust, set_motion, set_param, set_process};
use pangaea_tests::world::{digest, get, heard, obey, plates, state};

/// Asserts that all commands are refused.
fn refused(commands: Vec<TectonicCommand>) {
    let (mut app, planet) = planet();
    let before = digest(&app, planet);
    for wanted in commands {
        let refused = heard::<CommandRejected>(&app).len();
        assert!(
            !obey(&mut app, planet, wanted.clone()),
            "{wanted:?} was accepted"
        );
        let events = heard::<CommandRejected>(&app);
        assert_eq!(events.len(), refused + 1);
        let reason = events[refused].error.to_string();
        assert!(
            !reason.is_empty() && !reason.contains('\n'),
            "one line: {reason}"
        );
        assert_eq!(
            digest(&app, planet),
            before,
            "{wanted:?} changed the planet"
        );
    }
    let recording = get::<Recording>(&app, planet);
    assert!(recording.0.is_empty(), "refused commands are not recorded");
}

const PLATE: PlateId = PlateId(1);
const BAD: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300];

#[test]
fn bad_coordinates_and_speeds() {
    refused(BAD.into_iter().flat_map(bad_motions).collect());
}

fn bad_motions(bad: f64) -> [TectonicCommand; 5] {
    [
        set_motion(PLATE, (bad, 0.0), 10.0),
        set_motion(PLATE, (0.0, bad), 10.0),
        set_motion(PLATE, (0.0, 0.0), bad),
        rift(PLATE, &[(0.0, 0.0), (bad, 1.0)], 2),
        rift(PLATE, &[(0.0, bad), (1.0, 1.0)], 2),
    ]
}

#[test]
fn bad_brushes() {
    refused(BAD.into_iter().flat_map(bad_paints).collect());
}

fn bad_paints(bad: f64) -> [TectonicCommand; 5] {
    [
        paint_all(Brush::Raise(bad)),
        paint_all(Brush::Elevation(bad)),
        raise_disc((bad, 0.0), 100.0),
        raise_disc((0.0, bad), 100.0),
        raise_disc((0.0, 0.0), bad),
    ]
}

fn raise_disc(center: (f64, f64), radius: f64) -> TectonicCommand {
    paint(PaintTarget::Disc { center, radius }, Brush::Raise(1.0))
}

#[test]
fn bad_parameters_and_names() {
    let values = TectonicParams::TABLE
        .iter()
        .flat_map(|info| BAD.map(|bad| set_param(info.name, bad)));
    let names = [
        set_param("magic", 1.0),
        set_param("", 1.0),
        set_param("abyss_elevation", -0.5),
        set_process("magic", true),
        set_motion(PLATE, (0.0, 0.0), 100.1),
    ];
    refused(values.chain(names).collect());
}

#[test]
fn plates_that_are_not_there() {
    let gone = [PlateId(40), PlateId(u32::MAX)];
    refused(gone.into_iter().flat_map(commands_to).collect());
}

fn commands_to(plate: PlateId) -> [TectonicCommand; 4] {
    [
        set_motion(plate, (0.0, 0.0), 10.0),
        rift(plate, &[], 2),
        rift(plate, &[(0.0, 0.0), (1.0, 1.0)], 2),
        set_crust(plate, CrustKind::Continental),
    ]
}

#[test]
fn a_plate_that_is_not_there_is_refused_by_name() {
    let (mut app, planet) = planet();
    assert!(!obey(
        &mut app,
        planet,
        set_crust(PlateId(77), CrustKind::Oceanic)
    ));
    let error = heard::<CommandRejected>(&app).pop().unwrap().error;
    assert_eq!(error, CommandError::NoPlate(PlateId(77)));
    assert_eq!(error.to_string(), "there is no plate 77");
}

#[test]
fn rifts_of_too_few_or_too_many_fragments_and_points() {
    let fragments = [0, 1, 5, u32::MAX].into_iter().flat_map(|count| {
        let across = [(-60.0, 0.0), (60.0, 0.0)];
        [rift(PLATE, &[], count), rift(PLATE, &across, count)]
    });
    let lines = [1, 2, 2000].map(|points| rift(PLATE, &vec![(10.0, 10.0); points], 2));
    refused(fragments.chain(lines).collect());
}

/// Largest angle in radians between a direction and a sample of a plate.
fn farthest(state: &PlanetState, plate: PlateId, from: DVec3) -> f64 {
    let own = (0..state.crust.len()).filter(|&i| state.frames.plate(state.crust.frame[i]) == plate);
    let angles = own.map(|i| {
        let frame = state.frames[usize::from(state.crust.frame[i])];
        frame
            .to_world(state.lattice.points()[i])
            .angle_between(from)
    });
    angles.fold(0.0, f64::max)
}

#[test]
fn a_line_that_misses_the_plate() {
    let (mut app, planet) = planet();
    let table = plates(&app, planet);
    let smallest = table
        .rows()
        .iter()
        .min_by(|a, b| a.stats.area.total_cmp(&b.stats.area))
        .unwrap();
    // The great circle of which the plate's middle is a pole: all of the plate lies on one side.
    let middle = smallest.stats.centroid;
    let reach = farthest(&state(&app, planet), smallest.id, middle).to_degrees();
    assert!(
        reach < 60.0,
        "the smallest plate reaches {reach}° from its middle"
    );
    let east = any_tangent(middle);
    let line = [east, (east + middle.cross(east)).normalize()].map(lat_lon);
    let before = digest(&app, planet);
    assert!(!obey(&mut app, planet, rift(smallest.id, &line, 2)));
    assert_eq!(digest(&app, planet), before);
}
