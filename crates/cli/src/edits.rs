//! Text and JSON forms of edits. Offsets are in the units of the command line, sliders' amounts in metres.

use std::path::Path;

use glam::DVec3;
use rosto_face::Region;
use rosto_studio::{Anchors, Command, Expression, FaceSlider};
use serde::Deserialize;

use crate::error::CliError;
use crate::input;

pub const MM_PER_M: f64 = 1000.0;

/// Parses `VERTEX:DX,DY,DZ` or `VERTEX:DX,DY,DZ:A,B`; `VERTEX@LEVEL` addresses a vertex of a denser mesh.
pub fn vertex_edit(text: &str) -> Result<Command, String> {
    let mut parts = text.split(':');
    let (vertex, level) = vertex_of_level(parts.next().unwrap_or_default())?;
    let offset = offset(parts.next().ok_or("expected an offset after the vertex, as in 4:0,0,1")?)?;
    let anchors = parts.next().map(|anchors| anchors.split(',').map(self::vertex).collect()).transpose()?;
    match parts.next() {
        Some(rest) => Err(format!("unexpected {rest:?} after the anchors")),
        None => Ok(moved(level, vertex, offset, anchors)),
    }
}

/// The move of a vertex. Without anchors, the command line's settings select them.
fn moved(level: u32, vertex: u32, offset: DVec3, anchors: Option<Vec<u32>>) -> Command {
    let mut command = Command::move_vertex(level, vertex, offset);
    if let (Command::Move { spec, .. }, Some(anchors)) = (&mut command, anchors) {
        spec.settings.anchors = Anchors::explicit(anchors);
    }
    command
}

/// Parses `REGION:DX,DY,DZ`.
pub fn region_edit(text: &str) -> Result<Command, String> {
    let (name, offset) = text.split_once(':').ok_or("expected an offset after the region, as in nose:0,0,5")?;
    let region = Region::from_id(name).ok_or_else(|| format!("unknown region {name:?}; --help lists the regions"))?;
    Ok(Command::move_region(region, self::offset(offset)?))
}

/// Parses `SLIDER:MM`.
pub fn slider_edit(text: &str) -> Result<Command, String> {
    let (name, amount) = text.split_once(':').ok_or("expected an amount after the slider, as in jaw-width:-4")?;
    let slider =
        FaceSlider::from_id(name).ok_or_else(|| format!("unknown slider {name:?}; --help lists the sliders"))?;
    Ok(slider.command(number(amount)? / MM_PER_M))
}

/// Parses `EXPRESSION:WEIGHT`.
pub fn expression_edit(text: &str) -> Result<Command, String> {
    let (name, weight) = text.split_once(':').ok_or("expected a weight after the expression, as in jawOpen:0.6")?;
    let expression = Expression::from_id(name)
        .ok_or_else(|| format!("unknown expression {name:?}; --help lists the expressions"))?;
    let weight = Some(number(weight)?).filter(|weight| (0.0..=1.0).contains(weight));
    Ok(Command::Express { expression, weight: weight.ok_or("expected a weight from 0 to 1")? })
}

/// The command with its offsets multiplied by `unit`.
pub fn scaled(mut command: Command, unit: f64) -> Command {
    if let Command::Move { offsets, .. } = &mut command {
        offsets.iter_mut().for_each(|offset| *offset *= unit);
    }
    command
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
pub fn read(path: &Path) -> Result<Vec<Command>, CliError> {
    let unreadable = |reason| CliError::EditsUnreadable { path: path.to_owned(), reason };
    let bytes = input::read(path, MAX_BYTES).map_err(unreadable)?;
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(CliError::EditsUtf16 { path: path.to_owned() });
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let refused = |reason: serde_json::Error| CliError::EditsFile { path: path.to_owned(), reason: reason.to_string() };
    let edits: Vec<EditDto> = serde_json::from_slice(text).map_err(refused)?;
    let edit = |EditDto { vertex, level, offset, anchors }| moved(level, vertex, offset.into(), anchors);
    Ok(edits.into_iter().map(edit).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_parse_with_and_without_anchors() {
        let edit = |level, anchors| Ok(moved(level, 4, DVec3::new(-0.5, 0.0, 1e-3), anchors));
        assert_eq!(vertex_edit("4:-0.5,0,1e-3"), edit(0, None));
        assert_eq!(vertex_edit("4:-.5, 0 ,0.001:10,152"), edit(0, Some(vec![10, 152])));
        assert_eq!(vertex_edit("4@2:-0.5,0,1e-3"), edit(2, None));
        assert_ne!(edit(0, None), edit(0, Some(vec![10, 152])));
    }

    #[test]
    fn regions_sliders_and_expressions_parse_by_id() {
        let region = Command::move_region(Region::LeftBrow, DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(region_edit("left-brow:0,2,0"), Ok(region));
        assert_eq!(slider_edit("jaw-width:-4"), Ok(FaceSlider::JawWidth.command(-0.004)));
        let open = Command::Express { expression: Expression::JawOpen, weight: 0.6 };
        assert_eq!(expression_edit("jawOpen:0.6"), Ok(open));
        assert!(expression_edit("tongueOut:1").unwrap_err().contains("unknown expression"));
        assert!(expression_edit("jawOpen:1.2").unwrap_err().contains("from 0 to 1"));
        assert!(region_edit("ear:0,0,1").unwrap_err().contains("unknown region"));
        assert!(slider_edit("ear-size:1").unwrap_err().contains("unknown slider"));
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
            let reason = vertex_edit(text).unwrap_err();
            assert!(reason.contains(word), "{text}: {reason}");
        }
    }
}
