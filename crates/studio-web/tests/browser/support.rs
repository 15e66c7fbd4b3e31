//! A studio with the canonical face, and shortcuts for its messages.

use rosto::{SavedEdits, SavedFace};
use rosto_face::{Observation, PhotoLens, Triangulation, canonical_positions_m};
use rosto_session::{Changed, Intent};
use rosto_studio_web::{Studio, start};
use serde_json::{Value, json};
use tsify::Ts;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{HtmlCanvasElement, ImageBitmap, ImageData};

pub const NOSE_TIP: u32 = 1;
pub const CHIN: u32 = 199;
/// Number of vertices at the default density.
pub const SMOOTH: u32 = 7_257;
pub const SIDE_PX: u32 = 320;
pub const PHOTO_PX: u32 = 64;

pub fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().unchecked_into();
    document.body().unwrap().append_child(&canvas).unwrap();
    canvas
}

/// An empty studio with reduced motion.
pub async fn empty() -> Studio {
    let mut studio = start(canvas()).await.unwrap();
    apply(&mut studio, json!({ "resize": [[SIDE_PX, SIDE_PX], 1] }));
    apply(&mut studio, json!({ "reduced-motion": true }));
    studio
}

/// A message as a plain object.
pub fn object(message: &impl std::fmt::Display) -> JsValue {
    js_sys::JSON::parse(&message.to_string()).unwrap()
}

/// A plain object as JSON.
pub fn json_of(message: impl Into<JsValue>) -> Value {
    serde_json::from_str(&String::from(js_sys::JSON::stringify(&message.into()).unwrap())).unwrap()
}

pub fn attempt(studio: &mut Studio, intent: impl Into<JsValue>) -> Result<Value, JsValue> {
    Ok(json_of(studio.apply(Ts::<Intent>::new_unchecked(intent.into()))?))
}

/// Applies an intent that must be accepted; returns the answer.
pub fn apply(studio: &mut Studio, intent: Value) -> Value {
    attempt(studio, object(&intent)).unwrap()
}

/// Code of the error of an intent that must be refused.
pub fn refusal(studio: &mut Studio, intent: Value) -> String {
    code(&attempt(studio, object(&intent)).unwrap_err())
}

pub fn state(studio: &Studio) -> Value {
    json_of(studio.state().unwrap())
}

pub fn tick(studio: &Studio) -> Value {
    json_of(studio.tick().unwrap())
}

pub fn catalogue() -> Value {
    json_of(rosto_studio_web::catalogue().unwrap())
}

/// A studio at rest with the canonical face, as detected in a reddish photo, from the front. It selects landmarks.
pub async fn studio() -> Studio {
    let mut studio = empty().await;
    open(&mut studio).await;
    apply(&mut studio, json!({ "backdrop": false }));
    apply(&mut studio, json!({ "selection": "landmark" }));
    studio.draw(-5000.0).unwrap();
    studio.draw(-1.0).unwrap();
    studio
}

/// The canonical face, as found in a photo.
pub fn found() -> Observation {
    let landmark = |p: &glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|part| part as f32);
    Observation {
        landmarks: canonical_positions_m().iter().map(landmark).collect(),
        photo_size_px: [PHOTO_PX; 2],
        colours_srgb: vec![[210, 120, 90]; 468],
        found_lens: PhotoLens::Exif(26.0),
        card: None,
        lens: PhotoLens::Estimated,
        picture: None,
    }
}

pub fn photos(observations: Vec<Observation>) -> String {
    SavedFace { photos: observations, edits: None }.photos_json()
}

/// A reddish picture.
pub async fn bitmap(side: u32) -> ImageBitmap {
    let pixels = [210, 120, 90, 255].repeat((side * side) as usize);
    let data = ImageData::new_with_u8_clamped_array(Clamped(&pixels), side).unwrap();
    let promise = web_sys::window().unwrap().create_image_bitmap_with_image_data(&data).unwrap();
    JsFuture::from(promise).await.unwrap().unchecked_into()
}

/// Measures of the mesh, and places of the landmarks on the canvas once the camera is at rest.
pub fn shown_mesh(studio: &mut Studio) -> String {
    studio.draw(0.0).unwrap();
    let places: Vec<[f64; 2]> = (0..468).map(|vertex| place(studio, vertex)).collect();
    format!("{} {places:?}", studio.about().unwrap())
}

pub async fn open(studio: &mut Studio) {
    studio.add_picture("photo/0".to_owned(), bitmap(PHOTO_PX).await).unwrap();
    studio.open(&photos(vec![found()]), None, vec!["photo/0".to_owned()]).unwrap();
}

/// Opens the face with earlier edits, in its picture.
pub fn open_work(studio: &mut Studio, density: u32, edits: &str) -> Result<Ts<Changed>, JsValue> {
    let history = Some(edits.to_owned());
    let edits = SavedEdits { triangulation: Triangulation::Canonical, density, history, photo_edit: None };
    studio.open(&photos(vec![found()]), Some(edits.to_json().unwrap()), studio.pictures())
}

/// The history in the text of edits.
pub fn history(edits: &str) -> String {
    serde_json::from_str::<Value>(edits).unwrap()["history"].to_string()
}

/// History and measures of the face.
pub fn shape(studio: &Studio) -> (String, String) {
    (history(&studio.saved_edits().unwrap()), studio.about().unwrap())
}

/// Position of a vertex on the canvas.
pub fn place(studio: &Studio, vertex: u32) -> [f64; 2] {
    studio.screen_position(vertex).unwrap().try_into().unwrap()
}

/// Grabs a vertex with the mouse and drags it.
pub fn grab(studio: &mut Studio, vertex: u32, by_px: [f64; 2]) -> [f64; 2] {
    let from = place(studio, vertex);
    assert_eq!(apply(studio, json!({ "press": [from, false] }))["hasGrabbed"], true);
    apply(studio, json!({ "drag": [[from[0] + by_px[0], from[1] + by_px[1]], false] }));
    from
}

pub fn select(studio: &mut Studio, vertex: u32) {
    apply(studio, json!({ "select": { "landmark": vertex } }));
}

pub async fn pixels(studio: &mut Studio) -> Vec<u8> {
    let promise = studio.snapshot(SIDE_PX, SIDE_PX, true).unwrap();
    let snapshot = JsFuture::from(promise).await.unwrap();
    js_sys::Reflect::get(&snapshot, &"rgba".into()).unwrap().unchecked_into::<js_sys::Uint8ClampedArray>().to_vec()
}

pub fn code(thrown: &JsValue) -> String {
    assert!(thrown.is_instance_of::<js_sys::Error>());
    let field = |name: &str| js_sys::Reflect::get(thrown, &name.into()).unwrap().as_string().unwrap();
    assert!(!field("message").is_empty() && !field("hint").is_empty());
    field("code")
}

pub fn in_paper_mode(studio: &mut Studio) {
    apply(studio, json!({ "preset": "paper" }));
}
