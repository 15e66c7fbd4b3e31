//! Refused intents and their codes.

use rosto_face::Observation;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::*;

#[wasm_bindgen_test]
async fn refusals_have_codes_and_keep_the_face() {
    let mut studio = studio().await;
    assert_eq!(refusal(&mut studio, json!({ "select": { "landmark": 468 } })), "bad-vertex");
    assert_eq!(refusal(&mut studio, json!({ "pin": true })), "no-selection");
    apply(&mut studio, json!({ "mirror": false }));
    apply(&mut studio, json!({ "anchors": "pins" }));
    select(&mut studio, NOSE_TIP);
    let mesh = shown_mesh(&mut studio);
    assert_eq!(state(&studio)["isRefused"], true);
    apply(&mut studio, json!({ "offset": [1, 0, 0] }));
    assert_eq!(shown_mesh(&mut studio), mesh);
    for pin in [7, 152] {
        select(&mut studio, pin);
        apply(&mut studio, json!({ "pin": true }));
    }
    select(&mut studio, NOSE_TIP);
    let pinned = state(&studio);
    assert_eq!((&pinned["isRefused"], &pinned["anchors"]), (&json!(false), &json!([7, 152])));
    apply(&mut studio, json!({ "offset": [0, 1, 0] }));
    assert_ne!(shown_mesh(&mut studio), mesh);
    apply(&mut studio, json!("cancel"));
    for (edits, why) in [("{}", "bad-history"), (r#"{"rosto":"history","version":99,"entries":[]}"#, "other-version")] {
        assert_eq!(code(&open_work(&mut studio, 0, edits).unwrap_err()), why);
    }
    assert_eq!(refusal(&mut studio, json!({ "density": "4" })), "bad-choice");
    let closed = bitmap(2).await;
    closed.close();
    assert_eq!(code(&studio.add_picture("closed/0".to_owned(), closed).unwrap_err()), "bad-face");
    let pictures = vec!["photo/0".to_owned()];
    let nowhere = Observation { landmarks: vec![[0.5; 3]; 468], ..found() };
    let scatter = |number: usize| (number + 1) as f32 * 0.618_034 % 1.0;
    let scatter = |landmark: usize| [0, 1, 2].map(|axis| scatter(3 * landmark + axis));
    let scattered = Observation { landmarks: (0..468).map(scatter).collect(), ..found() };
    for (photos, edits, pictures, why) in [
        (photos(vec![found()]), None, vec!["missing/0".to_owned()], "bad-face"),
        (photos(vec![found()]), None, Vec::new(), "bad-face"),
        (photos(vec![nowhere]), None, pictures.clone(), "bad-face"),
        (photos(vec![scattered]), None, pictures.clone(), "not-a-face"),
        ("[]".to_owned(), None, pictures.clone(), "bad-history"),
        (photos(vec![found()]), Some("{}".to_owned()), pictures.clone(), "bad-history"),
    ] {
        assert_eq!(code(&studio.open(&photos, edits, pictures).unwrap_err()), why, "{photos}");
    }
    // A distortion that no camera explains.
    let distorted = |[x, y, z]: [f32; 3]| [x + 0.05 * (40.0 * y).sin(), y, z];
    let strange = Observation { landmarks: found().landmarks.into_iter().map(distorted).collect(), ..found() };
    studio.add_picture("other/0".to_owned(), bitmap(2).await).unwrap();
    assert_eq!(code(&studio.add_photo(&photos(vec![strange]), "other/0".to_owned()).unwrap_err()), "another-face");
    let dropped = studio.add_photo(&photos(vec![found()]), "other/0".to_owned()).unwrap_err();
    assert_eq!(code(&dropped), "bad-face", "the picture of a refused photo is dropped");
    assert_eq!(studio.pictures(), pictures);
    assert_eq!(state(&studio)["vertexCount"], SMOOTH);
    assert_eq!(shown_mesh(&mut studio), mesh);
}

#[wasm_bindgen_test]
async fn other_values_than_intents_are_refused_with_a_code() {
    let mut studio = studio().await;
    let before = state(&studio);
    for (value, wanted) in [
        ("7", "bad-choice"),
        ("undefined", "bad-choice"),
        ("null", "bad-choice"),
        ("NaN", "bad-choice"),
        ("({})", "bad-choice"),
        ("[]", "bad-choice"),
        ("() => {}", "bad-choice"),
        ("'dance'", "bad-choice"),
        ("({ zoom: 1, undo: 1 })", "bad-choice"),
        ("({ slide: ['ear-size', 1] })", "bad-choice"),
        ("({ select: { region: 'ear' } })", "bad-choice"),
        ("({ mirror: 'on' })", "bad-choice"),
        ("({ zoom: NaN })", "bad-number"),
        ("({ zoom: 'far' })", "bad-number"),
        ("({ zoom: {} })", "bad-number"),
        ("({ offset: [NaN, 0, 0] })", "bad-number"),
        ("({ slide: ['nose-width', NaN] })", "bad-number"),
        ("({ slide: ['nose-width', undefined] })", "bad-number"),
        ("({ 'select-at': 1.5 })", "bad-number"),
        ("({ 'select-at': -1 })", "bad-number"),
        ("({ 'select-at': 2 ** 32 })", "bad-number"),
        ("({ switch: [Infinity, true] })", "bad-number"),
    ] {
        let error = attempt(&mut studio, js_sys::eval(value).unwrap()).unwrap_err();
        assert_eq!(code(&error), wanted, "{value}: {error:?}");
    }
    assert_eq!(state(&studio), before);
}
