use rosto_laplacian::ConstraintKind;
use serde_json::{Value, json};

use super::VERSION;
use crate::{AnchorKind, Command, EditSpec, Entry, RegionOfInfluence};

/// The entries as JSON text.
pub fn to_json(entries: &[Entry]) -> String {
    let entries: Vec<Value> = entries.iter().map(entry).collect();
    json!({"rosto": "history", "version": VERSION, "entries": entries}).to_string()
}

fn entry(entry: &Entry) -> Value {
    let mut object = json!({"label": entry.label, "switch": entry.switch.id()});
    match &entry.command {
        Command::Move { spec, offsets } => {
            let offsets: Vec<Value> = offsets.iter().map(|offset| json!([offset.x, offset.y, offset.z])).collect();
            object["move"] = movement(spec, offsets);
        }
        Command::Symmetrise { share } => object["symmetrise"] = json!({"share": share}),
        Command::Express { expression, weight } => {
            object["express"] = json!({"expression": expression.id(), "weight": weight});
        }
    }
    object
}

fn movement(spec: &EditSpec, offsets: Vec<Value>) -> Value {
    let settings = &spec.settings;
    let constraint = match settings.constraint {
        ConstraintKind::Soft { weight } => json!({"soft": weight}),
        ConstraintKind::Hard => json!("exact"),
    };
    let kind = match settings.anchors.kind {
        AnchorKind::PinsOnly => json!("pins"),
        AnchorKind::Oval => json!("oval"),
        AnchorKind::Random { seed } => json!({"random": seed}),
        AnchorKind::Outside { radius } => json!({"outside": radius}),
    };
    let influence = match settings.influence {
        RegionOfInfluence::Whole => json!("whole"),
        RegionOfInfluence::Within { radius } => json!({"within": radius}),
    };
    json!({
        "level": spec.level,
        "handles": spec.handles,
        "offsets": offsets,
        "operator": settings.operator.id(),
        "constraint": constraint,
        "anchors": {"kind": kind, "pins": settings.anchors.pins},
        "influence": influence,
        "mirror": settings.mirror.id(),
        "details": settings.details.id(),
    })
}
