//! Requests that the library, the command line and Python carry out alike: `tests/requests.json`.
//!
//! The table is a list of objects:
//! - `name`: the file's name; `format`: a format's id
//! - `mesh`: triangulation and density; by default canonical and 2
//! - `edits`, in their order: `{"vertex", "level", "mm": [x, y, z]}`, `{"region", "mm": [x, y, z]}`, `{"slider", "mm"}`,
//!   `{"expression", "weight"}` or `{"symmetrise"}`, the share
//! - `settings` of vertices and regions, in the words of the command line; `radius_mm` is `null` without a limit
//! - `options`: ids of the file's options and of their choices

use crate::common::*;
use glam::DVec3;
use rosto::networks::Landmarks;
use rosto::{
    AnchorKind, Anchors, Command, Details, ExportOption, Expression, FaceFinder, FaceSlider, FileOptions, FindOptions,
    Format, Limits, MeshRequest, Mirror, Observation, Operator, Region, RegionOfInfluence, Settings, Triangulation,
    anchor_rule, constraint, decode,
};
use serde_json::Value;

const MM_PER_M: f64 = 1000.0;

fn table() -> Vec<Value> {
    serde_json::from_str(include_str!("../../../../tests/requests.json")).unwrap()
}

fn text<'a>(value: &'a Value, name: &str) -> Option<&'a str> {
    value[name].as_str()
}

fn vector_m(value: &Value) -> DVec3 {
    DVec3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap())) / MM_PER_M
}

fn observation() -> Observation {
    let folder = portrait().parent().unwrap().to_owned();
    let network = |name: &str| std::fs::read(folder.join(name)).unwrap();
    let (detector, landmarks) = (network("face_detector.onnx"), network(Landmarks::Attention.file()));
    let finder = FaceFinder::new(&detector, Landmarks::Attention.network(&landmarks)).unwrap();
    let photo = decode(&std::fs::read(portrait()).unwrap(), &Limits::default()).unwrap();
    MeshRequest::found_in(&[photo], &finder, &FindOptions::default()).unwrap().photos.remove(0)
}

/// The request, as a user of the library fills it.
fn request(row: &Value, photo: &Observation) -> MeshRequest {
    let mut request = MeshRequest::of(vec![photo.clone()]);
    if let Some(mesh) = row.get("mesh") {
        request.triangulation = Triangulation::from_id(text(mesh, "triangulation").unwrap()).unwrap();
        request.density = mesh["density"].as_u64().unwrap() as u32;
    }
    let edits = row["edits"].as_array().unwrap();
    let (moves, others): (Vec<&Value>, Vec<&Value>) =
        edits.iter().partition(|edit| edit.get("vertex").is_some() || edit.get("region").is_some());
    request.add_moves(moves.into_iter().map(command), &settings(&row["settings"]));
    request.edits.extend(others.into_iter().map(command));
    request
}

fn command(edit: &Value) -> Command {
    if let Some(slider) = text(edit, "slider") {
        return FaceSlider::from_id(slider).unwrap().command(edit["mm"].as_f64().unwrap() / MM_PER_M);
    }
    if let Some(expression) = text(edit, "expression") {
        let expression = Expression::from_id(expression).unwrap();
        return Command::Express { expression, weight: edit["weight"].as_f64().unwrap() };
    }
    if let Some(share) = edit["symmetrise"].as_f64() {
        return Command::Symmetrise { share };
    }
    match text(edit, "region") {
        Some(region) => Command::move_region(Region::from_id(region).unwrap(), vector_m(&edit["mm"])),
        None => {
            let [level, vertex] = ["level", "vertex"].map(|name| edit[name].as_u64().unwrap() as u32);
            Command::move_vertex(level, vertex, vector_m(&edit["mm"]))
        }
    }
}

fn settings(value: &Value) -> Settings {
    if value.is_null() {
        return Settings::default();
    }
    let kind = match anchor_rule(text(value, "anchors").unwrap()).unwrap() {
        AnchorKind::Outside { radius } => AnchorKind::Outside { radius: radius / MM_PER_M },
        kind => kind,
    };
    let within = |radius_mm: f64| RegionOfInfluence::Within { radius: radius_mm / MM_PER_M };
    Settings {
        operator: Operator::from_id(text(value, "operator").unwrap()).unwrap(),
        constraint: constraint(text(value, "constraint").unwrap()).unwrap(),
        anchors: Anchors { kind, pins: Vec::new() },
        influence: value["radius_mm"].as_f64().map_or(RegionOfInfluence::Whole, within),
        mirror: if value["mirror"] == true { Mirror::On } else { Mirror::Off },
        details: if value["turn_details"] == true { Details::AsRigidAsPossible } else { Details::Kept },
    }
}

