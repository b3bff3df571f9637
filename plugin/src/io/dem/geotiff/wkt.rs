//! Coordinate systems as text: WKT as GDAL writes it into its side files (OGC 01-009; of OGC 18-010
//! what has the same form).

use super::projection::Projection;
use super::system::{EARTH, System, known};
use crate::io::dem::error::{DemError, invalid};
use crate::math::PI;
use core::fmt::Write;

/// A coordinate system, and the length in m of the unit of its heights, if it tells.
pub(super) struct SystemOfText {
    pub(super) system: System,
    pub(super) metres_per_unit: Option<f64>,
}

/// Words of the same meaning in both versions of WKT.
const PROJECTED: [&str; 3] = ["PROJCS", "PROJCRS", "PROJECTEDCRS"];
const GEOGRAPHIC: [&str; 5] = [
    "GEOGCS",
    "GEOGCRS",
    "GEOGRAPHICCRS",
    "GEODCRS",
    "BASEGEOGCRS",
];
const COMPOUND: [&str; 2] = ["COMPD_CS", "COMPOUNDCRS"];
const VERTICAL: [&str; 3] = ["VERT_CS", "VERTCRS", "VERTICALCRS"];
const ELLIPSOID: [&str; 2] = ["SPHEROID", "ELLIPSOID"];
const MERIDIAN: [&str; 2] = ["PRIMEM", "PRIMEMERIDIAN"];
const UNIT: [&str; 3] = ["UNIT", "LENGTHUNIT", "ANGLEUNIT"];
const IDENTIFIER: [&str; 2] = ["AUTHORITY", "ID"];

/// PROJ's names of the methods of WKT 1.
const METHODS: [(&str, &str); 15] = [
    ("transverse_mercator", "tmerc"),
    ("mercator_1sp", "merc"),
    ("mercator_2sp", "merc"),
    ("mercator", "merc"),
    ("lambert_conformal_conic_1sp", "lcc"),
    ("lambert_conformal_conic_2sp", "lcc"),
    ("lambert_conformal_conic", "lcc"),
    ("lambert_azimuthal_equal_area", "laea"),
    ("albers_conic_equal_area", "aea"),
    ("albers", "aea"),
    ("azimuthal_equidistant", "aeqd"),
    ("polar_stereographic", "stere"),
    ("equirectangular", "eqc"),
    ("plate_carree", "eqc"),
    ("sinusoidal", "sinu"),
];

/// The system that a text describes.
pub(super) fn system(text: &str) -> Result<SystemOfText, DemError> {
    let root = WktNode::parse(text).ok_or_else(|| invalid("the text of its SRS makes no sense"))?;
    let horizontal = if COMPOUND.contains(&root.name.as_str()) {
        root.nodes.first().unwrap_or(&root)
    } else {
        &root
    };
    let vertical = root.child(&VERTICAL);
    Ok(SystemOfText {
        system: horizontal.system()?,
        metres_per_unit: vertical.map(|node| node.height_unit()).transpose()?,
    })
}

/// A word with what stands in its brackets.
#[derive(Debug, Default, PartialEq)]
struct WktNode {
    name: String,
    texts: Vec<String>,
    numbers: Vec<f64>,
    nodes: Vec<WktNode>,
}

/// Deepest brackets.
const MOST_LEVELS: usize = 16;

impl WktNode {
    /// The node that is the whole text.
    fn parse(text: &str) -> Option<Self> {
        let mut rest = text.trim();
        let node = Self::read(&mut rest, 0)?;
        rest.trim().is_empty().then_some(node)
    }

    /// The node that a text begins with, which is taken off it.
    fn read(rest: &mut &str, level: usize) -> Option<Self> {
        let open = rest.find(['[', '('])?;
        let mut node = Self {
            name: rest[..open].trim().to_ascii_uppercase(),
            ..Self::default()
        };
        *rest = &rest[open + 1..];
        loop {
            *rest = rest.trim_start();
            node.take_argument(rest, level)?;
            *rest = rest.trim_start();
            let end = rest.chars().next()?;
            *rest = &rest[end.len_utf8()..];
            match end {
                ']' | ')' => return Some(node),
                ',' => {}
                _ => return None,
            }
        }
    }

    /// Takes a text, a number, a word or a node off the rest.
    fn take_argument(&mut self, rest: &mut &str, level: usize) -> Option<()> {
        if let Some(quoted) = rest.strip_prefix('"') {
            let end = quoted.find('"')?;
            self.texts.push(quoted[..end].to_string());
            *rest = &quoted[end + 1..];
            return Some(());
        }
        let end = rest.find([',', '[', '(', ']', ')'])?;
        if rest[end..].starts_with(['[', '(']) {
            let level = (level < MOST_LEVELS).then_some(level + 1)?;
            self.nodes.push(Self::read(rest, level)?);
            return Some(());
        }
        // Words, such as those of directions, are passed over.
        self.numbers.extend(rest[..end].trim().parse::<f64>());
        *rest = &rest[end..];
        Some(())
    }

