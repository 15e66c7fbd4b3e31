//! Tests of the façade on a canvas in a browser.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use rosto::{SavedEdits, SavedFace};
use rosto_face::{Observation, PhotoLens, Triangulation, canonical_positions_m};
use rosto_session::{Changed, Intent};
use rosto_studio_web::{Studio, start};
use serde_json::{Value, json};
use tsify::Ts;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::{HtmlCanvasElement, ImageBitmap, ImageData};

wasm_bindgen_test_configure!(run_in_browser);

const NOSE_TIP: u32 = 1;
const CHIN: u32 = 199;
/// Number of vertices at the default density.
const SMOOTH: u32 = 7_257;
const SIDE_PX: u32 = 320;
const PHOTO_PX: u32 = 64;

fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().unchecked_into();
    document.body().unwrap().append_child(&canvas).unwrap();
    canvas
}

/// An empty studio with reduced motion.
async fn empty() -> Studio {
    let mut studio = start(canvas()).await.unwrap();
    apply(&mut studio, json!({ "resize": [[SIDE_PX, SIDE_PX], 1] }));
    apply(&mut studio, json!({ "reduced-motion": true }));
    studio
}

/// A message as a plain object.
fn object(message: &impl std::fmt::Display) -> JsValue {
    js_sys::JSON::parse(&message.to_string()).unwrap()
}

/// A plain object as JSON.
fn json_of(message: impl Into<JsValue>) -> Value {
    serde_json::from_str(&String::from(js_sys::JSON::stringify(&message.into()).unwrap())).unwrap()
}

fn attempt(studio: &mut Studio, intent: impl Into<JsValue>) -> Result<Value, JsValue> {
    Ok(json_of(studio.apply(Ts::<Intent>::new_unchecked(intent.into()))?))
}

/// Applies an intent that must be accepted; returns the answer.
fn apply(studio: &mut Studio, intent: Value) -> Value {
    attempt(studio, object(&intent)).unwrap()
}

/// Code of the error of an intent that must be refused.
fn refusal(studio: &mut Studio, intent: Value) -> String {
    code(&attempt(studio, object(&intent)).unwrap_err())
}

fn state(studio: &Studio) -> Value {
    json_of(studio.state().unwrap())
}

fn tick(studio: &Studio) -> Value {
    json_of(studio.tick().unwrap())
}

fn catalogue(studio: &Studio) -> Value {
    json_of(studio.catalogue().unwrap())
}

/// A studio with the canonical face, as detected in a reddish photo.
async fn studio() -> Studio {
    let mut studio = empty().await;
    open(&mut studio).await;
    studio
}

/// The canonical face, as found in a photo.
fn found() -> Observation {
    let landmark = |p: &glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|part| part as f32);
    Observation {
        landmarks: canonical_positions_m().iter().map(landmark).collect(),
        photo_size_px: [PHOTO_PX; 2],
        colours_srgb: vec![[210, 120, 90]; 468],
        found_lens: PhotoLens::Exif(26.0),
        lens: PhotoLens::Estimated,
        picture: None,
    }
}

fn photos(observations: Vec<Observation>) -> String {
    SavedFace { photos: observations, edits: None }.photos_json()
}

/// A reddish picture.
async fn bitmap(side: u32) -> ImageBitmap {
    let pixels = [210, 120, 90, 255].repeat((side * side) as usize);
    let data = ImageData::new_with_u8_clamped_array(Clamped(&pixels), side).unwrap();
    let promise = web_sys::window().unwrap().create_image_bitmap_with_image_data(&data).unwrap();
    JsFuture::from(promise).await.unwrap().unchecked_into()
}

/// Measures of the mesh, and places of the landmarks on the canvas once the camera is at rest.
fn shown_mesh(studio: &mut Studio) -> String {
    studio.draw(0.0).unwrap();
    let places: Vec<[f64; 2]> = (0..468).map(|vertex| place(studio, vertex)).collect();
    format!("{} {places:?}", studio.about().unwrap())
}

