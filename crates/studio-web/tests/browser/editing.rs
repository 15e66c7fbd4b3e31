//! Edits and undo.

use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::*;

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
    assert_eq!(after["entryCount"], 1);
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
