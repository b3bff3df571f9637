//! Digests as committed: the same bits on every machine, build profile and thread count.
//!
//! A line for every stage, so that the first line that differs names the stage that changed. After
//! an intended change `PANGAEA_BLESS=1` writes the file anew.

use super::lively;
use bevy::prelude::*;
use bevy_pangaea::control::{Bake, BakeSettings, PlanetBake, bake_now};
use bevy_pangaea::prelude::*;
use bevy_pangaea::query::{Ground, LEVELS, PlanetGround, Rules};
use bevy_pangaea::random::{Purpose, Stream};
use bevy_pangaea::sphere::SphereMesh;
use pangaea_tests::probe::{Change, Snapshot, probe};
use pangaea_tests::world::{digest, get, planet_app, steps};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// Steps after each stage of which there is a line: the first, one in the middle, and one that
/// resamples.
const STEPS: [u64; 3] = [0, 6, 19];

fn mesh_hash(samples: u32) -> String {
    let mesh = SphereMesh::fibonacci(samples).unwrap();
    let mut hasher = blake3::Hasher::new();
    for p in mesh.points() {
        floats(&mut hasher, &p.to_array());
    }
    for t in mesh.triangles() {
        for i in t {
            hasher.update(&i.to_le_bytes());
        }
    }
    floats(&mut hasher, mesh.areas());
    short(&hasher)
}

fn floats(hasher: &mut blake3::Hasher, numbers: &[f64]) {
    for x in numbers {
        hasher.update(&x.to_bits().to_le_bytes());
    }
}

/// 16 hexadecimal digits are enough to see a difference.
fn short(hasher: &blake3::Hasher) -> String {
    hasher.finalize().to_hex()[..16].to_string()
}

/// The numbers of one column in the order of the hash.
fn numbers(crust: &Crust, i: usize) -> impl Iterator<Item = f32> {
    let scalars = [
        crust.thickness[i],
        crust.elevation[i],
        crust.ocean_age[i],
        crust.orogeny_age[i],
    ];
    let vectors = [crust.ridge[i], crust.fold[i]];
    scalars
        .into_iter()
        .chain(vectors.into_iter().flat_map(|v| v.to_array()))
}

fn hash(snapshot: &Snapshot) -> String {
    let mut hasher = blake3::Hasher::new();
    let crust = &snapshot.crust;
    for i in 0..crust.len() {
        for number in numbers(crust, i) {
            hasher.update(&number.to_le_bytes());
        }
        hasher.update(&crust.frame[i].to_le_bytes());
        hasher.update(&[crust.kind[i] as u8, crust.orogeny[i] as u8]);
    }
    for frame in snapshot.frames.iter() {
        hasher.update(&frame.plate.0.to_le_bytes());
        floats(&mut hasher, &frame.rotation.to_array());
    }
    for (id, motion, born) in &snapshot.plates {
        hasher.update(&id.0.to_le_bytes());
        floats(&mut hasher, &motion.axis.to_array());
        floats(&mut hasher, &[motion.speed, *born]);
    }
    for segment in &snapshot.polarity.0 {
        // The text of the first goldens, which had a shorter name for the type.
        let text = format!("{segment:?}").replacen("FrontSegment", "Segment", 1);
        hasher.update(text.as_bytes());
    }
    for amount in &snapshot.ledger.booked {
        floats(&mut hasher, &[amount.area, amount.volume]);
    }
    short(&hasher)
}

fn stages() -> Vec<String> {
    let mut lines = vec![format!("mesh of 6000 samples: {}", mesh_hash(6000))];
    let (mut app, planet) = planet_app(&lively(1, 6000));
    lines.push(format!("initial planet: {}", digest(&app, planet)));
    let seen = Arc::new(Mutex::new(Vec::new()));
    let log = Arc::clone(&seen);
    probe(&mut app, move |change| {
        log.lock().unwrap().extend(stage(change))
    });
    steps(&mut app, planet, 20);
    lines.append(&mut seen.lock().unwrap());
    lines.push(format!("after 20 steps: {}", digest(&app, planet)));
    steps(&mut app, planet, 40);
    lines.push(format!("after 60 steps: {}", digest(&app, planet)));
    lines.append(&mut ground(&mut app, planet));
    lines
}

/// The line of a stage, if it has one.
fn stage(change: &Change) -> Option<String> {
    let ends_step = matches!(change.stage, Stage::Commit | Stage::Projection);
    let has_line = STEPS.contains(&change.step) && !ends_step;
    let (step, name) = (change.step, change.stage.name());
    has_line.then(|| format!("step {step}, {name}: {}", hash(&change.after)))
}

/// Spacing of the base mesh in radians: some 9000 vertices.
const SPACING: f64 = 0.03;

/// Climate, rivers, control mesh and the finest ground of the planet as it is.
fn ground(app: &mut App, planet: Entity) -> Vec<String> {
    let digest_before = digest(app, planet);
    bevy_pangaea::resample::project_now(app.world_mut(), planet);
    app.world_mut().entity_mut(planet).insert(BakeSettings {
        spacing: SPACING,
        ..default()
    });
    bake_now(app.world_mut(), planet).unwrap();
    assert_eq!(digest(app, planet), digest_before, "a bake changes nothing");
    let bake = get::<PlanetBake>(app, planet);
    let points = bake.mesh().points().iter();
    let discharge = bake.drainage.discharge.iter();
    vec![
        line(
            "base mesh",
            points.flat_map(|p| p.to_array()).map(f64::to_le_bytes),
        ),
        line("rain", bake.climate.rain.iter().map(|x| x.to_le_bytes())),
        line("discharge", discharge.map(|x| x.to_le_bytes())),
        line("control mesh", [format!("{:?}", bake.control)]),
        line(
            "ground at level 17",
            heights(bake).iter().map(|x| x.to_le_bytes()),
        ),
    ]
}

/// Heights of the finest level at directions of chance.
fn heights(bake: &Bake) -> Vec<f32> {
    let ground = PlanetGround::of_bake(bake, Rules::default()).unwrap();
    let stream = Stream::new(1, Purpose::ReliefSites, 1);
    let directions: Vec<_> = (0..400).map(|i| stream.direction(2 * i)).collect();
    let mut heights = vec![0.0; directions.len()];
    ground.heights(&directions, LEVELS, &mut heights).unwrap();
    heights
}

/// A name with the hash of bytes.
fn line<B: AsRef<[u8]>>(name: &str, parts: impl IntoIterator<Item = B>) -> String {
    let mut hasher = blake3::Hasher::new();
    for part in parts {
        hasher.update(part.as_ref());
    }
    format!("{name}: {}", short(&hasher))
}

#[test]
fn digests_are_as_committed() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden/planet.txt");
    let found = stages();
    if std::env::var_os("PANGAEA_BLESS").is_some_and(|value| value == "1") {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, found.join("\n") + "\n").unwrap();
        return;
    }
    let text =
        std::fs::read_to_string(&path).expect("golden/planet.txt; PANGAEA_BLESS=1 writes it");
    let wanted: Vec<&str> = text.lines().collect();
    for (wanted, found) in wanted.iter().zip(&found) {
        assert_eq!(
            wanted,
            found,
            "the first stage that differs from {}",
            path.display()
        );
    }
    assert_eq!(wanted.len(), found.len());
}
