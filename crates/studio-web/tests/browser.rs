//! Tests of the façade on a canvas in a browser.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use rosto_face::canonical_positions_m;
use rosto_studio_web::{
    ChangeName, PointerName, RefusalName, ScreenPoint, Studio, StudioEntry, StudioFileOptions, start,
};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::HtmlCanvasElement;

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
    studio.resize(SIDE_PX, SIDE_PX, 1.0).unwrap();
    studio.set_reduced_motion(true).unwrap();
    studio
}

/// A studio with the canonical face, as detected in a reddish photo.
async fn studio() -> Studio {
    let mut studio = empty().await;
    open(&mut studio);
    studio
}

fn landmarks() -> Vec<f32> {
    let found = |p: &glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|coordinate| coordinate as f32);
    canonical_positions_m().iter().flat_map(found).collect()
}

fn colours() -> Vec<u8> {
    [210, 120, 90].repeat(468)
}

/// The mesh as JSON.
fn mesh_json(studio: &mut Studio, units: &str) -> Vec<u8> {
    let mut choices = StudioFileOptions::new();
    choices.choose("units", units).unwrap();
    studio.export_file("json", &choices).unwrap()
}

fn open(studio: &mut Studio) {
    let picture: Vec<u8> = [210, 120, 90, 255].repeat((PHOTO_PX * PHOTO_PX) as usize);
    studio.open_picture(PHOTO_PX, PHOTO_PX, None).unwrap();
    for rows in picture.chunks((4 * PHOTO_PX * 5) as usize) {
        studio.add_picture_rows(rows).unwrap();
    }
    studio.open_face(&landmarks(), PHOTO_PX, PHOTO_PX, &colours(), "estimated").unwrap();
}

/// Opens the face with earlier edits.
fn open_work(studio: &mut Studio, density: u32, edits: &str) -> Result<ChangeName, JsValue> {
    let triangulation = "canonical";
    studio.open_work(
        &landmarks(),
        PHOTO_PX,
        PHOTO_PX,
        &colours(),
        "estimated",
        triangulation,
        density,
        edits.to_owned(),
        None,
    )
}

fn entries(studio: &Studio) -> Vec<StudioEntry> {
    studio.latest_entries(u32::MAX)
}

/// Grabs a vertex with the mouse and drags it.
fn grab(studio: &mut Studio, vertex: u32, by_px: [f64; 2]) -> ScreenPoint {
    let from = studio.screen_position(vertex).unwrap();
    assert!(studio.press(from.x, from.y, PointerName::Mouse).unwrap());
    studio.drag(from.x + by_px[0], from.y + by_px[1], false).unwrap();
    from
}

async fn pixels(studio: &mut Studio) -> Vec<u8> {
    let promise = studio.snapshot(SIDE_PX, SIDE_PX, true).unwrap();
    let snapshot = JsFuture::from(promise).await.unwrap();
    let take: js_sys::Function = js_sys::Reflect::get(&snapshot, &"takePixels".into()).unwrap().unchecked_into();
    take.call0(&snapshot).unwrap().unchecked_into::<js_sys::Uint8Array>().to_vec()
}

fn code(thrown: &JsValue) -> String {
    assert!(thrown.is_instance_of::<js_sys::Error>());
    let field = |name: &str| js_sys::Reflect::get(thrown, &name.into()).unwrap().as_string().unwrap();
    assert!(!field("message").is_empty() && !field("hint").is_empty());
    field("code")
}

fn in_paper_mode(studio: &mut Studio) {
    studio.choose("preset", "paper").unwrap();
}

#[wasm_bindgen_test]
async fn the_empty_state_is_drawn_and_not_editable() {
    let mut studio = empty().await;
    studio.show_canonical().unwrap();
    assert!(!studio.draw(0.0).unwrap());
    assert!(pixels(&mut studio).await.iter().any(|&channel| channel != 0));
    assert_eq!(studio.state().vertex_count, 0);
    assert_eq!(studio.hover(160.0, 160.0).unwrap(), None);
    assert_eq!(code(&studio.select(Some(NOSE_TIP)).unwrap_err()), "no-face");
    assert_eq!(code(&studio.export_file("json", &StudioFileOptions::new()).unwrap_err()), "no-face");
    assert_eq!(studio.landmark_ids()[NOSE_TIP as usize], "nose-tip");
}

#[wasm_bindgen_test]
async fn the_empty_state_rotates_without_reduced_motion() {
    let mut studio = empty().await;
    studio.set_reduced_motion(false).unwrap();
    studio.show_canonical().unwrap();
    assert!(studio.draw(0.0).unwrap() && studio.draw(16.0).unwrap());
    studio.set_reduced_motion(true).unwrap();
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
    assert_eq!(studio.state().vertex_count, SMOOTH);
}

