//! Commands: each does what it says, is recorded, and is refused as a whole or not at all.

use bevy::prelude::*;
use bevy_pangaea::authoring::CommandError;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::{angle_between, direction};
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::prelude::*;
use pangaea_tests::measure::continents;
use pangaea_tests::shape::small;
use pangaea_tests::world::{
    command, digest, get, heard, listen, obey, planet_app, plates, state, steps,
};

fn planet() -> (App, Entity) {
    let (mut app, planet) = planet_app(&small(21, 4000));
    listen::<CommandApplied>(&mut app);
    listen::<CommandRejected>(&mut app);
    steps(&mut app, planet, 3);
    (app, planet)
}

/// Carries out a command that must be accepted, and checks that it is recorded with its time.
fn accept(app: &mut App, planet: Entity, wanted: TectonicCommand) {
    let (recorded, applied) = (
        get::<Recording>(app, planet).0.len(),
        heard::<CommandApplied>(app).len(),
    );
    assert!(
        obey(app, planet, wanted.clone()),
        "{wanted:?}: {:?}",
        heard::<CommandRejected>(app).last()
    );
    let recording = &get::<Recording>(app, planet).0;
    assert_eq!(recording.len(), recorded + 1);
    assert_eq!(
        recording.last().unwrap(),
        &TimedCommand {
            step: 3,
            command: wanted.clone()
        }
    );
    assert_eq!(heard::<CommandApplied>(app).len(), applied + 1);
    assert_eq!(heard::<CommandApplied>(app).last().unwrap().command, wanted);
    check_ledger(app, planet);
    steps(app, planet, 2);
}

fn check_ledger(app: &App, planet: Entity) {
    let (area, volume) = continents(get(app, planet), get::<Lattice>(app, planet), 6370.0);
    let expected = get::<Ledger>(app, planet).expected();
    assert!(
        (area - expected.area).abs() < 1.0,
        "{area} km² for {expected:?}"
    );
    assert!(
        (volume - expected.volume).abs() < 1e-6 * expected.volume.max(1e6),
        "{volume} km³ for {expected:?}"
    );
}

#[test]
fn a_plate_takes_the_motion_it_is_given() {
    for (speed, sign) in [(75.0, 1.0), (-75.0, -1.0), (0.0, 1.0)] {
        let (mut app, planet) = planet();
        let mut motion = None;
        let pole = (35.0, -120.0);
        assert!(obey(
            &mut app,
            planet,
            TectonicCommand::SetPlateMotion {
                plate: PlateId(4),
                pole,
                speed
            }
        ));
        for row in plates(&app, planet)
            .rows()
            .iter()
            .filter(|row| row.id == PlateId(4))
        {
            motion = Some(row.motion);
        }
        let motion = motion.unwrap();
        assert!((motion.speed * 6370.0 - speed.abs()).abs() < 1e-9);
        assert!(angle_between(motion.axis, direction(pole.0, pole.1) * sign) < 1e-9);
        steps(&mut app, planet, 1);
    }
}

#[test]
fn a_plate_rifts_along_a_line_and_at_random() {
    let (mut app, planet) = planet();
    let before = plates(&app, planet);
    let largest = before
        .rows()
        .iter()
        .max_by(|a, b| a.stats.area.total_cmp(&b.stats.area))
        .unwrap();
    let rift = TectonicCommand::RiftPlate {
        plate: largest.id,
        line: Vec::new(),
        fragments: 2,
    };
    assert_eq!(rifted(&mut app, planet, rift), before.rows().len() + 1);

    let (mut app, planet) = self::planet();
    let (lat, lon) = bevy_pangaea::math::lat_lon(largest.stats.centroid);
    let line = vec![
        ((lat - 5.0).max(-90.0), lon),
        ((lat + 5.0).min(90.0), lon + 1.0),
    ];
    let rift = TectonicCommand::RiftPlate {
        plate: largest.id,
        line,
        fragments: 2,
    };
    assert_eq!(rifted(&mut app, planet, rift), before.rows().len() + 1);
}

/// Carries out a rift and returns the number of plates at once; later steps may consume some.
fn rifted(app: &mut App, planet: Entity, rift: TectonicCommand) -> usize {
    listen::<PlateRifted>(app);
    let counted = std::sync::Arc::new(std::sync::Mutex::new(0));
    let store = std::sync::Arc::clone(&counted);
    app.add_observer(move |event: On<PlateRifted>, of: Query<&Plates>| {
        *store.lock().unwrap() = of
            .get(event.planet)
            .map_or(0, |plates| plates.iter().count());
    });
    accept(app, planet, rift);
    assert_eq!(heard::<PlateRifted>(app).len(), 1);
    *counted.lock().unwrap()
}

