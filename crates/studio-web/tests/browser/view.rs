//! The drawn canvas.

use rosto_studio::FaceSlider;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::*;

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
    assert_eq!(catalogue()["landmarks"][NOSE_TIP as usize], "nose-tip");
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
async fn a_sliders_commit_matches_its_ticks_on_the_gpu() {
    let mut studio = studio().await;
    for slider in FaceSlider::ALL {
        let (id, max_mm) = (slider.id(), 1e3 * slider.range_m());
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
