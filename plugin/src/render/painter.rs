//! Keeps globes up to date with their planets.
//!
//! A picture is painted on another thread: colours, gradients, lines, the picking tree. The main
//! thread only hands over the surface and takes finished buffers. What needs no painting (sun,
//! exaggeration, sea, air) reaches the shaders in the same frame.

use super::columns::{self, Shape};
use super::horizon::hide_far_side;
use super::parts::{Shell, build_parts, shade, show_pictures};
use super::{Globe, GlobePicker, lines, mesh};
use crate::control::{Bake, PlanetBake};
use crate::crust::{PlanetSurface, Surface};
use crate::math;
use crate::overlay::{Overlay, OverlayInput, colorize};
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::{Plate, PlateId, PlateMotion, PlateRow, PlateStats, PlateTable, Plates};
use crate::resample::SurfaceProjection;
use crate::sphere::SphereMesh;
use bevy::asset::AssetEventSystems;
use bevy::prelude::*;
use bevy::tasks::{AsyncComputeTaskPool, Task, TaskPool, futures::check_ready};
use std::sync::{Arc, OnceLock};

/// Systems that draw globes.
pub(super) struct PainterPlugin;

impl Plugin for PainterPlugin {
    fn build(&self, app: &mut App) {
        app.init_resource::<Shell>()
            .configure_sets(PostUpdate, GlobeSystems.before(AssetEventSystems))
            .add_systems(
                PostUpdate,
                (
                    attach,
                    hang_pictures,
                    build_parts,
                    show_pictures,
                    shade,
                    hide_far_side,
                    begin_pictures,
                )
                    .chain()
                    .in_set(GlobeSystems),
            );
    }
}

#[derive(SystemSet, Clone, Debug, PartialEq, Eq, Hash)]
struct GlobeSystems;

/// What the globe shows at the moment; changes when a new picture is shown. On the planet's entity.
#[derive(Component, Clone, Debug, PartialEq)]
pub struct GlobeDrawn {
    /// [`Surface::version`] that was painted.
    pub version: u64,
    /// The overlay that was painted.
    pub overlay: Overlay,
}

/// The part of a [`Globe`] that pictures depend on.
#[derive(Clone, Debug, PartialEq)]
struct Subject {
    version: u64,
    overlay: Overlay,
    relief: f32,
    sea: bool,
    boundaries: bool,
    selected: Option<PlateId>,
    /// [`Surface::version`] of the bake, if the overlay shows one.
    bake: Option<u64>,
}

impl Subject {
    fn new(version: u64, globe: &Globe, radius: f64) -> Self {
        Self {
            version,
            overlay: globe.overlay,
            relief: globe.relief(radius),
            sea: globe.sea,
            boundaries: globe.boundaries,
            selected: globe.selected,
            bake: None,
        }
    }
}

/// The painter's memory of a planet.
#[derive(Component, Default)]
pub(super) struct Easel {
    task: Option<Task<Picture>>,
    /// A finished picture that is not shown yet.
    pub(super) finished: Option<Picture>,
    subject: Option<Subject>,
    /// Least and largest distance of the ground from the centre, in planet radii.
    pub(super) radii: (f64, f64),
    /// The lattice that the meshes were built for.
    lattice: Option<Arc<SphereMesh>>,
}

/// Everything that a picture is painted from.
struct Job {
    planet: Planet,
    mesh: Arc<SphereMesh>,
    surface: Arc<Surface>,
    plates: PlateTable,
    params: TectonicParams,
    globe: Globe,
    subject: Subject,
    fresh: bool,
    bake: Option<Arc<Bake>>,
}

/// A painted picture.
pub(super) struct Picture {
    subject: Subject,
    /// The packed samples.
    pub(super) columns: Vec<u8>,
    pub(super) lines: Mesh,
    pub(super) no_lines: bool,
    /// The meshes, where the lattice is new.
    pub(super) ground: Option<Vec<mesh::Patch>>,
    radii: (f64, f64),
    picker: Option<GlobePicker>,
}

fn attach(
    mut commands: Commands,
    bare: Query<
        (Entity, Has<Globe>),
        (
            With<Planet>,
            With<PlanetSurface>,
            Or<(Without<Globe>, Without<Easel>)>,
        ),
    >,
) {
    for (planet, has_globe) in &bare {
        let mut planet = commands.entity(planet);
        planet.insert((Easel::default(), SurfaceProjection::EveryStep));
        if !has_globe {
            planet.insert(Globe::default());
        }
    }
}

