use std::path::Path;
use std::str::FromStr;

use glam::DVec3;
use rosto_face::Region;
use rosto_studio::{Expression, FaceSlider};
use serde::Deserialize;

use crate::error::CliError;
use crate::input;

/// Edit of one vertex, in the units of the command line.
#[derive(Debug, Clone, PartialEq)]
pub struct Edit {
    /// Subdivision level of the vertex's mesh; 0 for landmarks.
    pub level: u32,
    pub vertex: u32,
    pub offset: DVec3,
    /// Vertices that stay fixed; `None` uses the anchor rule.
    pub anchors: Option<Vec<u32>>,
}

impl FromStr for Edit {
    type Err = String;

    /// Parses `VERTEX:DX,DY,DZ` or `VERTEX:DX,DY,DZ:A,B`; `VERTEX@LEVEL` addresses a vertex of a denser mesh.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut parts = text.split(':');
        let (vertex, level) = vertex_of_level(parts.next().unwrap_or_default())?;
        let offset = offset(parts.next().ok_or("expected an offset after the vertex, as in 4:0,0,1")?)?;
        let anchors = parts.next().map(|anchors| anchors.split(',').map(self::vertex).collect()).transpose()?;
        match parts.next() {
            Some(rest) => Err(format!("unexpected {rest:?} after the anchors")),
            None => Ok(Self { level, vertex, offset, anchors }),
        }
    }
}

/// Offset of a region, in the units of the command line.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionEdit {
    pub region: Region,
    pub offset: DVec3,
}

impl FromStr for RegionEdit {
    type Err = String;

    /// Parses `REGION:DX,DY,DZ`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, offset) = text.split_once(':').ok_or("expected an offset after the region, as in nose:0,0,5")?;
        let region =
            Region::from_id(name).ok_or_else(|| format!("unknown region {name:?}; --help lists the regions"))?;
        Ok(Self { region, offset: self::offset(offset)? })
    }
}

/// Slider and its amount in millimetres.
#[derive(Debug, Clone, PartialEq)]
pub struct SliderEdit {
    pub slider: FaceSlider,
    pub amount_mm: f64,
}

impl FromStr for SliderEdit {
    type Err = String;

    /// Parses `SLIDER:MM`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, amount) = text.split_once(':').ok_or("expected an amount after the slider, as in jaw-width:-4")?;
        let slider =
            FaceSlider::from_id(name).ok_or_else(|| format!("unknown slider {name:?}; --help lists the sliders"))?;
        Ok(Self { slider, amount_mm: number(amount)? })
    }
}

/// Expression and its weight, 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpressionEdit {
    pub expression: Expression,
    pub weight: f64,
}

impl FromStr for ExpressionEdit {
    type Err = String;

    /// Parses `EXPRESSION:WEIGHT`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, weight) = text.split_once(':').ok_or("expected a weight after the expression, as in jawOpen:0.6")?;
        let expression = Expression::from_id(name)
            .ok_or_else(|| format!("unknown expression {name:?}; --help lists the expressions"))?;
        let weight = Some(number(weight)?).filter(|weight| (0.0..=1.0).contains(weight));
        Ok(Self { expression, weight: weight.ok_or("expected a weight from 0 to 1")? })
    }
}

fn vertex_of_level(text: &str) -> Result<(u32, u32), String> {
    let Some((vertex, level)) = text.split_once('@') else { return Ok((self::vertex(text)?, 0)) };
    let level =
        level.trim().parse().map_err(|_| format!("invalid level {level:?}; expected a whole number such as 3"))?;
    Ok((self::vertex(vertex)?, level))
}

fn vertex(text: &str) -> Result<u32, String> {
    text.trim().parse().map_err(|_| format!("invalid vertex {text:?}; expected a whole number such as 4"))
}

fn offset(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> = text.split(',').map(number).collect::<Result<_, _>>()?;
    let [x, y, z] = numbers[..] else {
        return Err(format!("invalid offset {text:?}; expected three numbers separated by commas"));
    };
    Ok(DVec3::new(x, y, z))
}

fn number(text: &str) -> Result<f64, String> {
    let number: Option<f64> = text.trim().parse().ok();
    number.filter(|number| number.is_finite()).ok_or_else(|| format!("{text:?} is not a finite number"))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EditDto {
    vertex: u32,
    #[serde(default)]
    level: u32,
    offset: [f64; 3],
    anchors: Option<Vec<u32>>,
}

/// Limit that still allows more than 100,000 edits.
const MAX_BYTES: usize = 16_000_000;

/// Reads a JSON file of edits, with or without a byte-order mark.
pub fn read(path: &Path) -> Result<Vec<Edit>, CliError> {
    let unreadable = |reason| CliError::EditsUnreadable { path: path.to_owned(), reason };
    let bytes = input::read(path, MAX_BYTES).map_err(unreadable)?;
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(CliError::EditsUtf16 { path: path.to_owned() });
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let refused = |reason: serde_json::Error| CliError::EditsFile { path: path.to_owned(), reason: reason.to_string() };
    let edits: Vec<EditDto> = serde_json::from_slice(text).map_err(refused)?;
    let edit = |EditDto { vertex, level, offset, anchors }| Edit { level, vertex, offset: offset.into(), anchors };
    Ok(edits.into_iter().map(edit).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_parse_with_and_without_anchors() {
        let edit = |level, anchors| Edit { level, vertex: 4, offset: DVec3::new(-0.5, 0.0, 1e-3), anchors };
        assert_eq!("4:-0.5,0,1e-3".parse(), Ok(edit(0, None)));
        assert_eq!("4:-.5, 0 ,0.001:10,152".parse(), Ok(edit(0, Some(vec![10, 152]))));
        assert_eq!("4@2:-0.5,0,1e-3".parse(), Ok(edit(2, None)));
    }

    #[test]
    fn regions_sliders_and_expressions_parse_by_id() {
        let region = RegionEdit { region: Region::LeftBrow, offset: DVec3::new(0.0, 2.0, 0.0) };
        assert_eq!("left-brow:0,2,0".parse(), Ok(region));
        assert_eq!("jaw-width:-4".parse(), Ok(SliderEdit { slider: FaceSlider::JawWidth, amount_mm: -4.0 }));
        let open = ExpressionEdit { expression: Expression::JawOpen, weight: 0.6 };
        assert_eq!("jawOpen:0.6".parse(), Ok(open));
        assert!("tongueOut:1".parse::<ExpressionEdit>().unwrap_err().contains("unknown expression"));
        assert!("jawOpen:1.2".parse::<ExpressionEdit>().unwrap_err().contains("from 0 to 1"));
        assert!("ear:0,0,1".parse::<RegionEdit>().unwrap_err().contains("unknown region"));
        assert!("ear-size:1".parse::<SliderEdit>().unwrap_err().contains("unknown slider"));
    }

    #[test]
    fn invalid_edits_report_the_reason() {
        for (text, word) in [
            ("nose:0,0,1", "invalid vertex"),
            ("4@dense:0,0,1", "invalid level"),
            ("4", "expected an offset"),
            ("4:0,0", "three numbers"),
            ("4:0,0,nan", "not a finite number"),
            ("4:0,0,1:x,2", "invalid vertex"),
            ("4:0,0,1:1,2:3", "unexpected"),
        ] {
            let reason = text.parse::<Edit>().unwrap_err();
            assert!(reason.contains(word), "{text}: {reason}");
        }
    }
}