#[wasm_bindgen_test]
async fn an_edit_changes_the_picture_and_can_be_undone() {
    let mut studio = studio().await;
    in_paper_mode(&mut studio);
    let before = (pixels(&mut studio).await, mesh_json(&mut studio, "mm"));
    studio.select(Some(NOSE_TIP)).unwrap();
    assert_eq!(studio.state().anchors.len(), 2);
    for tick in 1..=20 {
        assert_eq!(studio.preview(0.0, 0.0, f64::from(tick)).unwrap(), ChangeName::Tick);
    }
    assert!(studio.tick().editing && studio.tick().share_reached > 0.1);
    assert_eq!(studio.commit().unwrap(), ChangeName::Document);
    let (state, entries) = (studio.state(), entries(&studio));
    assert_eq!((state.entry_count, entries.len()), (1, 1));
    let entry = &entries[0];
    assert_eq!((entry.amount, entry.unit.as_str(), entry.enabled), (20.0, "mm", true));
    assert_eq!((entry.target.id.as_str(), entry.target.number), ("nose-tip", Some(NOSE_TIP)));
    assert!(studio.edits_json().unwrap().contains("\"nose-tip\""));
    assert_eq!((state.kept_x_mm, state.kept_y_mm, state.kept_z_mm), (0.0, 0.0, 20.0));
    let after = mesh_json(&mut studio, "mm");
    assert_ne!(after, before.1);
    studio.select(None).unwrap();
    let drawn = pixels(&mut studio).await;
    assert!(drawn.iter().zip(&before.0).any(|(now, then)| now.abs_diff(*then) > 30));
    studio.undo().unwrap();
    assert_eq!(mesh_json(&mut studio, "mm"), before.1);
    assert_eq!(pixels(&mut studio).await, before.0);
    studio.redo().unwrap();
    assert_eq!(mesh_json(&mut studio, "mm"), after);
}

#[wasm_bindgen_test]
async fn cancelling_and_empty_commits_change_nothing() {
    let mut studio = studio().await;
    let before = mesh_json(&mut studio, "image");
    studio.select(Some(NOSE_TIP)).unwrap();
    studio.preview(3.0, 0.0, 0.0).unwrap();
    studio.cancel().unwrap();
    studio.preview(0.0, 0.0, 0.0).unwrap();
    studio.commit().unwrap();
    assert!(!studio.state().can_undo);
    assert_eq!(mesh_json(&mut studio, "image"), before);
    assert_eq!(code(&studio.preview(f64::NAN, 0.0, 0.0).unwrap_err()), "bad-number");
}

#[wasm_bindgen_test]
async fn a_dragged_landmark_follows_the_pointer() {
    let mut studio = studio().await;
    studio.set_mirror(false).unwrap();
    studio.select(Some(NOSE_TIP)).unwrap();
    let from = grab(&mut studio, NOSE_TIP, [24.0, -10.0]);
    let to = studio.screen_position(NOSE_TIP).unwrap();
    assert!((to.x - from.x - 24.0).abs() < 1e-6 && (to.y - from.y + 10.0).abs() < 1e-6, "{to:?}");
    assert!(studio.dragging());
    assert_eq!(studio.drag_along("x").unwrap(), ChangeName::Tick);
    let tick = studio.tick();
    assert!(tick.offset_x_mm > 1.0 && tick.offset_y_mm == 0.0 && tick.offset_z_mm == 0.0);
    studio.cancel().unwrap();
    assert_eq!(studio.screen_position(NOSE_TIP), Some(from));
    assert_eq!(studio.drag(from.x + 50.0, from.y, false).unwrap(), ChangeName::Nothing);
    studio.release().unwrap();
    assert!(!studio.dragging() && studio.state().entry_count == 0);
}

#[wasm_bindgen_test]
async fn visible_vertices_can_be_hovered() {
    let mut studio = studio().await;
    let places: Vec<ScreenPoint> = (0..468).map(|vertex| studio.screen_position(vertex).unwrap()).collect();
    assert_eq!(studio.screen_position(studio.state().vertex_count), None);
    let seen = (0..468).filter(|&vertex| {
        let place = places[vertex as usize];
        studio.hover(place.x, place.y).unwrap() == Some(vertex)
    });
    let seen = seen.count();
    assert!(seen > 300, "{seen}");
    let nose = places[NOSE_TIP as usize];
    assert_eq!(studio.hover(nose.x, nose.y).unwrap(), Some(NOSE_TIP));
    assert_eq!(studio.hover(1.0, 1.0).unwrap(), None);
}

