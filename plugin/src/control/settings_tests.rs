use super::*;

fn with_spacing(spacing: f64) -> BakeSettings {
    BakeSettings {
        spacing,
        ..BakeSettings::default()
    }
}

#[test]
fn settings_of_nan_equal_themselves_and_are_refused() {
    let odd = with_spacing(f64::NAN);
    assert!(odd.asks_for_the_same(&odd) && !odd.asks_for_the_same(&BakeSettings::default()));
    for spacing in [f64::NAN, f64::INFINITY, 0.0, -0.01] {
        let refused = with_spacing(spacing).check();
        assert!(matches!(refused, Err(BakeError::Spacing(_))), "{spacing}");
    }
    let mut rivers = BakeSettings::default();
    rivers.rules.rivers.discharge = f64::NAN;
    assert!(rivers.check().is_ok() && rivers.asks_for_the_same(&rivers.clone()));
    assert!(!rivers.asks_for_the_same(&BakeSettings::default()));
}

#[test]
fn settings_come_back_from_files() {
    let mut settings = with_spacing(0.02);
    settings.rules.rivers.order = 3;
    let text = ron::to_string(&settings).unwrap();
    assert_eq!(ron::from_str(&text), Ok(settings));
    assert_eq!(ron::from_str("(rules: ())"), Ok(BakeSettings::default()));
    assert!(ron::from_str::<BakeSettings>("(spacings: 0.02)").is_err());
}
