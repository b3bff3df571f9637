//! A planet follows its preset while the file changes on disk, by Bevy's own watcher of files.

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Far more than the watcher takes to notice, a third of a second.
const PATIENCE: Duration = Duration::from_secs(60);

/// An app whose assets lie in a folder of its own, with a planet of a preset there.
struct Game {
    app: App,
    planet: Entity,
    folder: TempDir,
}

impl Game {
    fn new(preset: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(preset_in(&folder), preset).unwrap();
        let mut app = App::new();
        let assets = AssetPlugin {
            file_path: folder.path().to_string_lossy().into(),
            ..default()
        };
        app.add_plugins((TaskPoolPlugin::default(), assets, PangaeaPlugins));
        app.finish();
        let preset = PlanetPreset(app.world().resource::<AssetServer>().load(NAME));
        let at_rest = ClockControls {
            paused: true,
            ..default()
        };
        let planet = app.world_mut().spawn((preset, at_rest)).id();
        Self {
            app,
            planet,
            folder,
        }
    }

    fn preset(&self) -> PathBuf {
        preset_in(&self.folder)
    }

    fn get<C: Component>(&self) -> Option<&C> {
        self.app.world().get::<C>(self.planet)
    }

    /// Runs frames until the planet is as it should be.
    fn wait(&mut self, until: impl Fn(&Self) -> bool) {
        let began = Instant::now();
        while !until(self) {
            assert!(began.elapsed() < PATIENCE, "the planet does not follow");
            self.app.update();
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    fn samples(&self) -> Option<usize> {
        self.get::<Crust>().map(Crust::len)
    }

    fn erosion(&self) -> Option<f64> {
        self.get::<TectonicParams>().map(|params| params.erosion)
    }
}

const NAME: &str = "small.planet.ron";

fn preset_in(folder: &TempDir) -> PathBuf {
    folder.path().join(NAME)
}

/// Saves as editors do that write a new file beside the old one and give it its name.
fn replace(file: &Path, text: &str) {
    let beside = file.with_extension("new");
    fs::write(&beside, text).unwrap();
    fs::rename(beside, file).unwrap();
}

#[test]
fn a_parameter_changed_on_disk_reaches_the_living_planet() {
    let mut game = Game::new("(seed: 9, samples: 500, plate_count: 8)");
    game.wait(|game| game.samples() == Some(500));
    run_steps(game.app.world_mut(), game.planet, 3);
    let text = "(seed: 9, samples: 500, plate_count: 8, params: (erosion: 0.5))";
    fs::write(game.preset(), text).unwrap();
    game.wait(|game| game.erosion() == Some(0.5));
    let step = game.get::<GeologicClock>().map(|clock| clock.step);
    assert_eq!(step, Some(3), "the planet lives on");
}

#[test]
fn another_planet_on_disk_is_grown_anew() {
    let mut game = Game::new("(seed: 9, samples: 500, plate_count: 8)");
    game.wait(|game| game.samples() == Some(500));
    fs::write(game.preset(), "(seed: 9, samples: 600, plate_count: 8)").unwrap();
    game.wait(|game| game.samples() == Some(600));
}

#[test]
fn a_file_that_replaces_the_preset_is_followed() {
    let mut game = Game::new("(seed: 9, samples: 500, plate_count: 8)");
    game.wait(|game| game.samples() == Some(500));
    replace(&game.preset(), "(seed: 9, samples: 600, plate_count: 8)");
    game.wait(|game| game.samples() == Some(600));
}

#[test]
fn a_preset_that_is_broken_for_a_while_harms_nothing() {
    let mut game = Game::new("(seed: 9, samples: 500, plate_count: 8)");
    game.wait(|game| game.samples() == Some(500));
    fs::write(game.preset(), "(seed: 9, samples: 60").unwrap();
    let began = Instant::now();
    game.wait(|_| began.elapsed() > Duration::from_secs(1));
    assert_eq!(game.samples(), Some(500));
    fs::write(game.preset(), "(seed: 9, samples: 600, plate_count: 8)").unwrap();
    game.wait(|game| game.samples() == Some(600));
}
