//! Pointer, selection and pins.

use rosto_studio_web::Studio;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::*;

#[wasm_bindgen_test]
async fn a_dragged_landmark_follows_the_pointer() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "expert": true }));
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
async fn a_region_can_be_dragged_by_each_landmark() {
    let mut studio = studio().await;
    apply(&mut studio, json!({ "mirror": false }));
    apply(&mut studio, json!({ "select": { "region": "nose" } }));
    let from = grab(&mut studio, NOSE_TIP, [4.0, -3.0]);
    let to = place(&studio, NOSE_TIP);
    assert!((to[0] - from[0] - 4.0).abs() < 1e-6 && (to[1] - from[1] + 3.0).abs() < 1e-6, "{to:?}");
    apply(&mut studio, json!("release"));
    assert_eq!(state(&studio)["name"]["key"], "region.nose");
    grab(&mut studio, CHIN, [0.0; 2]);
    let now = state(&studio);
    assert_eq!((&now["selected"], &now["name"]["key"]), (&json!(CHIN), &json!("landmark.middle-of-the-chin")));
    apply(&mut studio, json!("release"));
    apply(&mut studio, json!({ "selection": "region" }));
    assert_eq!(state(&studio)["name"]["key"], "region.chin");
    grab(&mut studio, NOSE_TIP, [0.0; 2]);
    apply(&mut studio, json!("release"));
    assert_eq!(state(&studio)["name"]["key"], "region.nose-tip");
    assert_eq!(state(&studio)["entryCount"], 1);
    for (vertex, id) in [(NOSE_TIP, "nose-tip"), (152, "chin")] {
        let pointed = apply(&mut studio, json!({ "point-at": vertex }));
        assert_eq!(pointed["hoveredName"]["key"], format!("region.{id}"));
    }
    apply(&mut studio, json!({ "select-at": NOSE_TIP }));
    assert_eq!(state(&studio)["name"]["key"], "region.nose");
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
    assert_eq!(state(&studio)["isPinned"], false);
    assert!(is_anchor(&studio, 152) && is_anchor(&studio, NOSE_TIP), "{}", state(&studio)["anchors"]);
    apply(&mut studio, json!({ "pin-under": nose }));
    assert!(!is_anchor(&studio, NOSE_TIP));
    assert_eq!(apply(&mut studio, json!({ "pin-under": [1, 1] }))["changed"], "nothing");
}