async fn open(studio: &mut Studio) {
    studio.add_picture("photo/0".to_owned(), bitmap(PHOTO_PX).await).unwrap();
    studio.open(&photos(vec![found()]), None, vec!["photo/0".to_owned()]).unwrap();
}

/// Opens the face with earlier edits, in its picture.
fn open_work(studio: &mut Studio, density: u32, edits: &str) -> Result<Ts<Changed>, JsValue> {
    let history = Some(edits.to_owned());
    let edits = SavedEdits { triangulation: Triangulation::Canonical, density, history, photo_edit: None };
    studio.open(&photos(vec![found()]), Some(edits.to_json().unwrap()), studio.pictures())
}

/// The history in the text of edits.
fn history(edits: &str) -> String {
    serde_json::from_str::<Value>(edits).unwrap()["history"].to_string()
}

/// Position of a vertex on the canvas.
fn place(studio: &Studio, vertex: u32) -> [f64; 2] {
    studio.screen_position(vertex).unwrap().try_into().unwrap()
}

/// Grabs a vertex with the mouse and drags it.
fn grab(studio: &mut Studio, vertex: u32, by_px: [f64; 2]) -> [f64; 2] {
    let from = place(studio, vertex);
    assert_eq!(apply(studio, json!({ "press": [from, false] }))["hasGrabbed"], true);
    apply(studio, json!({ "drag": [[from[0] + by_px[0], from[1] + by_px[1]], false] }));
    from
}

fn select(studio: &mut Studio, vertex: u32) {
    apply(studio, json!({ "select": { "landmark": vertex } }));
}

async fn pixels(studio: &mut Studio) -> Vec<u8> {
    let promise = studio.snapshot(SIDE_PX, SIDE_PX, true).unwrap();
    let snapshot = JsFuture::from(promise).await.unwrap();
    js_sys::Reflect::get(&snapshot, &"rgba".into()).unwrap().unchecked_into::<js_sys::Uint8ClampedArray>().to_vec()
}

fn code(thrown: &JsValue) -> String {
    assert!(thrown.is_instance_of::<js_sys::Error>());
    let field = |name: &str| js_sys::Reflect::get(thrown, &name.into()).unwrap().as_string().unwrap();
    assert!(!field("message").is_empty() && !field("hint").is_empty());
    field("code")
}

fn in_paper_mode(studio: &mut Studio) {
    apply(studio, json!({ "preset": "paper" }));
}

#[wasm_bindgen_test]
async fn the_empty_state_is_drawn_and_not_editable() {
    let mut studio = empty().await;
    apply(&mut studio, json!("close"));
    assert!(!studio.draw(0.0).unwrap());
    assert!(pixels(&mut studio).await.iter().any(|&channel| channel != 0));
    assert_eq!(state(&studio)["vertexCount"], 0);
    assert_eq!(apply(&mut studio, json!({ "hover": [160, 160] })).get("hovered"), None);
    assert_eq!(refusal(&mut studio, json!({ "select": { "landmark": NOSE_TIP } })), "no-face");
    assert_eq!(code(&studio.saved_edits().unwrap_err()), "no-face");
    assert_eq!(catalogue(&studio)["landmarks"][NOSE_TIP as usize], "nose-tip");
}

#[wasm_bindgen_test]
async fn the_empty_state_rotates_without_reduced_motion() {
    let mut studio = empty().await;
    apply(&mut studio, json!({ "reduced-motion": false }));
    apply(&mut studio, json!("close"));
    assert!(studio.draw(0.0).unwrap() && studio.draw(16.0).unwrap());
    apply(&mut studio, json!({ "reduced-motion": true }));
    assert!(!studio.draw(32.0).unwrap());
}

#[wasm_bindgen_test]
async fn a_face_has_its_photos_colours_and_does_not_move() {
    let mut studio = studio().await;
    assert!(!studio.draw(0.0).unwrap());
    let drawn = pixels(&mut studio).await;
    let solid: Vec<&[u8]> = drawn.chunks_exact(4).filter(|pixel| pixel[3] == 255).collect();
    assert!(solid.len() > 20_000, "{} px", solid.len());
    let reddish = solid.iter().filter(|pixel| pixel[0] > pixel[1] && pixel[1] > pixel[2]).count();
    assert!(reddish * 10 > solid.len() * 9, "{reddish} of {} px", solid.len());
    assert_eq!(state(&studio)["vertexCount"], SMOOTH);
}

