use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Operator};
use serde_json::Value;
use thiserror::Error;

use super::VERSION;
use crate::{
    AnchorKind, Anchors, Command, Details, EditSpec, Entry, Expression, MAX_ENTRIES, Mirror, RegionOfInfluence,
    Settings, Switch,
};

/// Why text cannot be read as a history.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ProjectError {
    /// It is not JSON, or not a history.
    #[error("not a Rosto history")]
    NotAHistory,
    /// It was written by another version of Rosto.
    #[error(
        "the history has version {found}, but this Rosto reads only version {known}: open it with the Rosto that wrote it"
    )]
    Version {
        /// The version in the file.
        found: u64,
        /// The supported version.
        known: u64,
    },
    /// The history has too many entries.
    #[error("the history has {found} entries; the maximum is {max}")]
    TooManyEntries {
        /// Number of entries.
        found: usize,
        /// Highest number of entries.
        max: usize,
    },
    /// A field of an entry is missing or has an unexpected value.
    #[error("field {field:?} of entry {entry} is missing or invalid")]
    Field {
        /// The entry, from 0.
        entry: usize,
        /// The field's name.
        field: &'static str,
    },
}

/// Error type where the field is known but the entry's index is not.
type FieldResult<T> = Result<T, &'static str>;

/// Reads the output of [`to_json`](super::to_json). Does not check that the vertices exist; the document does.
///
/// # Errors
/// [`ProjectError`] if the text is not a history, has another version, or contains an invalid entry.
pub fn from_json(text: &str) -> Result<Vec<Entry>, ProjectError> {
    let file: Value = serde_json::from_str(text).map_err(|_| ProjectError::NotAHistory)?;
    if file["rosto"] != "history" {
        return Err(ProjectError::NotAHistory);
    }
    let found = file["version"].as_u64().ok_or(ProjectError::NotAHistory)?;
    if found != VERSION {
        return Err(ProjectError::Version { found, known: VERSION });
    }
    let entries = file["entries"].as_array().ok_or(ProjectError::NotAHistory)?;
    if entries.len() > MAX_ENTRIES {
        return Err(ProjectError::TooManyEntries { found: entries.len(), max: MAX_ENTRIES });
    }
    let entries = entries.iter().enumerate();
    entries.map(|(index, value)| entry(value).map_err(|field| ProjectError::Field { entry: index, field })).collect()
}

fn entry(value: &Value) -> FieldResult<Entry> {
    let label = value["label"].as_str().ok_or("label")?.to_owned();
    let switch = value["switch"].as_str().and_then(Switch::from_id).ok_or("switch")?;
    let command = match (value.get("move"), value.get("symmetrise"), value.get("express")) {
        (Some(movement), None, None) => {
            Command::Move { spec: spec(movement)?, offsets: offsets(&movement["offsets"])? }
        }
        (None, Some(symmetrise), None) => Command::Symmetrise { share: symmetrise["share"].as_f64().ok_or("share")? },
        (None, None, Some(express)) => Command::Express {
            expression: express["expression"].as_str().and_then(Expression::from_id).ok_or("expression")?,
            weight: express["weight"].as_f64().ok_or("weight")?,
        },
        _ => return Err("move, symmetrise or express"),
    };
    Ok(Entry { label, command, switch })
}

fn spec(value: &Value) -> FieldResult<EditSpec> {
    let operator = value["operator"].as_str().and_then(Operator::from_id).ok_or("operator")?;
    let constraint = match &value["constraint"] {
        Value::String(word) if word == "exact" => ConstraintKind::Hard,
        soft => ConstraintKind::Soft { weight: soft["soft"].as_f64().ok_or("constraint")? },
    };
    let mirror = value["mirror"].as_str().and_then(Mirror::from_id).ok_or("mirror")?;
    let influence = match &value["influence"] {
        Value::String(word) if word == "whole" => RegionOfInfluence::Whole,
        within => RegionOfInfluence::Within { radius: within["within"].as_f64().ok_or("influence")? },
    };
    let details = value["details"].as_str().and_then(Details::from_id).ok_or("details")?;
    let settings = Settings { operator, constraint, anchors: anchors(&value["anchors"])?, influence, mirror, details };
    let level = value["level"].as_u64().and_then(|level| level.try_into().ok()).ok_or("level")?;
    Ok(EditSpec { level, handles: vertices(&value["handles"]).ok_or("handles")?, settings })
}

fn anchors(value: &Value) -> FieldResult<Anchors> {
    let kind = match &value["kind"] {
        Value::String(word) if word == "pins" => AnchorKind::PinsOnly,
        Value::String(word) if word == "oval" => AnchorKind::Oval,
        rule => match (rule["random"].as_u64(), rule["outside"].as_f64()) {
            (Some(seed), None) => AnchorKind::Random { seed },
            (None, Some(radius)) => AnchorKind::Outside { radius },
            _ => return Err("anchors"),
        },
    };
    Ok(Anchors { kind, pins: vertices(&value["pins"]).ok_or("pins")? })
}

fn vertices(value: &Value) -> Option<Vec<u32>> {
    value.as_array()?.iter().map(|vertex| u32::try_from(vertex.as_u64()?).ok()).collect()
}

fn offsets(value: &Value) -> FieldResult<Vec<DVec3>> {
    let list = value.as_array().ok_or("offsets")?;
    list.iter().map(|offset| vector(offset).ok_or("offsets")).collect()
}

fn vector(value: &Value) -> Option<DVec3> {
    let [x, y, z] = value.as_array()?.as_slice() else { return None };
    Some(DVec3::new(x.as_f64()?, y.as_f64()?, z.as_f64()?))
}