#[test]
fn the_crust_of_a_plate_is_switched() {
    let (mut app, planet) = planet();
    for (kind, share) in [(CrustKind::Continental, 1.0), (CrustKind::Oceanic, 0.0)] {
        let (mut app, planet) = self::planet();
        let of = |app: &App| {
            plates(app, planet)
                .get(PlateId(2))
                .unwrap()
                .stats
                .continental
        };
        assert!(obey(
            &mut app,
            planet,
            TectonicCommand::SetPlateCrust {
                plate: PlateId(2),
                kind
            }
        ));
        assert_eq!(of(&app), share);
        check_ledger(&app, planet);
        assert_ne!(get::<Ledger>(&app, planet).of(Cause::Command).area, 0.0);
    }
    accept(
        &mut app,
        planet,
        TectonicCommand::SetPlateCrust {
            plate: PlateId(2),
            kind: CrustKind::Continental,
        },
    );
}

#[test]
fn a_disc_is_painted_raised_and_levelled() {
    let center = (10.0, 20.0);
    let target = PaintTarget::Disc {
        center,
        radius: 1200.0,
    };
    let (mut app, planet) = planet();
    accept(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target,
            brush: Brush::Kind(CrustKind::Continental),
        },
    );
    let (mut app, planet) = self::planet();
    let old = state(&app, planet);
    assert!(obey(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target,
            brush: Brush::Raise(2.0)
        }
    ));
    let new = state(&app, planet);
    let (mut full, mut outside) = (0, 0);
    for i in 0..old.crust.len() {
        let frame = old.frames[usize::from(old.crust.frame[i])];
        let p = frame.to_world(old.lattice.0.points()[i]);
        let km = angle_between(p, direction(center.0, center.1)) * 6370.0;
        let dz = new.crust.elevation[i] - old.crust.elevation[i];
        if km > 1200.0 {
            assert_eq!((dz, old.crust.thickness[i]), (0.0, new.crust.thickness[i]));
            outside += 1;
        } else if km < 600.0 {
            assert!((dz - 2.0).abs() < 1e-3, "{dz} at {km} km");
            assert!(
                new.crust.thickness[i] > old.crust.thickness[i],
                "thickness follows"
            );
            full += 1;
        } else {
            assert!((0.0..=2.0).contains(&dz));
        }
    }
    assert!(full > 5 && outside > 1000);
    assert!(obey(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target,
            brush: Brush::Elevation(3.0)
        }
    ));
    let level = state(&app, planet);
    let i = level.lattice.0.nearest(direction(center.0, center.1)) as usize;
    let near = (0..level.crust.len())
        .filter(|&i| level.crust.elevation[i] == 3.0)
        .count();
    assert!(
        near > 10,
        "{near} samples at 3 km, {} at the centre",
        level.crust.elevation[i]
    );
    check_ledger(&app, planet);
}

#[test]
fn the_whole_planet_is_painted() {
    let (mut app, planet) = planet();
    let raise = TectonicCommand::PaintCrust {
        target: PaintTarget::Everywhere,
        brush: Brush::Raise(0.5),
    };
    let old = get::<Crust>(&app, planet).elevation.clone();
    assert!(obey(&mut app, planet, raise));
    let new = &get::<Crust>(&app, planet).elevation;
    assert!(old.iter().zip(new).all(|(a, b)| (b - a - 0.5).abs() < 1e-4));
    let ocean = Brush::Kind(CrustKind::Oceanic);
    accept(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target: PaintTarget::Everywhere,
            brush: ocean,
        },
    );
}

#[test]
fn a_drowned_planet_lives_on() {
    let (mut app, planet) = planet();
    let ocean = Brush::Kind(CrustKind::Oceanic);
    assert!(obey(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target: PaintTarget::Everywhere,
            brush: ocean
        }
    ));
    assert_eq!(
        continents(get(&app, planet), get::<Lattice>(&app, planet), 6370.0),
        (0.0, 0.0)
    );
    steps(&mut app, planet, 25);
    assert!(
        get::<Crust>(&app, planet)
            .elevation
            .iter()
            .all(|z| z.is_finite())
    );
    let land = Brush::Kind(CrustKind::Continental);
    assert!(obey(
        &mut app,
        planet,
        TectonicCommand::PaintCrust {
            target: PaintTarget::Everywhere,
            brush: land
        }
    ));
    steps(&mut app, planet, 25);
    assert!(
        get::<Crust>(&app, planet)
            .elevation
            .iter()
            .all(|z| z.is_finite())
    );
}

