//! GDAL's side file NAME.EXT.aux.xml (its "persistent auxiliary metadata"), as GDAL reads it:
//! whatever it tells comes before what the file itself tells. Statistics and histograms are passed
//! over.

use super::nodata::number;
use super::wkt::{self, SystemOfText};
use crate::io::dem::error::{DemError, invalid};
use crate::io::text;
use roxmltree::{Document, Node};

/// The content of a side file, of the first band.
#[derive(Default)]
pub(in crate::io) struct PamFile {
    /// Corner of the first pixel and steps, as GDAL orders them.
    pub(in crate::io) transform: Option<[f64; 6]>,
    /// Is its place told by control points?
    pub(in crate::io) has_points: bool,
    pub(super) system: Option<SystemOfText>,
    /// The value of voids.
    pub(in crate::io) nodata: Option<String>,
    pub(in crate::io) scale: Option<f64>,
    pub(in crate::io) offset: Option<f64>,
    /// The unit of its values.
    pub(in crate::io) unit: Option<String>,
}

impl PamFile {
    /// Reads a side file.
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, DemError> {
        let text = text::decode(bytes).map_err(|error| invalid(error.problem))?;
        let text = text.trim_start_matches('\u{feff}').trim_start();
        let document = Document::parse(text).map_err(|error| invalid(one_line(error)))?;
        let root = document.root_element();
        // Other programs write other things under this name.
        if !root.has_tag_name("PAMDataset") {
            return Ok(Self::default());
        }
        let mut all = Self {
            transform: child(root, "GeoTransform").map(transform).transpose()?,
            has_points: child(root, "GCPList").is_some(),
            system: None,
            ..Self::default()
        };
        if let Some(srs) = content(root, "SRS") {
            all.system = Some(wkt::system(srs)?);
        }
        let bands = root
            .children()
            .filter(|node| node.has_tag_name("PAMRasterBand"));
        for band in bands.filter(|band| band.attribute("band").is_none_or(|k| k.trim() == "1")) {
            all.read_band(band)?;
        }
        Ok(all)
    }

    fn read_band(&mut self, band: Node) -> Result<(), DemError> {
        if let Some(text) = content(band, "NoDataValue") {
            number(text).ok_or_else(|| unsound("NoDataValue", text))?;
            self.nodata = Some(text.to_string());
        }
        let told = |name| content(band, name).map(|text| finite(name, text));
        self.scale = told("Scale").transpose()?;
        self.offset = told("Offset").transpose()?;
        self.unit = content(band, "UnitType").map(str::to_string);
        Ok(())
    }

    /// The number of voids.
    pub(in crate::io) fn void(&self) -> Option<f64> {
        self.nodata.as_deref().and_then(number)
    }

    /// The name of something that changes numbers, if there is any.
    pub(super) fn calibration(&self) -> Option<&'static str> {
        let scale = self.scale.filter(|scale| *scale != 1.0).map(|_| "Scale");
        let offset = self
            .offset
            .filter(|offset| *offset != 0.0)
            .map(|_| "Offset");
        scale.or(offset).or(self.unit.as_ref().map(|_| "UnitType"))
    }
}

fn child<'a, 'd>(node: Node<'a, 'd>, name: &str) -> Option<Node<'a, 'd>> {
    node.children().find(|node| node.has_tag_name(name))
}

/// The text of a child, if it has any.
fn content<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let text = child(node, name)?.text()?.trim();
    (!text.is_empty()).then_some(text)
}

/// Six numbers between commas.
fn transform(node: Node) -> Result<[f64; 6], DemError> {
    let text = node.text().unwrap_or_default();
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    let all = numbers.and_then(|numbers| numbers.try_into().ok());
    all.ok_or_else(|| unsound("GeoTransform", text))
}

fn finite(name: &str, text: &str) -> Result<f64, DemError> {
    let number = number(text).filter(|z| z.is_finite());
    number.ok_or_else(|| unsound(name, text))
}

fn unsound(name: &str, text: &str) -> DemError {
    let start: String = text.chars().take(40).collect();
    invalid(format!("{name} {start:?} is not read"))
}

fn one_line(error: impl ToString) -> String {
    error
        .to_string()
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}
