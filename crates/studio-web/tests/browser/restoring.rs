//! Faces, settings and textures from text and pictures.

use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::*;

#[wasm_bindgen_test]
async fn edits_are_restored_from_text_at_each_density() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "density": "0" }));
    apply(&mut studio, json!({ "mirror": true }));
    select(&mut studio, 61);
    apply(&mut studio, json!({ "offset": [2, 3, 1] }));
    apply(&mut studio, json!("commit"));
    let (edits, expected) = (studio.saved_edits().unwrap(), shape(&studio));
    open(&mut studio).await;
    assert_ne!(shape(&studio), expected);
    open_work(&mut studio, 0, &history(&edits)).unwrap();
    assert_eq!(shape(&studio), expected);
    for (density, vertices) in [(1, 468 + 1365), (0, 468)] {
        apply(&mut studio, json!({ "density": density.to_string() }));
        assert_eq!(state(&studio)["vertexCount"], vertices);
        assert!(!pixels(&mut studio).await.is_empty());
    }
    assert_eq!(shape(&studio), expected);
    open_work(&mut studio, 1, &history(&edits)).unwrap();
    let now = state(&studio);
    assert_eq!((&now["chosen"]["density"], &now["vertexCount"]), (&json!("1"), &json!(468 + 1365)));
    apply(&mut studio, json!({ "density": "0" }));
    assert_eq!(shape(&studio), expected);
}

#[wasm_bindgen_test]
async fn a_face_returns_with_its_photos_edits_and_pictures() {
    let mut studio = studio().await;
    studio.add_picture("other/0".to_owned(), bitmap(2).await).unwrap();
    studio.add_photo(&photos(vec![found()]), "other/0".to_owned()).unwrap();
    select(&mut studio, NOSE_TIP);
    apply(&mut studio, json!({ "offset": [0, 0, 5] }));
    apply(&mut studio, json!({ "photo-lens": "distance:0.4" }));
    let now = state(&studio);
    assert_eq!((&now["photoLens"], &now["foundLens"]), (&json!("distance:0.4"), &json!("exif:26")));
    let saved = (studio.saved_photos().unwrap(), studio.saved_edits().unwrap(), studio.pictures());
    assert_eq!(saved.2, ["photo/0", "other/0"]);
    let about = studio.about().unwrap();
    open(&mut studio).await;
    assert_eq!(code(&studio.open(&saved.0, None, saved.2.clone()).unwrap_err()), "bad-face", "a dropped picture");
    studio.add_picture("other/0".to_owned(), bitmap(2).await).unwrap();
    studio.open(&saved.0, Some(saved.1.clone()), saved.2.clone()).unwrap();
    assert_eq!((studio.saved_photos().unwrap(), studio.saved_edits().unwrap(), studio.pictures()), saved);
    assert_eq!(studio.about().unwrap(), about, "the measures of the edited face");
    studio.remove_photo(0).unwrap();
    assert_eq!(studio.pictures(), ["other/0"]);
}

#[wasm_bindgen_test]
async fn only_the_wanted_texture_is_shown() {
    let mut studio = studio().await;
    let request = studio.texture_wanted().unwrap();
    assert_eq!(json_of(studio.set_texture(request + 100, bitmap(4).await).unwrap()), "nothing");
    assert_eq!(json_of(studio.set_texture(request, bitmap(4).await).unwrap()), "view");
    assert_eq!(studio.texture_wanted(), None);
    apply(&mut studio, json!({ "photo-lens": "distance:0.4" }));
    assert_eq!(json_of(studio.set_texture(request, bitmap(4).await).unwrap()), "nothing");
    assert!(studio.texture_wanted().is_some_and(|next| next != request));
}

#[wasm_bindgen_test]
async fn settings_and_view_are_restored_from_text() {
    let mut studio = studio().await;
    for setting in [json!({ "preset": "paper" }), json!({ "shading": "clay" }), json!({ "radius": 33 })] {
        apply(&mut studio, setting);
    }
    let chosen = state(&studio);
    let preferences = chosen["preferences"].as_str().unwrap();
    let mut later = self::studio().await;
    assert_ne!(state(&later), chosen);
    apply(&mut later, json!({ "restore-preferences": preferences }));
    // The open face keeps its density.
    apply(&mut later, json!({ "density": "0" }));
    assert_eq!(state(&later), chosen);
    let muddy = json!({ "restore-preferences": preferences.replace("clay", "mud") });
    assert_eq!(refusal(&mut later, muddy), "bad-choice");
    assert_eq!(state(&later), chosen);
}