#[wasm_bindgen_test]
async fn an_edit_changes_the_picture_and_can_be_undone() {
    let mut studio = studio().await;
    in_paper_mode(&mut studio);
    let before = (pixels(&mut studio).await, shown_mesh(&mut studio));
    select(&mut studio, NOSE_TIP);
    assert_eq!(state(&studio)["anchors"].as_array().unwrap().len(), 2);
    for tick in 1..=20 {
        assert_eq!(apply(&mut studio, json!({ "offset": [0, 0, tick] }))["changed"], "tick");
    }
    let moved = tick(&studio);
    assert!(moved["isEditing"] == true && moved["offsetMm"] == json!([0, 0, 20]));
    assert!(moved["shareReached"].as_f64().unwrap() > 0.1);
    assert_eq!(apply(&mut studio, json!("commit"))["changed"], "document");
    let after = state(&studio);
    let target = json!({ "kind": "landmark", "id": "nose-tip", "number": NOSE_TIP });
    let entry =
        json!({ "index": 0, "target": target, "amount": 20, "unit": "mm", "isEnabled": true, "isImpossible": false });
    assert_eq!((&after["entryCount"], &after["entries"]), (&json!(1), &json!([entry])));
    assert!(studio.saved_edits().unwrap().contains("\"nose-tip\""));
    assert_eq!(after["offsetMm"], json!([0, 0, 20]));
    let after = shown_mesh(&mut studio);
    assert_ne!(after, before.1);
    apply(&mut studio, json!({ "select": null }));
    let drawn = pixels(&mut studio).await;
    assert!(drawn.iter().zip(&before.0).any(|(now, then)| now.abs_diff(*then) > 30));
    apply(&mut studio, json!("undo"));
    assert_eq!(shown_mesh(&mut studio), before.1);
    assert_eq!(pixels(&mut studio).await, before.0);
    apply(&mut studio, json!("redo"));
    assert_eq!(shown_mesh(&mut studio), after);
}

#[wasm_bindgen_test]
async fn cancelling_and_empty_commits_change_nothing() {
    let mut studio = studio().await;
    let before = shown_mesh(&mut studio);
    select(&mut studio, NOSE_TIP);
    apply(&mut studio, json!({ "offset": [3, 0, 0] }));
    apply(&mut studio, json!("cancel"));
    apply(&mut studio, json!({ "offset": [0, 0, 0] }));
    apply(&mut studio, json!("commit"));
    assert_eq!(state(&studio)["canUndo"], false);
    assert_eq!(shown_mesh(&mut studio), before);
}

#[wasm_bindgen_test]
async fn a_dragged_landmark_follows_the_pointer() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "mirror": false }));
    select(&mut studio, NOSE_TIP);
    let from = grab(&mut studio, NOSE_TIP, [24.0, -10.0]);
    let to = place(&studio, NOSE_TIP);
    assert!((to[0] - from[0] - 24.0).abs() < 1e-6 && (to[1] - from[1] + 10.0).abs() < 1e-6, "{to:?}");
    assert_eq!(state(&studio)["isDragging"], true);
    assert_eq!(apply(&mut studio, json!({ "along": "x" }))["changed"], "tick");
    let moved = tick(&studio);
    assert!(moved["along"] == "x" && moved["offsetMm"][0].as_f64().unwrap() > 1.0);
    assert_eq!((&moved["offsetMm"][1], &moved["offsetMm"][2]), (&json!(0), &json!(0)));
    apply(&mut studio, json!("cancel"));
    assert_eq!(place(&studio, NOSE_TIP), from);
    assert_eq!(apply(&mut studio, json!({ "drag": [[from[0] + 50.0, from[1]], false] }))["changed"], "nothing");
    apply(&mut studio, json!("release"));
    let after = state(&studio);
    assert_eq!((&after["isDragging"], &after["entryCount"]), (&json!(false), &json!(0)));
}

