//! Values of options: numbers with limits, coordinates, sizes and names. Every message names the
//! limits.

use bevy_pangaea::overlay::Overlay;

/// Where a camera stands and looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSpec {
    /// Degrees north.
    pub lat: f64,
    /// Degrees east.
    pub lon: f64,
    /// Height above the sea in m.
    pub altitude_m: f64,
    /// Degrees clockwise from north.
    pub heading: f64,
    /// Degrees above the horizon; -90 looks straight down.
    pub pitch: f64,
}

/// A point of the planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceSpec {
    /// Degrees north.
    pub lat: f64,
    /// Degrees east.
    pub lon: f64,
}

/// A square of the planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionSpec {
    /// Its middle.
    pub middle: PlaceSpec,
    /// Its side in km.
    pub size_km: f64,
}

/// A list of numbers of samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts(pub Vec<u32>);

/// A whole number from `low` to `high`.
pub fn integer(text: &str, low: u64, high: u64) -> Result<u64, String> {
    match text.trim().parse::<u64>() {
        Ok(value) if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("it must be a whole number from {low} to {high}")),
    }
}

/// A number from `low` to `high`.
pub fn number(text: &str, low: f64, high: f64) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("it must be a number from {low} to {high}")),
    }
}

/// `LAT,LON,ALTITUDE_M[,HEADING,PITCH]`.
pub fn camera(text: &str) -> Result<CameraSpec, String> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != 3 && parts.len() != 5 {
        return Err("it must be LAT,LON,ALTITUDE_M or LAT,LON,ALTITUDE_M,HEADING,PITCH".into());
    }
    let part = |k: usize, name: &str, low, high| {
        number(parts[k], low, high).map_err(|problem| problem.replacen("it", name, 1))
    };
    let (heading, pitch) = if parts.len() == 5 {
        (
            part(3, "the heading", -360.0, 360.0)?,
            part(4, "the pitch", -90.0, 90.0)?,
        )
    } else {
        (0.0, -90.0)
    };
    Ok(CameraSpec {
        lat: part(0, "the latitude", -90.0, 90.0)?,
        lon: part(1, "the longitude", -360.0, 360.0)?,
        altitude_m: part(2, "the altitude in m", 1.0, 1e9)?,
        heading,
        pitch,
    })
}

/// `LAT,LON`.
pub fn place(text: &str) -> Result<PlaceSpec, String> {
    match text.split(',').collect::<Vec<_>>()[..] {
        [lat, lon] => coordinates(lat, lon),
        _ => Err("it must be LAT,LON".into()),
    }
}

/// `LAT,LON,SIZE_KM`.
pub fn region(text: &str) -> Result<RegionSpec, String> {
    let [lat, lon, size] = text.split(',').collect::<Vec<_>>()[..] else {
        return Err("it must be LAT,LON,SIZE_KM".into());
    };
    let size_km =
        number(size, 1e-3, 1e5).map_err(|problem| problem.replacen("it", "the size in km", 1))?;
    Ok(RegionSpec {
        middle: coordinates(lat, lon)?,
        size_km,
    })
}

fn coordinates(lat: &str, lon: &str) -> Result<PlaceSpec, String> {
    let part = |text: &str, name: &str, limit: f64| {
        number(text, -limit, limit).map_err(|problem| problem.replacen("it", name, 1))
    };
    Ok(PlaceSpec {
        lat: part(lat, "the latitude", 90.0)?,
        lon: part(lon, "the longitude", 360.0)?,
    })
}

/// `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<(u32, u32), String> {
    let problem = || "it must be WIDTHxHEIGHT, each from 16 to 8192 pixels".to_string();
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(problem)?;
    let side = |text: &str| {
        integer(text, 16, 8192)
            .map(|side| side as u32)
            .map_err(|_| problem())
    };
    Ok((side(width)?, side(height)?))
}

/// Numbers of samples, separated by commas.
pub fn counts(text: &str) -> Result<Counts, String> {
    let problem = || {
        "it must be one to twenty whole numbers from 100 to 2000000, separated by commas"
            .to_string()
    };
    let counts: Result<Vec<u32>, String> = text
        .split(',')
        .map(|part| integer(part, 100, 2_000_000).map(|count| count as u32))
        .collect();
    counts
        .ok()
        .filter(|counts| counts.len() <= 20)
        .map(Counts)
        .ok_or_else(problem)
}

/// The name of an overlay.
pub fn overlay(text: &str) -> Result<Overlay, String> {
    Overlay::from_name(text).ok_or_else(|| {
        let names = Overlay::ALL.map(Overlay::name);
        format!("it must be one of {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_limits() {
        assert_eq!(integer("60000", 100, 2_000_000), Ok(60_000));
        for bad in [
            "",
            "0",
            "-5",
            "NaN",
            "inf",
            "1e3",
            "99",
            "2000001",
            "1000000000000",
            "99999999999999999999999",
        ] {
            assert!(integer(bad, 100, 2_000_000).is_err(), "{bad}");
        }
        assert_eq!(number("0.3", 0.0, 0.9), Ok(0.3));
        for bad in [
            "", "NaN", "nan", "inf", "-inf", "infinity", "-0.1", "0.91", "1e300", "x",
        ] {
            assert!(number(bad, 0.0, 0.9).is_err(), "{bad}");
        }
    }

    #[test]
    fn cameras_and_sizes_are_read() {
        let expected = CameraSpec {
            lat: -33.0,
            lon: -70.5,
            altitude_m: 2e6,
            heading: 90.0,
            pitch: -10.0,
        };
        assert_eq!(camera("-33,-70.5,2000000,90,-10"), Ok(expected));
        assert_eq!(camera("0, 0, 1000").unwrap().pitch, -90.0);
        for bad in [
            "",
            "1,2",
            "1,2,3,4",
            "91,0,10",
            "0,NaN,10",
            "0,0,0",
            "0,0,-5",
            "0,0,inf",
            "0,0,1e10",
            "0,0,9,0,91",
        ] {
            assert!(camera(bad).is_err(), "{bad}");
        }
        let south = PlaceSpec {
            lat: -33.0,
            lon: -70.5,
        };
        assert_eq!(place(" -33, -70.5"), Ok(south));
        assert_eq!(
            region("-33,-70.5,12"),
            Ok(RegionSpec {
                middle: south,
                size_km: 12.0
            })
        );
        for bad in [
            "", "1", "1,2,3", "91,0", "0,361", "NaN,0", "0,inf", "a,b", "1;2",
        ] {
            assert!(place(bad).is_err(), "{bad}");
        }
        for bad in [
            "", "1,2", "1,2,0", "1,2,-5", "1,2,NaN", "1,2,1e9", "1,2,3,4", "-91,2,3",
        ] {
            assert!(region(bad).is_err(), "{bad}");
        }
        assert_eq!(size("1280x720"), Ok((1280, 720)));
        for bad in [
            "",
            "0x0",
            "1280",
            "1280x",
            "-1x5",
            "100000x100000",
            "16x15",
            "NaNx5",
        ] {
            assert!(size(bad).is_err(), "{bad}");
        }
        assert_eq!(counts("100,2000"), Ok(Counts(vec![100, 2000])));
        assert!(counts("100,,200").is_err() && counts("").is_err() && counts("99").is_err());
        assert!(overlay("nonsense").unwrap_err().contains("ocean_age"));
    }
}