#[test]
fn parameters_processes_and_resamples() {
    let (mut app, planet) = planet();
    accept(
        &mut app,
        planet,
        TectonicCommand::SetParam {
            name: "erosion".into(),
            value: 0.5,
        },
    );
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, 0.5);
    let (mut app, planet) = self::planet();
    accept(
        &mut app,
        planet,
        TectonicCommand::SetProcess {
            name: "drift".into(),
            on: false,
        },
    );
    assert!(!get::<TectonicParams>(&app, planet).processes.drift);
    let (mut app, planet) = self::planet();
    listen::<CrustResampled>(&mut app);
    accept(&mut app, planet, TectonicCommand::Resample);
    assert_eq!(heard::<CrustResampled>(&app).len(), 1);
}

#[test]
fn commands_wait_for_the_end_of_a_step() {
    let (mut app, planet) = planet();
    let before = get::<TectonicParams>(&app, planet).erosion;
    command(
        &mut app,
        planet,
        TectonicCommand::SetParam {
            name: "erosion".into(),
            value: 0.7,
        },
    );
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, before);
    steps(&mut app, planet, 1);
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, 0.7);
    app.world_mut()
        .commands()
        .entity(planet)
        .tectonic(TectonicCommand::Resample);
    app.world_mut().flush();
    steps(&mut app, planet, 1);
    assert_eq!(get::<Recording>(&app, planet).0.len(), 2);
}

/// Commands that no planet may accept.
fn nonsense() -> Vec<TectonicCommand> {
    let mut out = Vec::new();
    let plate = PlateId(1);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
        out.push(TectonicCommand::SetPlateMotion {
            plate,
            pole: (bad, 0.0),
            speed: 10.0,
        });
        out.push(TectonicCommand::SetPlateMotion {
            plate,
            pole: (0.0, bad),
            speed: 10.0,
        });
        out.push(TectonicCommand::SetPlateMotion {
            plate,
            pole: (0.0, 0.0),
            speed: bad,
        });
        out.push(TectonicCommand::RiftPlate {
            plate,
            line: vec![(0.0, 0.0), (bad, 1.0)],
            fragments: 2,
        });
        out.push(TectonicCommand::RiftPlate {
            plate,
            line: vec![(0.0, bad), (1.0, 1.0)],
            fragments: 2,
        });
        for brush in [Brush::Raise(bad), Brush::Elevation(bad)] {
            out.push(TectonicCommand::PaintCrust {
                target: PaintTarget::Everywhere,
                brush,
            });
        }
        for target in [
            PaintTarget::Disc {
                center: (bad, 0.0),
                radius: 100.0,
            },
            PaintTarget::Disc {
                center: (0.0, bad),
                radius: 100.0,
            },
            PaintTarget::Disc {
                center: (0.0, 0.0),
                radius: bad,
            },
        ] {
            out.push(TectonicCommand::PaintCrust {
                target,
                brush: Brush::Raise(1.0),
            });
        }
        for info in TectonicParams::TABLE {
            out.push(TectonicCommand::SetParam {
                name: info.name.into(),
                value: bad,
            });
        }
    }
    for gone in [PlateId(40), PlateId(u32::MAX)] {
        out.push(TectonicCommand::SetPlateMotion {
            plate: gone,
            pole: (0.0, 0.0),
            speed: 10.0,
        });
        out.push(TectonicCommand::RiftPlate {
            plate: gone,
            line: Vec::new(),
            fragments: 2,
        });
        out.push(TectonicCommand::RiftPlate {
            plate: gone,
            line: vec![(0.0, 0.0), (1.0, 1.0)],
            fragments: 2,
        });
        out.push(TectonicCommand::SetPlateCrust {
            plate: gone,
            kind: CrustKind::Continental,
        });
    }
    for fragments in [0, 1, 5, u32::MAX] {
        for line in [Vec::new(), vec![(-60.0, 0.0), (60.0, 0.0)]] {
            out.push(TectonicCommand::RiftPlate {
                plate,
                line,
                fragments,
            });
        }
    }
    out.push(TectonicCommand::RiftPlate {
        plate,
        line: vec![(0.0, 0.0)],
        fragments: 2,
    });
    out.push(TectonicCommand::RiftPlate {
        plate,
        line: vec![(10.0, 10.0); 2],
        fragments: 2,
    });
    out.push(TectonicCommand::RiftPlate {
        plate,
        line: vec![(10.0, 10.0); 2000],
        fragments: 2,
    });
    out.push(TectonicCommand::SetPlateMotion {
        plate,
        pole: (0.0, 0.0),
        speed: 100.1,
    });
    out.push(TectonicCommand::SetParam {
        name: "magic".into(),
        value: 1.0,
    });
    out.push(TectonicCommand::SetParam {
        name: String::new(),
        value: 1.0,
    });
    out.push(TectonicCommand::SetParam {
        name: "abyss_elevation".into(),
        value: -0.5,
    });
    out.push(TectonicCommand::SetProcess {
        name: "magic".into(),
        on: true,
    });
    out
}

