//! Parameters by name, their limits, and which of them files hold.

use super::*;

#[test]
fn later_parameters_are_written_where_they_differ() {
    let mut params = TectonicParams::default();
    let names = |params: &TectonicParams| params.written().map(|at| at.0).collect::<Vec<_>>();
    let usual = names(&params);
    assert!(usual.contains(&"erosion") && !usual.contains(&"noise_period"));
    params.noise_period = 200.0;
    assert_eq!(params.written().count(), usual.len() + 1);
    assert!(params.written().any(|at| at == ("noise_period", 200.0)));
    for name in LATER {
        assert!(TectonicParams::info(name).is_some(), "{name}");
    }
}

#[test]
fn defaults_are_valid_and_found_by_name() {
    let mut params = TectonicParams::default();
    params.validate().unwrap();
    for info in TectonicParams::TABLE {
        assert_eq!((info.get)(&params), info.default, "{}", info.name);
        params.set(info.name, info.max).unwrap();
        assert_eq!((info.get)(&params), info.max);
        assert!(
            params
                .set(info.name, info.max + info.max.abs() + 1.0)
                .is_err()
        );
        assert!(params.set(info.name, f64::NAN).is_err());
        assert_eq!(
            (info.get)(&params),
            info.max,
            "a refused value changes nothing"
        );
        assert!(info.doc.len() > 20);
    }
    assert_eq!(
        params.set("upift", 1.0),
        Err(ParamError::Unknown("upift".into()))
    );
}
