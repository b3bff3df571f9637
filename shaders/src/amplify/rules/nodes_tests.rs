//! Nodes against their closed forms.

use super::*;
use crate::amplify::fixed::GRAINS;

const UNIT: f64 = 65_536.0;

fn shares() -> impl Iterator<Item = (i32, f64)> {
    (0..=Q16).step_by(41).map(|x| (x, f64::from(x) / UNIT))
}

fn close(got: i32, want: f64, tolerance: f64) {
    assert!((f64::from(got) - want).abs() <= tolerance, "{got} {want}");
}

#[test]
fn alphas_are_the_closed_forms() {
    for level in 0..17 {
        let delta = scale_dependency(level);
        let d = 1.0 - 0.4 * f64::from(level.min(10)) / 10.0;
        close(delta, d * UNIT, 0.51);
        for (xi, x) in shares() {
            close(
                young(Form::Paper, delta, xi),
                (0.5 + d / 2.0 * (x * x.sqrt() - 1.0)) * UNIT,
                3.0,
            );
            close(
                young(Form::Release, delta, xi),
                (0.5 - 0.5 * d + d * x * x.sqrt()) * UNIT,
                4.0,
            );
            close(old_dry(delta, xi), (0.5 + 0.4 * d * (x - 1.0)) * UNIT, 2.0);
            close(old_wet(delta, xi), (1.0 + 0.6 * d * (x - 1.0)) * UNIT, 2.0);
        }
    }
}

#[test]
fn alphas_stay_between_the_parents() {
    for level in 0..17 {
        let delta = scale_dependency(level);
        for (xi, _) in shares() {
            for alpha in [
                young(Form::Paper, delta, xi),
                young(Form::Release, delta, xi),
                old_dry(delta, xi),
                old_wet(delta, xi),
            ] {
                assert!((-1..=Q16 + 1).contains(&alpha), "{alpha}");
                let height = between(3_000_000, -500_000, alpha.clamp(0, Q16));
                assert!((-500_000..=3_000_000).contains(&height));
            }
        }
    }
}

#[test]
fn peaks_are_the_closed_forms() {
    let crust = 6_000 * GRAINS;
    // A share of 2⁻¹⁶ is 94 grains of 6 km.
    for (xi, x) in shares() {
        close(peak_young(xi, crust), x * x * f64::from(crust), 95.0);
        close(peak_old_dry(xi, crust), x * f64::from(crust), 1.0);
        close(
            peak_old_wet(xi, crust),
            (1.0 - x * x) * f64::from(crust),
            95.0,
        );
    }
}

#[test]
fn terraces_rise_in_steps() {
    let step = TERRACE_STEP;
    let mut last = i32::MIN;
    for height in (-3 * step..=3 * step).step_by(101) {
        let got = terrace(height, step);
        let beta = f64::from(height.rem_euclid(step)) / f64::from(step);
        let tread = f64::from(height.div_euclid(step)) * f64::from(step);
        close(
            got,
            tread + beta * beta * (3.0 - 2.0 * beta) * f64::from(step),
            60.0,
        );
        assert!(got + 40 >= last, "monotone but for rounding");
        last = got;
    }
    assert_eq!(terrace(2 * step, step), 2 * step);
    assert_eq!(terrace(-step, step), -step);
}

#[test]
fn hills_are_capped_and_scale_with_presence() {
    for (xi, x) in shares() {
        for length in [400 * GRAINS, 26_000 * GRAINS] {
            let up = hill(Form::Paper, xi, Q16, length, Q16);
            close(
                up,
                (f64::from(length) * (1.0 - x * x) / 2.0).min(f64::from(HILL_LIMIT)),
                410.0,
            );
            let down = hill(Form::Paper, xi, 0, length, Q16 / 2);
            close(down, -f64::from(length) * (1.0 - x * x) / 12.0, 410.0);
            assert_eq!(hill(Form::Release, xi, 0, length, 0), 0);
        }
    }
}

#[test]
fn plateaus_flatten() {
    assert_eq!(plateau(5_000, 1_000, 0), 5_000);
    close(
        plateau(500_000, 100_000, Q16),
        500_000.0 - 0.88 * 400_000.0,
        7.0,
    );
}

#[test]
fn bits_are_pinned() {
    assert_eq!(scale_dependency(3), 57_672);
    assert_eq!(young(Form::Release, 57_672, 40_000), 31_432);
    assert_eq!(old_wet(57_672, 12_345), 37_451);
    assert_eq!(terrace(1_000_000, TERRACE_STEP), 964_031);
}
