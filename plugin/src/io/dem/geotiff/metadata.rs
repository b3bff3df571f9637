//! GDAL_METADATA: XML with the scale, the offset and the unit of a band's numbers.

use super::nodata::number;
use super::pam::PamFile;
use super::structure::{refused, unsupported};
use super::tag;
use crate::io::dem::error::DemError;

use roxmltree::Document;

/// The quantity of the first band: `scale` times number plus `offset`, in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Calibration {
    scale: f64,
    offset: f64,
    /// As it is written; empty if it is not.
    pub(super) unit: String,
}

/// Name of the item that climate archives keep a unit in.
const UNITS: &str = "units";

impl Calibration {
    /// Of numbers that stand for themselves.
    const PLAIN: Self = Self {
        scale: 1.0,
        offset: 0.0,
        unit: String::new(),
    };

    /// Reads the items that have a role in the first band.
    pub(super) fn of(text: Option<&str>) -> Result<Self, DemError> {
        let mut all = Self::PLAIN;
        let Some(text) = text.filter(|text| !text.trim().is_empty()) else {
            return Ok(all);
        };
        let document = Document::parse(text).map_err(|_| refused(tag::GDAL_METADATA))?;
        for item in document.descendants() {
            if !item.has_tag_name("Item") || item.attribute("sample") != Some("0") {
                continue;
            }
            let value = item.text().unwrap_or_default();
            match item
                .attribute("role")
                .map(str::to_ascii_lowercase)
                .as_deref()
            {
                Some("scale") => all.scale = finite("scale", value)?,
                Some("offset") => all.offset = finite("offset", value)?,
                Some("unittype") => all.unit = value.trim().to_string(),
                None if item.attribute("name") == Some(UNITS) && all.unit.is_empty() => {
                    all.unit = value.trim().to_string();
                }
                _ => {}
            }
        }
        Ok(all)
    }

    /// The same, but for what a side file says otherwise.
    pub(super) fn with(mut self, pam: &PamFile) -> Self {
        self.scale = pam.scale.unwrap_or(self.scale);
        self.offset = pam.offset.unwrap_or(self.offset);
        self.unit = pam.unit.clone().unwrap_or(self.unit);
        self
    }

    /// The quantity that a number stands for.
    pub(super) fn apply(&self, z: f64) -> f64 {
        z * self.scale + self.offset
    }
}

fn finite(role: &str, value: &str) -> Result<f64, DemError> {
    number(value)
        .filter(|z| z.is_finite())
        .ok_or_else(|| unsupported(tag::GDAL_METADATA, format!("with the {role} {value:?}")))
}