#[test]
fn nonsense_is_refused_and_changes_nothing() {
    let (mut app, planet) = planet();
    let before = digest(&app, planet);
    for wanted in nonsense() {
        let refused = heard::<CommandRejected>(&app).len();
        assert!(
            !obey(&mut app, planet, wanted.clone()),
            "{wanted:?} was accepted"
        );
        let events = heard::<CommandRejected>(&app);
        assert_eq!(events.len(), refused + 1);
        let reason = events.last().unwrap().error.to_string();
        assert!(
            !reason.is_empty() && !reason.contains('\n'),
            "one line: {reason}"
        );
        assert_eq!(
            digest(&app, planet),
            before,
            "{wanted:?} was refused, but changed the planet"
        );
    }
    assert!(
        get::<Recording>(&app, planet).0.is_empty(),
        "what is refused is not recorded"
    );
}

#[test]
fn a_line_that_misses_the_plate_is_refused() {
    let (mut app, planet) = planet();
    let before = digest(&app, planet);
    // A plate is no great circle: a line along its far side leaves all of it on one side.
    let row = *plates(&app, planet)
        .rows()
        .iter()
        .min_by(|a, b| a.stats.area.total_cmp(&b.stats.area))
        .unwrap();
    let east = bevy_pangaea::math::any_tangent(row.stats.centroid);
    let away = row.stats.centroid.cross(east);
    let ends =
        [east, (east + away).normalize()].map(|e| (e - row.stats.centroid * 2.0).normalize());
    let line = ends.map(bevy_pangaea::math::lat_lon).to_vec();
    let crosses = angle_between(ends[0].cross(ends[1]).normalize(), row.stats.centroid);
    if (crosses - core::f64::consts::FRAC_PI_2).abs() > 0.5 {
        assert!(!obey(
            &mut app,
            planet,
            TectonicCommand::RiftPlate {
                plate: row.id,
                line,
                fragments: 2
            }
        ));
        assert_eq!(digest(&app, planet), before);
    }
}

#[test]
fn a_plate_that_is_not_there_is_refused_by_name() {
    let (mut app, planet) = planet();
    assert!(!obey(
        &mut app,
        planet,
        TectonicCommand::SetPlateCrust {
            plate: PlateId(77),
            kind: CrustKind::Oceanic
        }
    ));
    let error = heard::<CommandRejected>(&app).pop().unwrap().error;
    assert_eq!(error, CommandError::NoPlate(PlateId(77)));
    assert_eq!(error.to_string(), "there is no plate 77");
}

#[test]
fn plates_never_exceed_a_highest_speed_that_was_lowered() {
    let (mut app, planet) = planet();
    accept(
        &mut app,
        planet,
        TectonicCommand::SetParam {
            name: "max_speed".into(),
            value: 5.0,
        },
    );
    let radius = get::<Planet>(&app, planet).radius;
    assert!(
        plates(&app, planet)
            .rows()
            .iter()
            .all(|row| row.motion.speed * radius < 5.0 + 1e-9)
    );
}

#[test]
fn oceans_may_change_their_law() {
    let (mut app, planet) = planet();
    accept(
        &mut app,
        planet,
        TectonicCommand::SetOceanFloor {
            law: OceanFloor::Paper,
        },
    );
    assert_eq!(
        get::<TectonicParams>(&app, planet).ocean_floor,
        OceanFloor::Paper
    );
}
