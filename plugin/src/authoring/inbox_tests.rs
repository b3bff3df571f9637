use super::*;
use crate::PangaeaPlugins;
use crate::authoring::apply_now;

#[derive(Resource, Default)]
struct Refused(Vec<CommandRejected>);

fn app() -> App {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins)
        .init_resource::<Refused>()
        .add_observer(|event: On<CommandRejected>, mut refused: ResMut<Refused>| {
            refused.0.push(event.event().clone());
        });
    app
}

#[test]
fn an_entity_that_is_no_planet_refuses_commands() {
    let mut app = app();
    let rock = app.world_mut().spawn_empty().id();
    app.world_mut()
        .commands()
        .entity(rock)
        .tectonic(TectonicCommand::Resample);
    app.world_mut().flush();
    let refused = &app.world().resource::<Refused>().0;
    assert_eq!(refused.len(), 1);
    assert_eq!(refused[0].planet, rock);
    assert_eq!(refused[0].error, CommandError::NoPlanet);
    assert!(app.world().get::<Inbox>(rock).is_none());
}

#[test]
fn every_command_to_no_planet_is_an_error() {
    let mut app = app();
    let rock = app.world_mut().spawn_empty().id();
    for command in [
        TectonicCommand::Resample,
        TectonicCommand::SetParam {
            name: "erosion".into(),
            value: 0.1,
        },
        TectonicCommand::SetProcess {
            name: "drift".into(),
            on: false,
        },
    ] {
        let outcome = apply_now(app.world_mut(), rock, &command);
        assert_eq!(outcome, Err(CommandError::NoPlanet), "{command:?}");
    }
}