/// Name and bytes of a file.
type Named = (String, Vec<u8>);

/// The file and its sidecar files, sorted by name.
fn by_library(row: &Value, photo: &Observation) -> Vec<Named> {
    let (name, format) = (text(row, "name").unwrap(), Format::from_id(text(row, "format").unwrap()).unwrap());
    let mut options = FileOptions::default();
    for (option, choice) in row["options"].as_object().unwrap() {
        options.set(ExportOption::from_id(option).unwrap(), choice.as_str().unwrap()).unwrap();
    }
    let written = request(row, photo).open().unwrap().write(format, &options, name).unwrap();
    let sidecars = written.sidecars.into_iter().map(|file| (file.name, file.bytes));
    let mut files: Vec<Named> = sidecars.chain([(format!("{name}.{}", format.id()), written.bytes)]).collect();
    files.sort();
    files
}

/// The words of `rosto mesh` for a row.
fn words(row: &Value) -> Vec<String> {
    let mut words = Vec::new();
    if let Some(mesh) = row.get("mesh") {
        let (topology, density) = (text(mesh, "triangulation").unwrap(), &mesh["density"]);
        words.extend([format!("--topology={topology}"), format!("--density={density}")]);
    }
    let joined = |value: &Value| value.as_array().unwrap().iter().map(Value::to_string).collect::<Vec<_>>().join(",");
    for edit in row["edits"].as_array().unwrap() {
        words.push(match ["vertex", "region", "slider", "expression", "symmetrise"].map(|kind| &edit[kind]) {
            [vertex, ..] if !vertex.is_null() => format!("--edit={vertex}@{}:{}", edit["level"], joined(&edit["mm"])),
            [_, Value::String(region), ..] => format!("--region={region}:{}", joined(&edit["mm"])),
            [_, _, Value::String(slider), ..] => format!("--slider={slider}:{}", edit["mm"]),
            [_, _, _, Value::String(expression), _] => format!("--expression={expression}:{}", edit["weight"]),
            [.., share] => format!("--symmetrise={share}"),
        });
    }
    for (name, value) in row["settings"].as_object().into_iter().flatten() {
        match (name.as_str(), value) {
            (_, Value::Null | Value::Bool(false)) => {}
            ("radius_mm", radius_mm) => words.push(format!("--radius={radius_mm}")),
            (name, Value::Bool(true)) => words.push(format!("--{}", name.replace('_', "-"))),
            (name, value) => words.push(format!("--{name}={}", value.as_str().unwrap())),
        }
    }
    for (option, choice) in row["options"].as_object().unwrap() {
        words.push(match (option.as_str(), choice.as_str().unwrap()) {
            ("edits", "morph-targets") => "--morph-targets".to_owned(),
            ("expressions", "morph-targets") => "--expressions".to_owned(),
            (option, choice) => format!("--{option}={choice}"),
        });
    }
    words
}

fn by_command_line(row: &Value) -> Vec<Named> {
    let name = text(row, "name").unwrap();
    let folder = scratch_folder(name);
    let output = folder.join(format!("{name}.{}", text(row, "format").unwrap()));
    let words = words(row);
    let run = mesh(&portrait(), &output, &words.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(code(&run), 0, "{name}: {}", said(&run));
    let bytes = |name: &String| std::fs::read(folder.join(name)).unwrap();
    names_in(&folder).into_iter().map(|name| (name.clone(), bytes(&name))).collect()
}

#[test]
#[ignore = "slow; runs at night"]
fn library_and_command_line_write_the_same_bytes() {
    let photo = observation();
    for row in table() {
        let [by_library, by_command_line] = [by_library(&row, &photo), by_command_line(&row)];
        let about =
            |files: &[Named]| files.iter().map(|(name, bytes)| format!("{name}: {}", bytes.len())).collect::<Vec<_>>();
        assert!(by_library == by_command_line, "{:?}, {:?}", about(&by_library), about(&by_command_line));
    }
}

#[test]
fn the_table_covers_each_format_edit_and_option() {
    let table = table();
    for format in Format::ALL {
        assert!(table.iter().any(|row| row["format"] == format.id()), "{}", format.id());
    }
    for option in ExportOption::ALL.into_iter().filter(|option| *option != ExportOption::Units) {
        assert!(table.iter().any(|row| row["options"].get(option.id()).is_some()), "{}", option.id());
    }
    let edits: Vec<&Value> = table.iter().filter_map(|row| row["edits"].as_array()).flatten().collect();
    for kind in ["vertex", "region", "slider", "expression", "symmetrise"] {
        assert!(edits.iter().any(|edit| edit.get(kind).is_some()), "{kind}");
    }
}