/// Begins a picture of every planet that has changed and is not being painted.
fn begin_pictures(
    mut planets: Query<(
        (&Planet, &Lattice, &PlanetSurface, &TectonicParams, &Globe),
        (Option<&Plates>, Option<&PlanetBake>, &mut Easel),
    )>,
    plates: Query<(Entity, &PlateId, &PlateMotion, &PlateStats, &Plate)>,
) {
    for ((planet, lattice, surface, params, globe), (members, bake, mut easel)) in &mut planets {
        let mut subject = Subject::new(surface.version, globe, planet.radius);
        if globe.overlay.needs_bake() {
            subject.bake = bake.map(|bake| bake.version);
        }
        let busy = easel.task.is_some() || easel.finished.is_some();
        if busy || easel.subject.as_ref() == Some(&subject) || surface.len() != lattice.len() {
            continue;
        }
        let fresh = !easel
            .lattice
            .as_ref()
            .is_some_and(|known| Arc::ptr_eq(known, &lattice.0));
        let members = members.map(|m| m.iter()).into_iter().flatten();
        let rows = members
            .filter_map(|plate| plates.get(plate).ok())
            .map(plate_row);
        let job = Job {
            planet: *planet,
            mesh: lattice.0.clone(),
            surface: surface.0.clone(),
            plates: PlateTable::new(rows),
            params: params.clone(),
            globe: globe.clone(),
            subject: subject.clone(),
            fresh,
            bake: bake.map(|bake| bake.0.clone()),
        };
        easel.subject = Some(subject);
        easel.lattice = Some(lattice.0.clone());
        let pool = AsyncComputeTaskPool::get_or_init(TaskPool::new);
        easel.task = Some(pool.spawn(async move { aside(|| paint(job)) }));
    }
}

fn plate_row(
    (entity, id, motion, stats, plate): (Entity, &PlateId, &PlateMotion, &PlateStats, &Plate),
) -> PlateRow {
    PlateRow {
        id: *id,
        entity,
        motion: *motion,
        stats: *stats,
        born: plate.born,
    }
}

/// Runs `work` with a thread of its own for its parallel loops, so that painting never holds the
/// threads that a step of the simulation waits for.
fn aside<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    let build = || {
        let name = |_| "globe painter".to_string();
        rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .thread_name(name)
            .build()
            .ok()
    };
    match POOL.get_or_init(build) {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

fn paint(job: Job) -> Picture {
    let Job {
        planet,
        mesh,
        surface,
        plates,
        params,
        globe,
        subject,
        fresh,
        bake,
    } = job;
    let input = OverlayInput {
        planet: &planet,
        mesh: &mesh,
        surface: &surface,
        plates: &plates,
        params: &params,
        bake: bake.as_deref(),
    };
    // The elevation is tinted by the shader, which knows it between the samples too.
    let colors = match globe.overlay {
        Overlay::Elevation => Vec::new(),
        overlay => colorize(overlay, &input),
    };
    let shape = Shape::new(&mesh, &surface, globe.sea);
    let marked = |i: usize| {
        globe
            .selected
            .is_some_and(|plate| surface.plate[i] == plate)
    };
    let columns = columns::pack(&mesh, &shape, &colors, marked);
    // Lines and rays meet the relief as it is drawn.
    let radius = |i| globe.drawn_radius(shape.elevation(i), subject.relief);
    let radii: Vec<f32> = (0..mesh.len()).map(radius).collect();
    let range = radii
        .iter()
        .fold((1.0, 1.0), |(low, high): (f64, f64), &r| {
            (low.min(r.into()), high.max(r.into()))
        });
    // Triangles are flat: between their corners the ground is lower.
    let range = (range.0 * math::cos(mesh.spacing()), range.1);
    let lines = lines::collect(&input, &globe, |i| shape.elevation(i));
    Picture {
        columns,
        no_lines: lines.len() == 0,
        lines: lines.into_mesh(),
        ground: fresh.then(|| mesh::ground(&mesh)),
        radii: range,
        picker: Some(GlobePicker::new(mesh.clone(), radii)),
        subject,
    }
}

/// Takes finished pictures off the other thread.
fn hang_pictures(mut commands: Commands, mut easels: Query<(Entity, &mut Easel)>) {
    for (planet, mut easel) in &mut easels {
        let Some(task) = &mut easel.task else {
            continue;
        };
        let Some(mut picture) = check_ready(task) else {
            continue;
        };
        easel.task = None;
        let drawn = GlobeDrawn {
            version: picture.subject.version,
            overlay: picture.subject.overlay,
        };
        commands.entity(planet).insert(drawn);
        if let Some(picker) = picture.picker.take() {
            commands.entity(planet).insert(picker);
        }
        easel.radii = picture.radii;
        easel.finished = Some(picture);
    }
}
