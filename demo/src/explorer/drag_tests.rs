//! Drags as closed forms, and a press, a pull and a release on a planet.

use super::*;
use crate::explorer::state::ShownPlanet;
use crate::explorer::view::{ShownPlates, list_plates};
use bevy_pangaea::math::direction;
use bevy_pangaea::resample::project_now;
use bevy_pangaea::spawn::PlanetState;

const RADIUS: f64 = 6370.0;

/// The motion of a drag on an Earth that limits no speed.
fn unlimited(from: DVec3, to: DVec3) -> DraggedMotion {
    motion_of_drag(from, to, RADIUS, f64::INFINITY).unwrap()
}

#[test]
fn a_drag_east_along_the_equator_turns_about_the_north_pole() {
    let motion = unlimited(direction(0.0, 20.0), direction(0.0, 30.0));
    assert!(motion.pole.distance(DVec3::Z) < 1e-12);
    let west = unlimited(direction(0.0, 20.0), direction(0.0, 10.0));
    assert!(west.pole.distance(DVec3::NEG_Z) < 1e-12);
}

#[test]
fn the_distance_is_covered_in_20_my() {
    for degrees in [0.1, 10.0, 90.0, 170.0] {
        let motion = unlimited(direction(0.0, 0.0), direction(0.0, degrees));
        let distance = RADIUS * degrees.to_radians();
        assert!((motion.speed * 20.0 / distance - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_plate_moves_from_the_pressed_point_towards_the_released_one() {
    for (from, to) in [
        (direction(50.0, 10.0), direction(-20.0, 80.0)),
        (direction(-90.0, 0.0), direction(-60.0, 123.0)),
        (direction(5.0, 179.0), direction(7.0, -178.0)),
    ] {
        let DraggedMotion { pole, speed } = unlimited(from, to);
        let velocity = pole.cross(from);
        // The tangent of the great circle that leads to the released point.
        let tangent = (to - from * from.dot(to)).normalize();
        assert!(velocity.distance(tangent) < 1e-9);
        // After 20 My the pressed point has come to the released one.
        let turn = bevy_pangaea::math::rotation(pole, 20.0 * speed / RADIUS);
        assert!((turn * from).distance(to) < 1e-9);
    }
}

#[test]
fn the_speed_is_limited_and_the_pole_is_not_changed_by_that() {
    let (from, to) = (direction(10.0, 0.0), direction(40.0, 70.0));
    let slowed = motion_of_drag(from, to, RADIUS, 100.0).unwrap();
    assert_eq!(slowed.speed, 100.0);
    assert_eq!(slowed.pole, unlimited(from, to).pole);
}

#[test]
fn drags_without_a_direction_do_nothing() {
    for at in [direction(0.0, 0.0), direction(33.0, -71.0), DVec3::Z] {
        assert_eq!(motion_of_drag(at, at, RADIUS, 100.0), None);
        assert_eq!(motion_of_drag(at, -at, RADIUS, 100.0), None);
    }
    let nan = DVec3::splat(f64::NAN);
    assert_eq!(motion_of_drag(nan, DVec3::X, RADIUS, 100.0), None);
}

/// An app with a planet on show and the select tool.
fn app() -> App {
    let mut app = App::new();
    app.add_message::<Action>()
        .init_resource::<ButtonInput<MouseButton>>()
        .init_resource::<ButtonInput<KeyCode>>()
        .init_resource::<Tool>()
        .init_resource::<Pointer>()
        .init_resource::<PlateDrag>()
        .init_resource::<ShownPlates>()
        .add_systems(Update, (list_plates, drag_plates).chain());
    let recipe = PlanetRecipe {
        samples: 500,
        plate_count: 6,
        ..default()
    };
    let planet = PlanetState::new(&recipe).unwrap().spawn(app.world_mut());
    project_now(app.world_mut(), planet);
    app.insert_resource(ShownPlanet(Some(planet)));
    app
}

/// Runs a frame with the pointer over the ground at `ground`, and returns what was asked for.
fn frame(app: &mut App, ground: Option<DVec3>) -> Vec<Action> {
    app.world_mut().resource_mut::<Pointer>().ground = ground;
    app.update();
    let mut buttons = app.world_mut().resource_mut::<ButtonInput<MouseButton>>();
    buttons.clear();
    let mut actions = app.world_mut().resource_mut::<Messages<Action>>();
    actions.drain().collect()
}

/// Presses at 10° N 20° E, pulls, and releases at `to`. Returns what was asked for by the press,
/// and by the release.
fn drag(app: &mut App, to: Option<DVec3>) -> [Vec<Action>; 2] {
    let from = direction(10.0, 20.0);
    buttons(app).press(MouseButton::Left);
    let pressed = frame(app, Some(from));
    assert!(frame(app, to).is_empty(), "nothing is sent on the way");
    buttons(app).release(MouseButton::Left);
    [pressed, frame(app, to)]
}

fn buttons(app: &mut App) -> Mut<'_, ButtonInput<MouseButton>> {
    app.world_mut().resource_mut()
}

fn hold_shift(app: &mut App) {
    let mut keys = app.world_mut().resource_mut::<ButtonInput<KeyCode>>();
    keys.press(KeyCode::ShiftLeft);
}

#[test]
fn a_drag_with_shift_selects_the_plate_and_sets_its_motion_on_release() {
    let mut app = app();
    hold_shift(&mut app);
    let [pressed, released] = drag(&mut app, Some(direction(12.0, 20.0)));
    let [Action::Select(Some(selected))] = pressed[..] else {
        panic!("{pressed:?}")
    };
    let [Action::Tectonic(TectonicCommand::SetPlateMotion { plate, pole, speed })] = released[..]
    else {
        panic!("{released:?}")
    };
    assert_eq!(plate, selected);
    // Due north along 20° E.
    assert!(
        pole.0.abs() < 1e-9 && (pole.1 + 70.0).abs() < 1e-9,
        "{pole:?}"
    );
    assert!((speed - RADIUS * 2.0_f64.to_radians() / 20.0).abs() < 1e-6);
}

#[test]
fn other_drags_set_no_motion() {
    let mut app = app();
    assert_eq!(drag(&mut app, Some(DVec3::X)).concat().len(), 0);
    hold_shift(&mut app);
    let [pressed, released] = drag(&mut app, None);
    assert_eq!((pressed.len(), released.len()), (1, 0), "beside the globe");
    let [pressed, released] = drag(&mut app, Some(direction(10.0, 20.0)));
    assert_eq!((pressed.len(), released.len()), (1, 0), "not moved");
    *app.world_mut().resource_mut::<Tool>() = Tool::Paint;
    assert_eq!(drag(&mut app, Some(DVec3::X)).concat().len(), 0);
}

#[test]
fn a_button_that_goes_without_a_release_ends_the_drag() {
    let mut app = app();
    hold_shift(&mut app);
    buttons(&mut app).press(MouseButton::Left);
    frame(&mut app, Some(direction(10.0, 20.0)));
    buttons(&mut app).reset_all();
    assert!(frame(&mut app, Some(DVec3::X)).is_empty());
    assert_eq!(*app.world().resource::<PlateDrag>(), PlateDrag(None));
}