#[wasm_bindgen_test]
async fn visible_vertices_can_be_hovered() {
    let mut studio = studio().await;
    let places: Vec<[f64; 2]> = (0..468).map(|vertex| place(&studio, vertex)).collect();
    assert_eq!(studio.screen_position(SMOOTH), None);
    let mut hovered = |at: [f64; 2]| apply(&mut studio, json!({ "hover": at }))["hovered"].as_u64();
    let seen = (0..468).filter(|&vertex| hovered(places[vertex as usize]) == Some(vertex));
    let seen = seen.count();
    assert!(seen > 300, "{seen}");
    let nose = places[NOSE_TIP as usize];
    assert_eq!((hovered(nose), hovered([1.0, 1.0])), (Some(NOSE_TIP.into()), None));
}

#[wasm_bindgen_test]
async fn refusals_have_codes_and_keep_the_face() {
    let mut studio = studio().await;
    assert_eq!(refusal(&mut studio, json!({ "select": { "landmark": 468 } })), "bad-vertex");
    assert_eq!(refusal(&mut studio, json!({ "pin": true })), "no-selection");
    apply(&mut studio, json!({ "mirror": false }));
    apply(&mut studio, json!({ "anchors": "pins" }));
    select(&mut studio, NOSE_TIP);
    let mesh = shown_mesh(&mut studio);
    assert_eq!(state(&studio)["refusal"], "unanchored");
    apply(&mut studio, json!({ "offset": [1, 0, 0] }));
    assert_eq!(shown_mesh(&mut studio), mesh);
    for pin in [7, 152] {
        select(&mut studio, pin);
        apply(&mut studio, json!({ "pin": true }));
    }
    select(&mut studio, NOSE_TIP);
    let pinned = state(&studio);
    assert_eq!((pinned.get("refusal"), &pinned["anchors"]), (None, &json!([7, 152])));
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
    for (photos, edits, pictures, why) in [
        (photos(vec![found()]), None, vec!["missing/0".to_owned()], "bad-face"),
        (photos(vec![found()]), None, Vec::new(), "bad-face"),
        (photos(vec![nowhere]), None, pictures.clone(), "bad-face"),
        ("[]".to_owned(), None, pictures.clone(), "bad-history"),
        (photos(vec![found()]), Some("{}".to_owned()), pictures.clone(), "bad-history"),
    ] {
        assert_eq!(code(&studio.open(&photos, edits, pictures).unwrap_err()), why, "{photos}");
    }
    assert_eq!(studio.pictures(), pictures);
    assert_eq!(state(&studio)["vertexCount"], SMOOTH);
    assert_eq!(shown_mesh(&mut studio), mesh);
}

