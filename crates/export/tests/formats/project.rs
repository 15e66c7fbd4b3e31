//! Round trips and validation of project files.

use crate::common::{by_photo, edits, face, gradient, rebuilt};
use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_export::*;
use rosto_face::{FaceError, Observation, Triangulation};

const EDITS: &str = r#"{"entries":[0.1,"é"],"rosto":"history","version":1}"#;

fn file() -> Vec<u8> {
    let face = face(Triangulation::Canonical);
    project::write(&Source { face: &face, edits: &SavedEdits { density: 2, ..edits(&face, Some(EDITS)) } }).unwrap()
}

/// Splits a project into its line of JSON and the rest.
fn parts(file: &[u8]) -> (String, &[u8]) {
    let line = file.iter().position(|&byte| byte == b'\n').unwrap();
    (String::from_utf8(file[..line].to_vec()).unwrap(), &file[line + 1..])
}

/// Returns the project with a changed line of JSON.
fn with_header(change: impl Fn(&str) -> String) -> Vec<u8> {
    let file = file();
    let (header, body) = parts(&file);
    let changed = change(&header);
    assert_ne!(changed, header, "the pattern was not found");
    [changed.as_bytes(), b"\n", body].concat()
}

fn field(field: &'static str) -> Result<Reopened, ReopenError> {
    Err(ReopenError::Field { field })
}

#[test]
fn face_edits_and_photo_round_trip() {
    let saved = face(Triangulation::Canonical);
    let opened = project::read(&file()).unwrap();
    assert!(!opened.changed_elsewhere);
    let edits = opened.face.edits.clone().unwrap();
    assert_eq!((edits.triangulation, edits.density), (Triangulation::Canonical, 2));
    assert_eq!(edits.history.as_deref(), Some(EDITS));
    let again = rebuilt(opened.face);
    assert_eq!(again.positions_m(), saved.positions_m(), "bit for bit");
    assert_eq!(again.photos(), saved.photos(), "with the lossless picture");
}