#[wasm_bindgen_test]
async fn refusals_have_codes_and_keep_the_face() {
    let mut studio = studio().await;
    assert_eq!(code(&studio.select(Some(468)).unwrap_err()), "bad-vertex");
    assert_eq!(code(&studio.set_pinned(true).unwrap_err()), "no-selection");
    studio.set_mirror(false).unwrap();
    studio.choose("anchors", "pins").unwrap();
    studio.select(Some(NOSE_TIP)).unwrap();
    let mesh = mesh_json(&mut studio, "mm");
    assert_eq!(studio.state().refusal, Some(RefusalName::Unanchored));
    studio.preview(1.0, 0.0, 0.0).unwrap();
    assert_eq!(mesh_json(&mut studio, "mm"), mesh);
    for pin in [7, 152] {
        studio.select(Some(pin)).unwrap();
        studio.set_pinned(true).unwrap();
    }
    studio.select(Some(NOSE_TIP)).unwrap();
    assert_eq!((studio.state().refusal, studio.state().anchors), (None, vec![7, 152]));
    studio.preview(0.0, 1.0, 0.0).unwrap();
    assert_ne!(mesh_json(&mut studio, "mm"), mesh);
    studio.cancel().unwrap();
    for (edits, why) in [("{}", "bad-history"), (r#"{"rosto":"history","version":99,"entries":[]}"#, "other-version")] {
        assert_eq!(code(&open_work(&mut studio, 0, edits).unwrap_err()), why);
    }
    assert_eq!(code(&studio.choose("density", "4").unwrap_err()), "bad-choice");
    assert_eq!(code(&studio.open_picture(0, 2, None).unwrap_err()), "bad-face");
    for wrong in [7, 12] {
        studio.open_picture(1, 2, None).unwrap();
        assert_eq!(code(&studio.add_picture_rows(&vec![0; wrong]).unwrap_err()), "bad-face", "{wrong} bytes");
    }
    assert_eq!(
        code(&studio.open_face(&[0.4; 1404], 64, 64, &[0; 1404], "parallel").unwrap_err()),
        "bad-face",
        "no picture"
    );
    studio.open_picture(2, 2, None).unwrap();
    studio.add_picture_rows(&[0; 16]).unwrap();
    assert_eq!(
        code(&studio.open_face(&[0.5; 1404], 64, 64, &[0; 1404], "parallel").unwrap_err()),
        "bad-face",
        "one point"
    );
    assert_eq!(studio.state().vertex_count, SMOOTH);
    assert_eq!(mesh_json(&mut studio, "mm"), mesh);
}

#[wasm_bindgen_test]
async fn edits_are_restored_from_text_at_each_density() {
    let mut studio = studio().await;
    studio.choose("density", "0").unwrap();
    studio.set_mirror(true).unwrap();
    studio.select(Some(61)).unwrap();
    studio.preview(2.0, 3.0, 1.0).unwrap();
    studio.commit().unwrap();
    let (edits, mesh) = (studio.edits_json().unwrap(), mesh_json(&mut studio, "mm"));
    open(&mut studio);
    assert_ne!(mesh_json(&mut studio, "mm"), mesh);
    open_work(&mut studio, 0, &edits).unwrap();
    assert_eq!(mesh_json(&mut studio, "mm"), mesh);
    for (density, vertices) in [(1, 468 + 1365), (0, 468)] {
        studio.choose("density", &density.to_string()).unwrap();
        assert_eq!(studio.state().vertex_count, vertices);
        assert!(!pixels(&mut studio).await.is_empty());
    }
    assert_eq!(mesh_json(&mut studio, "mm"), mesh);
    open_work(&mut studio, 1, &edits).unwrap();
    assert_eq!(
        (studio.state().chosen("density").unwrap().as_deref(), studio.state().vertex_count),
        (Some("1"), 468 + 1365)
    );
    studio.choose("density", &0.to_string()).unwrap();
    assert_eq!(mesh_json(&mut studio, "mm"), mesh);
}

#[wasm_bindgen_test]
async fn base_colours_are_exported_as_binary_gltf() {
    let mut studio = studio().await;
    studio.choose("shading", "distortion").unwrap();
    for colour in ["photo", "colours"] {
        let mut choices = StudioFileOptions::new();
        choices.choose("base-colour", colour).unwrap();
        let file = studio.export_file("glb", &choices).unwrap();
        assert_eq!(&file[..4], b"glTF");
        assert_eq!(u32::from_le_bytes(file[8..12].try_into().unwrap()) as usize, file.len());
    }
}

#[wasm_bindgen_test]
async fn a_sliders_commit_matches_its_ticks_on_the_gpu() {
    let mut studio = studio().await;
    for slider in studio.face_sliders() {
        studio.slide(&slider.id, 0.5 * slider.range_mm).unwrap();
        studio.slide(&slider.id, slider.range_mm).unwrap();
        let glowing = pixels(&mut studio).await;
        studio.commit().unwrap();
        let kept = pixels(&mut studio).await;
        let outline = |pixels: &[u8]| pixels.chunks_exact(4).map(|pixel| pixel[3] > 127).collect::<Vec<bool>>();
        let differing = outline(&glowing).iter().zip(outline(&kept)).filter(|(tick, kept)| **tick != *kept).count();
        assert!(differing < 8, "{}: {differing} px", slider.id);
        studio.undo().unwrap();
    }
    assert_eq!(code(&studio.slide("ear-size", 1.0).unwrap_err()), "bad-choice");
    assert_eq!(code(&studio.slide("nose-width", f64::NAN).unwrap_err()), "bad-number");
}

#[wasm_bindgen_test]
async fn a_region_can_be_dragged_by_each_landmark() {
    let mut studio = studio().await;
    studio.set_mirror(false).unwrap();
    studio.select_region("nose").unwrap();
    let from = grab(&mut studio, NOSE_TIP, [12.0, -10.0]);
    let to = studio.screen_position(NOSE_TIP).unwrap();
    assert!((to.x - from.x - 12.0).abs() < 1e-6 && (to.y - from.y + 10.0).abs() < 1e-6, "{to:?}");
    studio.release().unwrap();
    assert_eq!(entries(&studio)[0].target.id, "nose");
    grab(&mut studio, CHIN, [0.0; 2]);
    assert_eq!((studio.state().selected, studio.state().selected_region), (Some(CHIN), None));
    studio.release().unwrap();
    studio.choose("selection", "region").unwrap();
    assert_eq!(studio.state().selected_region.as_deref(), Some("chin"));
    grab(&mut studio, NOSE_TIP, [0.0; 2]);
    studio.release().unwrap();
    assert_eq!(studio.state().selected_region.as_deref(), Some("nose-tip"));
    assert_eq!(entries(&studio).len(), 1);
    assert_eq!(studio.target_at(NOSE_TIP).unwrap().id, "nose-tip");
    assert_eq!(
        (studio.target_at(152).unwrap().kind, studio.target_at(152).unwrap().id),
        ("region".into(), "chin".into())
    );
    studio.select_at(NOSE_TIP).unwrap();
    assert_eq!(studio.state().selected_region.as_deref(), Some("nose"));
    assert_eq!(code(&studio.select_region("ear").unwrap_err()), "bad-choice");
}

#[wasm_bindgen_test]
async fn pinning_applies_to_the_selection_or_the_hovered_vertex() {
    let mut studio = studio().await;
    in_paper_mode(&mut studio);
    studio.select_region("chin").unwrap();
    assert!(!studio.state().pinned);
    studio.set_pinned(true).unwrap();
    assert!(studio.state().pinned);
    let nose = studio.screen_position(NOSE_TIP).unwrap();
    studio.pin_under(nose.x, nose.y).unwrap();
    studio.choose("anchors", "pins").unwrap();
    studio.select(Some(61)).unwrap();
    let state = studio.state();
    assert!(!state.pinned && state.anchors.contains(&152) && state.anchors.contains(&NOSE_TIP));
    studio.pin_under(nose.x, nose.y).unwrap();
    assert!(!studio.state().anchors.contains(&NOSE_TIP));
    assert_eq!(studio.pin_under(1.0, 1.0).unwrap(), ChangeName::Nothing);
}

#[wasm_bindgen_test]
async fn settings_and_view_are_restored_from_text() {
    let mut studio = studio().await;
    studio.choose("preset", "paper").unwrap();
    studio.choose("shading", "clay").unwrap();
    studio.set_radius(33.0).unwrap();
    let (preferences, chosen) = (studio.preferences(), studio.state());
    let mut later = self::studio().await;
    assert_ne!(later.state(), chosen);
    later.restore_preferences(preferences.clone()).unwrap();
    // The open face keeps its density.
    later.choose("density", "0").unwrap();
    assert_eq!(later.state(), chosen);
    assert_eq!(code(&later.restore_preferences(preferences.replace("clay", "mud")).unwrap_err()), "bad-choice");
    assert_eq!(later.state(), chosen);
}