#[wasm_bindgen_test]
async fn edits_are_restored_from_text_at_each_density() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "density": "0" }));
    apply(&mut studio, json!({ "mirror": true }));
    select(&mut studio, 61);
    apply(&mut studio, json!({ "offset": [2, 3, 1] }));
    apply(&mut studio, json!("commit"));
    let (edits, about) = (studio.saved_edits().unwrap(), studio.about().unwrap());
    open(&mut studio).await;
    assert_ne!(studio.about().unwrap(), about);
    open_work(&mut studio, 0, &history(&edits)).unwrap();
    assert_eq!(studio.about().unwrap(), about);
    for (density, vertices) in [(1, 468 + 1365), (0, 468)] {
        apply(&mut studio, json!({ "density": density.to_string() }));
        assert_eq!(state(&studio)["vertexCount"], vertices);
        assert!(!pixels(&mut studio).await.is_empty());
    }
    assert_eq!(studio.about().unwrap(), about);
    open_work(&mut studio, 1, &history(&edits)).unwrap();
    let now = state(&studio);
    assert_eq!((&now["chosen"]["density"], &now["vertexCount"]), (&json!("1"), &json!(468 + 1365)));
    apply(&mut studio, json!({ "density": "0" }));
    assert_eq!(studio.about().unwrap(), about);
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
async fn a_sliders_commit_matches_its_ticks_on_the_gpu() {
    let mut studio = studio().await;
    for slider in catalogue(&studio)["sliders"].as_array().unwrap() {
        let (id, max_mm) = (&slider["id"], slider["range"]["max"].as_f64().unwrap());
        apply(&mut studio, json!({ "slide": [id, 0.5 * max_mm] }));
        apply(&mut studio, json!({ "slide": [id, max_mm] }));
        let glowing = pixels(&mut studio).await;
        apply(&mut studio, json!("commit"));
        let kept = pixels(&mut studio).await;
        let outline = |pixels: &[u8]| pixels.chunks_exact(4).map(|pixel| pixel[3] > 127).collect::<Vec<bool>>();
        let differing = outline(&glowing).iter().zip(outline(&kept)).filter(|(tick, kept)| **tick != *kept).count();
        assert!(differing < 8, "{id}: {differing} px");
        apply(&mut studio, json!("undo"));
    }
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

#[wasm_bindgen_test]
async fn a_region_can_be_dragged_by_each_landmark() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "mirror": false }));
    apply(&mut studio, json!({ "select": { "region": "nose" } }));
    let from = grab(&mut studio, NOSE_TIP, [12.0, -10.0]);
    let to = place(&studio, NOSE_TIP);
    assert!((to[0] - from[0] - 12.0).abs() < 1e-6 && (to[1] - from[1] + 10.0).abs() < 1e-6, "{to:?}");
    apply(&mut studio, json!("release"));
    assert_eq!(state(&studio)["entries"][0]["target"]["id"], "nose");
    grab(&mut studio, CHIN, [0.0; 2]);
    let now = state(&studio);
    assert_eq!((&now["selected"], &now["target"]["kind"]), (&json!(CHIN), &json!("landmark")));
    apply(&mut studio, json!("release"));
    apply(&mut studio, json!({ "selection": "region" }));
    assert_eq!(state(&studio)["target"], json!({ "kind": "region", "id": "chin" }));
    grab(&mut studio, NOSE_TIP, [0.0; 2]);
    apply(&mut studio, json!("release"));
    assert_eq!(state(&studio)["target"]["id"], "nose-tip");
    assert_eq!(state(&studio)["entryCount"], 1);
    for (vertex, id) in [(NOSE_TIP, "nose-tip"), (152, "chin")] {
        let pointed = apply(&mut studio, json!({ "point-at": vertex }));
        assert_eq!(pointed["hoveredTarget"], json!({ "kind": "region", "id": id }));
    }
    apply(&mut studio, json!({ "select-at": NOSE_TIP }));
    assert_eq!(state(&studio)["target"]["id"], "nose");
}

#[wasm_bindgen_test]
async fn pinning_applies_to_the_selection_or_the_hovered_vertex() {
    let mut studio = studio().await;
    in_paper_mode(&mut studio);
    apply(&mut studio, json!({ "select": { "region": "chin" } }));
    assert_eq!(state(&studio)["isPinned"], false);
    apply(&mut studio, json!({ "pin": true }));
    assert_eq!(state(&studio)["isPinned"], true);
    let nose = place(&studio, NOSE_TIP);
    apply(&mut studio, json!({ "pin-under": nose }));
    apply(&mut studio, json!({ "anchors": "pins" }));
    select(&mut studio, 61);
    let is_anchor =
        |studio: &Studio, vertex: u32| state(studio)["anchors"].as_array().unwrap().contains(&json!(vertex));
    assert!(state(&studio)["isPinned"] == false && is_anchor(&studio, 152) && is_anchor(&studio, NOSE_TIP));
    apply(&mut studio, json!({ "pin-under": nose }));
    assert!(!is_anchor(&studio, NOSE_TIP));
    assert_eq!(apply(&mut studio, json!({ "pin-under": [1, 1] }))["changed"], "nothing");
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