#[test]
fn the_layout_is_as_documented() {
    let bytes = file();
    assert!(bytes.starts_with(br#"{"format":"rosto-project","#));
    let (header, body) = parts(&bytes);
    let header: serde_json::Value = serde_json::from_str(&header).unwrap();
    assert_eq!(header["version"], 1);
    assert_eq!(header["history"], serde_json::from_str::<serde_json::Value>(EDITS).unwrap());
    assert_eq!((&header["triangulation"], &header["density"]), (&"canonical".into(), &2.into()));
    let observation = BASE64_STANDARD.decode(header["photos"][0]["observation"].as_str().unwrap()).unwrap();
    assert_eq!(observation, face(Triangulation::Canonical).photos()[0].to_bytes());
    let picture = rosto_photo::decode(body, &rosto_photo::Limits::default()).unwrap();
    assert!(body.starts_with(b"\x89PNG") && picture == gradient());
}

#[test]
fn key_order_whitespace_and_byte_order_mark_are_ignored() {
    let expected = file();
    let reordered = with_header(|header| {
        let value: serde_json::Value = serde_json::from_str(header).unwrap();
        let keys = ["format", "history", "density", "triangulation", "photos", "version"];
        let fields: Vec<String> = keys.iter().map(|key| format!("\"{key}\" : {}", value[*key])).collect();
        format!("\u{FEFF} {{ {} }}\r", fields.join(" , "))
    });
    assert_eq!(sniff(&reordered), FileKind::Project);
    assert_eq!(project::read(&reordered), project::read(&expected));
}

#[test]
fn a_project_is_detected_even_if_its_edits_are_long() {
    let long = with_header(|header| {
        let edits = format!(r#"","history":{{"label":"{}"}},"#, "x".repeat(9000));
        header.replacen("\",", &edits, 1)
    });
    let face = face(Triangulation::Canonical);
    let glb = glb(&Model::of_face(&face), &by_photo()).unwrap();
    let cases: [(&[u8], FileKind); 8] = [
        (&file(), FileKind::Project),
        (&long[..SNIFFED_BYTES], FileKind::Project),
        (&glb, FileKind::Glb),
        (b"\x89PNG\r\n\x1a\n", FileKind::Other),
        (b"", FileKind::Other),
        (br#"{"rosto":"history","version":1,"entries":[]}"#, FileKind::Other),
        (b"\xEF\xBB\xBF", FileKind::Other),
        (b"a letter about a \"rosto-project\"", FileKind::Other),
    ];
    for (start, kind) in cases {
        assert_eq!(sniff(start), kind, "{:?}", String::from_utf8_lossy(&start[..start.len().min(40)]));
    }
}

#[test]
fn another_version_is_refused() {
    let other = with_header(|header| header.replace("\"canonical\",\"version\":1", "\"canonical\",\"version\":2"));
    assert_eq!(project::read(&other), Err(ReopenError::Version { found: 2, known: 1 }));
}

#[test]
fn invalid_fields_are_named() {
    let cases = [
        ("\"canonical\",\"version\":1", "\"canonical\",\"version\":\"1\"", "version"),
        ("\"photos\"", "\"were\"", "photos"),
        ("\"observation\"", "\"was\"", "observation"),
        ("{\"observation\"", "{\"picture\":{},\"observation\"", "picture"),
        ("\"triangulation\":\"canonical\"", "\"triangulation\":\"spherical\"", "triangulation"),
        ("\"density\":2", "\"density\":5", "density"),
    ];
    for (from, to, name) in cases {
        assert_eq!(project::read(&with_header(|header| header.replacen(from, to, 1))), field(name), "{to}");
    }
    for history in ["null", "[]", "\"none\""] {
        let other = with_header(|header| header.replacen(EDITS, history, 1));
        assert_eq!(project::read(&other), field("history"), "{history}");
    }
}

#[test]
fn a_damaged_or_implausible_observation_is_refused() {
    let with_observation = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = face(Triangulation::Canonical).photos()[0].to_bytes();
        let before = BASE64_STANDARD.encode(&bytes);
        change(&mut bytes);
        project::read(&with_header(|header| header.replacen(&before, &BASE64_STANDARD.encode(&bytes), 1)))
    };
    let refused = |reason| Err(ReopenError::Face(reason));
    let version = FaceError::RecordVersion { found: 7, known: 1 };
    assert_eq!(with_observation(&|bytes| bytes[0] = 7), refused(version));
    let bytes = face(Triangulation::Canonical).photos()[0].to_bytes().len() - 1;
    assert_eq!(with_observation(&|bytes| bytes.truncate(bytes.len() - 1)), refused(FaceError::Record { bytes }));
    let landmarks = 11..11 + 468 * 12;
    assert_eq!(with_observation(&|bytes| bytes[landmarks.clone()].fill(0)), refused(FaceError::Degenerate));
}

#[test]
fn a_truncated_project_is_refused() {
    let bytes = file();
    for end in (0..bytes.len()).step_by(61).chain(bytes.len() - 20..bytes.len()) {
        assert!(project::read(&bytes[..end]).is_err(), "opened with {end} of {} bytes", bytes.len());
    }
}

#[test]
fn an_invalid_or_oversized_picture_is_refused() {
    let at = parts(&file()).0.len() + 1;
    for side in [0_u32, 8193] {
        let mut bytes = file();
        bytes[at + 16..at + 20].copy_from_slice(&side.to_be_bytes());
        assert_eq!(project::read(&bytes), field("picture"), "{side}");
    }
    let mut bytes = file();
    bytes[at] = b'?';
    assert_eq!(project::read(&bytes), field("picture"));
}

#[test]
fn a_project_requires_a_picture_and_a_json_history() {
    let face = face(Triangulation::Canonical);
    let write = |face, history| project::write(&Source { face, edits: &edits(face, history) });
    assert_eq!(write(&face, Some("null")), Err(ExportError::HistoryNotAnObject));
    let observation = Observation { picture: None, ..face.photos()[0].clone() };
    let bare = rosto_face::FaceModel::new(observation, Triangulation::Canonical).unwrap();
    assert_eq!(write(&bare, None), Err(ExportError::NoPicture));
    let unedited = project::read(&write(&face, None).unwrap()).unwrap();
    assert_eq!(unedited.face.edits.unwrap().history, None);
}

#[test]
fn photo_edits_round_trip() {
    let face = face(Triangulation::Canonical);
    let photo_edit = r#"{"protected_px":[[[1.0,2.0,3.0]]],"seen_from_m":1.5}"#;
    let read = |photo_edit: Option<&str>| {
        let edits = SavedEdits { photo_edit: photo_edit.map(str::to_owned), ..edits(&face, Some(EDITS)) };
        let file = project::write(&Source { face: &face, edits: &edits }).unwrap();
        project::read(&file).unwrap().face.edits.unwrap().photo_edit
    };
    assert_eq!(read(Some(photo_edit)).as_deref(), Some(photo_edit));
    assert_eq!(read(None), None);
}
