//! Round trips and validation of project files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::{SIDE, by_photo, face, png, source};
use rosto_export::*;
use rosto_face::{LANDMARK_COUNT, Triangulation};

const EDITS: &str = r#"{"entries":[0.1,"é"],"rosto":"history","version":1}"#;
const NUMBERS: usize = LANDMARK_COUNT * 15;

fn file() -> Vec<u8> {
    let face = face(Triangulation::Canonical);
    project::write(&Source { density: 2, ..source(&face, Some(EDITS)) }, &png()).unwrap()
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

fn field(field: &'static str) -> Result<Reopened<'static>, ReopenError> {
    Err(ReopenError::Field { field })
}

#[test]
fn face_edits_and_photo_round_trip() {
    let saved = face(Triangulation::Canonical);
    let bytes = file();
    let opened = project::read(&bytes).unwrap();
    let landmarks: Vec<[f32; 3]> = saved.positions_image().iter().map(|p| p.as_vec3().to_array()).collect();
    assert_eq!((opened.landmarks, opened.colours_srgb), (landmarks, saved.colours_srgb().to_vec()));
    assert_eq!((opened.photo_size_px, opened.triangulation, opened.density), ([SIDE; 2], Triangulation::Canonical, 2));
    assert_eq!(opened.history.as_deref(), Some(EDITS));
    let picture = opened.texture.unwrap();
    assert_eq!((picture.encoded.as_ref(), picture.media_type()), (png().as_slice(), "image/png"));
    assert_eq!((picture.picture_size_px, picture.at_px, picture.size_px), ([SIDE; 2], [0, 0], [SIDE; 2]));
}

#[test]
fn the_layout_is_as_documented() {
    let bytes = file();
    assert!(bytes.starts_with(br#"{"format":"rosto-project","version":1,"width_px":300,"#));
    let (header, body) = parts(&bytes);
    let header: serde_json::Value = serde_json::from_str(&header).unwrap();
    assert_eq!(header["edits"], serde_json::from_str::<serde_json::Value>(EDITS).unwrap());
    assert_eq!((&header["triangulation"], &header["density"]), (&"canonical".into(), &2.into()));
    assert_eq!(body.len(), NUMBERS + png().len());
    assert_eq!(&body[NUMBERS..], png());
}

#[test]
fn key_order_whitespace_and_byte_order_mark_are_ignored() {
    let expected = file();
    let reordered = with_header(|header| {
        let value: serde_json::Value = serde_json::from_str(header).unwrap();
        let keys =
            ["edits", "density", "triangulation", "lens", "points", "height_px", "width_px", "version", "format"];
        let fields: Vec<String> = keys.iter().map(|key| format!("\"{key}\" : {}", value[*key])).collect();
        format!("\u{FEFF} {{ {} }}\r", fields.join(" , "))
    });
    assert_eq!(sniff(&reordered), FileKind::Project);
    assert_eq!(project::read(&reordered), project::read(&expected));
}

#[test]
fn a_project_is_detected_even_if_long_edits_come_first() {
    let long = with_header(|header| {
        let edits = format!(r#"{{"edits":{{"label":"{}"}},"#, "x".repeat(9000));
        header.replacen('{', &edits, 1)
    });
    let face = face(Triangulation::Canonical);
    let glb = glb(&Model::of_face(&face), &by_photo()).unwrap();
    let cases: [(&[u8], FileKind); 8] = [
        (&file(), FileKind::Project),
        (&long[..SNIFFED_BYTES], FileKind::Project),
        (&glb, FileKind::Glb),
        (&png(), FileKind::Other),
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
    let other = with_header(|header| header.replace("\"version\":1,\"width", "\"version\":2,\"width"));
    assert_eq!(project::read(&other), Err(ReopenError::Version { found: 2, known: 1 }));
}

#[test]
fn invalid_fields_are_named() {
    let cases = [
        ("\"version\":1,\"width", "\"version\":\"1\",\"width", "version"),
        ("\"points\":468", "\"points\":470", "points"),
        ("\"points\":468,", "", "points"),
        ("\"lens\":\"parallel\"", "\"lens\":\"distance:0\"", "lens"),
        ("\"lens\":\"parallel\",", "", "lens"),
        ("\"width_px\":300", "\"width_px\":0", "width_px"),
        ("\"height_px\":300", "\"height_px\":-4", "height_px"),
        ("\"height_px\":300", "\"height\":300", "height_px"),
        ("\"canonical\"", "\"spherical\"", "triangulation"),
        ("\"density\":2", "\"density\":5", "density"),
        ("\"edits\":{", "\"was\":{", "edits"),
    ];
    for (from, to, name) in cases {
        assert_eq!(project::read(&with_header(|header| header.replacen(from, to, 1))), field(name), "{to}");
    }
    for edits in ["null", "[]", "\"none\""] {
        let other = with_header(|header| format!("{}{edits}}}", &header[..header.find("{\"entries").unwrap()]));
        assert_eq!(project::read(&other), field("edits"), "{edits}");
    }
}

#[test]
fn implausible_landmarks_are_refused() {
    let bytes = file();
    let (header, body) = parts(&bytes);
    let with_landmarks = |change: &dyn Fn(usize) -> f32| {
        let landmarks: Vec<u8> = (0..3 * LANDMARK_COUNT).flat_map(|at| change(at).to_le_bytes()).collect();
        [header.as_bytes(), b"\n", &landmarks, &body[landmarks.len()..]].concat()
    };
    let found = |at: usize| f32::from_le_bytes(body[4 * at..4 * at + 4].try_into().unwrap());
    assert!(project::read(&with_landmarks(&found)).is_ok());
    let wrong: [&dyn Fn(usize) -> f32; 5] = [
        &|_| 0.0,
        &|_| 0.5,
        &|at| if at == 7 { f32::NAN } else { found(at) },
        &|at| if at == 7 { 1e30 } else { found(at) },
        &|at| found(at) * 1e-30,
    ];
    for (case, change) in wrong.into_iter().enumerate() {
        assert_eq!(project::read(&with_landmarks(change)), field("landmarks"), "case {case}");
    }
}

#[test]
fn a_truncated_project_is_refused() {
    let bytes = file();
    for end in (0..bytes.len()).step_by(61).chain(bytes.len() - 20..bytes.len()) {
        assert!(project::read(&bytes[..end]).is_err(), "opened with {end} of {} bytes", bytes.len());
    }
    let cut = &bytes[..bytes.len() - 5];
    let expected = Err(ReopenError::Truncated { expected: bytes.len(), found: bytes.len() - 5 });
    assert_eq!(project::read(cut), expected);
}

#[test]
fn an_invalid_or_oversized_picture_is_refused() {
    let at = file().len() - png().len();
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
fn a_project_requires_a_history_and_a_png() {
    let face = face(Triangulation::Canonical);
    assert_eq!(project::write(&source(&face, None), &png()), Err(ExportError::HistoryNotAnObject));
    assert_eq!(project::write(&source(&face, Some("null")), &png()), Err(ExportError::HistoryNotAnObject));
    assert_eq!(project::write(&source(&face, Some("{}")), b"GIF89a"), Err(ExportError::NotPng));
}

#[test]
fn photo_edits_round_trip() {
    let face = face(Triangulation::Canonical);
    let in_photo = r#"{"kept_px":[[[1.0,2.0,3.0]]],"seen_from_m":1.5}"#;
    let source = Source { in_photo: Some(in_photo), ..source(&face, Some(EDITS)) };
    let file = project::write(&source, &png()).unwrap();
    assert_eq!(project::read(&file).unwrap().in_photo.as_deref(), Some(in_photo));
    let none = project::write(&Source { in_photo: None, ..source }, &png()).unwrap();
    assert_eq!(project::read(&none).unwrap().in_photo, None);
}
