use super::*;
use crate::crust::Cover;
use crate::params::TectonicParams;
use crate::plate::PlateId;

#[test]
fn hypsometry_has_open_ends_and_sum_one() {
    let samples = [
        (-50.0, 1.0),
        (-11.0, 1.0),
        (-0.01, 1.0),
        (0.0, 3.0),
        (10.99, 1.0),
        (99.0, 1.0),
    ];
    let bins = hypsometry(samples.into_iter());
    assert_eq!(bins.len(), HYPSOMETRY_BINS);
    assert_eq!(
        [bins[0], bins[43], bins[44], bins[87]],
        [0.25, 0.125, 0.375, 0.25]
    );
    assert!((bins.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    let empty = hypsometry(core::iter::empty());
    assert_eq!(empty, vec![0.0; HYPSOMETRY_BINS]);
}

/// A folded continent of 1 km in the north, ocean floor of 50 My in the south.
fn two_hemispheres(mesh: &SphereMesh) -> Surface {
    let n = mesh.len();
    let mut crust = Crust::ocean(n, &TectonicParams::default());
    for (i, p) in mesh.points().iter().enumerate() {
        crust.ocean_age[i] = 50.0;
        if p.z > 0.0 {
            crust.kind[i] = CrustKind::Continental;
            crust.elevation[i] = 1.0;
            crust.orogeny[i] = Orogeny::Himalayan;
        }
    }
    Surface {
        plate: vec![PlateId(0); n],
        cover: vec![Cover::One; n],
        trench: vec![0.0; n],
        crust,
        ..Surface::default()
    }
}

/// The figures of [`two_hemispheres`].
fn figures() -> Stats {
    let mesh = SphereMesh::fibonacci(2000).unwrap();
    let input = StatsInput {
        mesh: &mesh,
        surface: &two_hemispheres(&mesh),
        clock: &GeologicClock::default(),
        ledger: &Ledger::default(),
        radius: 6370.0,
        plates: 1,
    };
    Stats::new(&input, "00".into(), Timings::default())
}

#[test]
fn half_of_two_hemispheres_is_land_and_folded() {
    let stats = figures();
    for half in [
        stats.land_fraction,
        stats.continental_fraction,
        stats.orogeny_fraction.himalayan,
        stats.hypsometry[20],
        stats.hypsometry[48],
    ] {
        assert!((half - 0.5).abs() < 1e-3, "{half}");
    }
    assert_eq!(stats.orogeny_fraction.andean, 0.0);
}

#[test]
fn heights_and_ages_of_two_hemispheres() {
    let stats = figures();
    let z = stats.elevation_km;
    assert_eq!((z.min, z.max), (-6.0, 1.0));
    assert!((z.mean + 2.5).abs() < 1e-2);
    assert!((stats.ocean_age_my.mean - 50.0).abs() < 1e-9);
}