    fn child(&self, names: &[&str]) -> Option<&Self> {
        let is_named = |node: &&Self| names.contains(&node.name.as_str());
        self.nodes.iter().find(is_named)
    }

    /// A node however deep.
    fn find(&self, names: &[&str]) -> Option<&Self> {
        let below = || self.nodes.iter().find_map(|node| node.find(names));
        self.child(names).or_else(below)
    }

    fn title(&self) -> &str {
        self.texts.first().map_or("", String::as_str)
    }

    /// The size of its own unit.
    fn unit(&self) -> Option<f64> {
        let unit = *self.child(&UNIT)?.numbers.first()?;
        (unit.is_finite() && unit > 0.0).then_some(unit)
    }

    /// Its code of EPSG's.
    fn code(&self) -> Option<u16> {
        let id = self.child(&IDENTIFIER)?;
        let number = id.numbers.first().map(|number| *number as u16);
        let code = id.texts.get(1).and_then(|code| code.parse().ok());
        (id.title() == "EPSG").then_some(code.or(number)?)
    }

    fn system(&self) -> Result<System, DemError> {
        if GEOGRAPHIC.contains(&self.name.as_str()) {
            return Ok(self.geographic());
        }
        if !PROJECTED.contains(&self.name.as_str()) {
            let (kind, title) = (&self.name, self.title());
            return Err(invalid(format!("the SRS {kind} {title:?} is not read")));
        }
        let own = self.projection();
        let of_code = self.code().and_then(|code| known(code, false).ok());
        let projection = own.map(Box::new).or(of_code.flatten());
        let unread = || {
            invalid(format!(
                "the projection of the SRS {:?} is not read",
                self.title()
            ))
        };
        let projection = Some(projection.ok_or_else(unread)?);
        let unit_m = self.unit().unwrap_or(1.0);
        Ok(System::Lengths { unit_m, projection })
    }

    fn geographic(&self) -> System {
        let unit_deg = self.unit().map_or(1.0, |radians| radians * 180.0 / PI);
        let meridian = self.child(&MERIDIAN).and_then(|node| node.numbers.first());
        System::Degrees {
            unit_deg,
            meridian_deg: meridian.map_or(0.0, |longitude| longitude * unit_deg),
            radii: self.radii(),
        }
    }

    /// Half axes of its ellipsoid in m.
    fn radii(&self) -> [f64; 2] {
        let Some([a, f, ..]) = self.find(&ELLIPSOID).map(|node| node.numbers.as_slice()) else {
            return EARTH;
        };
        // An inverse flattening of 0 stands for a sphere.
        let b = if *f > 1.0 { a * (1.0 - 1.0 / f) } else { *a };
        if (1e3..=1e9).contains(a) {
            [*a, b]
        } else {
            EARTH
        }
    }

    /// The projection that its method and parameters make, where they are known.
    fn projection(&self) -> Option<Projection> {
        let method = self.child(&["PROJECTION"])?.title().to_ascii_lowercase();
        let (_, name) = METHODS.iter().find(|(known, _)| *known == method)?;
        let [a, b] = self.radii();
        let mut text = format!("+proj={name} +a={a} +b={b} +no_defs");
        for node in self.nodes.iter().filter(|node| node.name == "PARAMETER") {
            let (parameter, &value) = (node.title().to_ascii_lowercase(), node.numbers.first()?);
            self.put(&mut text, name, &parameter, value)?;
        }
        Projection::of(&text)
    }

    /// Appends a parameter by PROJ's name of it; angles are in degrees, as nearly all are.
    fn put(&self, text: &mut String, method: &str, parameter: &str, value: f64) -> Option<()> {
        let is_polar = method == "stere";
        let name = match parameter {
            "central_meridian" | "longitude_of_center" | "longitude_of_origin" => "lon_0",
            "latitude_of_origin" if is_polar => "lat_ts",
            "standard_parallel_1" if matches!(method, "merc" | "eqc") => "lat_ts",
            "latitude_of_origin" | "latitude_of_center" => "lat_0",
            "standard_parallel_1" => "lat_1",
            "standard_parallel_2" => "lat_2",
            "scale_factor" => "k",
            "false_easting" => "x_0",
            "false_northing" => "y_0",
            _ => return None,
        };
        let is_length = name.ends_with("_0") && name.starts_with(['x', 'y']);
        let unit = if is_length {
            self.unit().unwrap_or(1.0)
        } else {
            1.0
        };
        let _ = write!(text, " +{name}={}", value * unit);
        if name == "lat_ts" && is_polar {
            let _ = write!(text, " +lat_0={}", 90_f64.copysign(value));
        }
        Some(())
    }

    /// Length in m of the unit of a vertical system.
    fn height_unit(&self) -> Result<f64, DemError> {
        let axis = self.child(&["AXIS"]);
        if axis.is_some_and(|axis| axis.title().to_ascii_lowercase().contains("depth")) {
            return Err(invalid("an SRS of depths is not read"));
        }
        let own = self.unit().or_else(|| axis?.unit());
        own.ok_or_else(|| invalid("the SRS has heights without a unit"))
    }
}
