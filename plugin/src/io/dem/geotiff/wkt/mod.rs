//! Coordinate systems as text: WKT 1 (OGC 01-009) as GDAL writes it into its side files and Esri
//! into .prj files, and WKT 2 (OGC 18-010).
//!
//! ```text
//! node     words with brackets
//! method   methods of projections and their parameters
//! ```

mod node;

mod method;

use super::projection::Projection;
use super::system::{EARTH, System, known};
use crate::io::dem::error::{DemError, invalid};
use crate::math::PI;
use node::WktNode;

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
const VERTICAL: [&str; 4] = ["VERT_CS", "VERTCS", "VERTCRS", "VERTICALCRS"];
const ELLIPSOID: [&str; 2] = ["SPHEROID", "ELLIPSOID"];
const MERIDIAN: [&str; 2] = ["PRIMEM", "PRIMEMERIDIAN"];
const IDENTIFIER: [&str; 2] = ["AUTHORITY", "ID"];

/// The system that a text describes.
pub(super) fn system(text: &str) -> Result<SystemOfText, DemError> {
    let roots = WktNode::parse(text);
    let roots = roots.ok_or_else(no_sense)?;
    // Esri puts the two systems of a compound one after the other.
    let (root, others) = roots.split_first().ok_or_else(no_sense)?;
    let (horizontal, others) = match root.nodes.split_first() {
        Some(parts) if COMPOUND.contains(&root.name.as_str()) => parts,
        _ => (root, others),
    };
    let mut others = others.iter();
    let vertical = others.find(|node| VERTICAL.contains(&node.name.as_str()));
    let metres_per_unit = match vertical {
        Some(node) => Some(node.height_unit()?),
        None => horizontal.third_unit()?,
    };
    Ok(SystemOfText {
        system: horizontal.system()?,
        metres_per_unit,
    })
}

impl WktNode {
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
            // A damaged name may hold a line break, and errors are of one line.
            let (kind, title) = (self.name.escape_debug(), self.title());
            return Err(invalid(format!("the SRS {kind} {title:?} is not read")));
        }
        // A code knows best: Web Mercator's method has the name of another.
        let of_code = self.code().and_then(|code| known(code, false).ok());
        let own = || self.projection().map(Box::new);
        let projection = of_code.flatten().or_else(own);
        let projection = Some(projection.ok_or_else(|| self.unread())?);
        let unit_m = self.unit().unwrap_or(1.0);
        Ok(System::Lengths { unit_m, projection })
    }

    fn unread(&self) -> DemError {
        let title = self.title();
        invalid(format!("the projection of the SRS {title:?} is not read"))
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
        let unit_m = self.unit().unwrap_or(1.0);
        Projection::of(&method::text(self, self.radii(), unit_m)?)
    }

    /// Length in m of the unit of a vertical system.
    fn height_unit(&self) -> Result<f64, DemError> {
        let axis = self.child(&["AXIS"]);
        let is_esris = |node: &&Self| node.name == "PARAMETER" && node.title() == "Direction";
        let direction = self.nodes.iter().find(is_esris);
        let is_down = direction.is_some_and(|node| node.numbers.first() < Some(&0.0));
        if is_down || axis.is_some_and(Self::is_of_depths) {
            return Err(depths());
        }
        let own = self.unit().or_else(|| axis?.unit());
        own.ok_or_else(|| invalid("the SRS has heights without a unit"))
    }

    /// Length in m of the unit of heights of a system of three axes, if it tells.
    fn third_unit(&self) -> Result<Option<f64>, DemError> {
        let mut axes = self.nodes.iter().filter(|node| node.name == "AXIS");
        let Some(axis) = axes.nth(2) else {
            return Ok(None);
        };
        if axis.is_of_depths() {
            return Err(depths());
        }
        // A unit that all axes share is one of lengths on a map alone.
        let shared = self
            .unit()
            .filter(|_| PROJECTED.contains(&self.name.as_str()));
        Ok(axis.unit().or(shared))
    }

    /// Does an axis go down?
    fn is_of_depths(&self) -> bool {
        self.title().to_ascii_lowercase().contains("depth")
    }
}

fn no_sense() -> DemError {
    invalid("the text of its SRS makes no sense")
}

fn depths() -> DemError {
    invalid("an SRS of depths is not read")
}
