use glam::DVec2;
use rosto_viewport::{Background, Look, Paint, Target, ViewportError};
use wasm_bindgen::JsCast;
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::support::{SIDE_PX, Sheet, canvas, dome, on, plain, viewport};

/// What the canvas itself holds, as the page would copy it; to be called in the same task as the drawing.
fn presented(from: &HtmlCanvasElement) -> Vec<u8> {
    let copy = canvas();
    copy.set_width(from.width());
    copy.set_height(from.height());
    let context: CanvasRenderingContext2d = copy.get_context("2d").unwrap().unwrap().unchecked_into();
    context.draw_image_with_html_canvas_element(from, 0.0, 0.0).unwrap();
    let (width, height) = (f64::from(from.width()), f64::from(from.height()));
    context.get_image_data(0.0, 0.0, width, height).unwrap().data().0
}

#[wasm_bindgen_test]
async fn the_canvas_shows_what_was_drawn_and_follows_its_size() {
    let canvas = canvas();
    let mut viewport = on(canvas.clone()).await;
    viewport.show(&dome().input()).unwrap();
    *viewport.stage_mut().look_mut() = Look { paint: Paint::Normals, ..Look::default() };
    assert!(!viewport.draw(0.0).unwrap());
    let pixels = presented(&canvas);
    let middle = 4 * (SIDE_PX / 2 * SIDE_PX + SIDE_PX / 2) as usize;
    assert!(pixels[middle + 2] > 240 && pixels[middle].abs_diff(128) < 4, "{:?}", &pixels[middle..middle + 4]);
    viewport.resize(300, 120);
    assert_eq!((canvas.width(), canvas.height()), (300, 120));
    assert!(!viewport.draw(16.0).unwrap());
    let pixels = presented(&canvas);
    let middle = 4 * (60 * 300 + 150);
    assert!(pixels[middle + 2] > 240, "{:?}", &pixels[middle..middle + 4]);
    assert_eq!(&pixels[..3], &[0xf5, 0xf3, 0xef]);
}

#[wasm_bindgen_test]
async fn a_snapshot_has_any_size_and_is_transparent_around_the_mesh() {
    let mut viewport = viewport().await;
    viewport.show(&Sheet::new(1, |_, _| 0.0).input()).unwrap();
    *viewport.stage_mut().look_mut() = plain();
    let still = viewport.snapshot([333, 150], Background::Transparent).unwrap().await.unwrap();
    assert_eq!((still.width, still.height, still.rgba.len()), (333, 150, 4 * 333 * 150));
    assert_eq!(still.pixel(2, 75), [0; 4]);
    assert_eq!(still.pixel(166, 75), [255; 4]);
    assert_eq!(viewport.stage().camera().size_px(), DVec2::splat(f64::from(SIDE_PX)), "the canvas stays as it is");
}

#[wasm_bindgen_test]
async fn a_click_on_a_vertex_picks_it() {
    let sheet = dome();
    let mut viewport = viewport().await;
    viewport.show(&sheet.input()).unwrap();
    viewport.stage_mut().camera_mut().orbit(30.0, -20.0);
    viewport.draw(0.0).unwrap();
    for vertex in [0_usize, 144, 150, 200] {
        let towards_middle = sheet.positions[vertex].lerp(sheet.positions[144], 0.02);
        let place = viewport.stage().camera().project(towards_middle).unwrap();
        assert_eq!(viewport.pick(place, &sheet.positions), Some(vertex as u32));
    }
    assert_eq!(viewport.pick(DVec2::new(1.0, 1.0), &sheet.positions), None);
}

#[wasm_bindgen_test]
async fn a_canvas_that_has_another_context_is_refused() {
    let canvas = canvas();
    canvas.get_context("2d").unwrap().unwrap();
    let refused = Target::canvas(canvas).await;
    assert!(matches!(refused, Err(ViewportError::CanvasInUse(_))), "{refused:?}");
}

#[wasm_bindgen_test]
async fn lists_of_the_wrong_length_are_refused() {
    let sheet = Sheet::new(2, |_, _| 0.0);
    let mut viewport = viewport().await;
    viewport.show(&sheet.input()).unwrap();
    let refused = viewport.set_positions(&sheet.positions[1..]);
    assert_eq!(refused, Err(ViewportError::LengthMismatch { what: "positions", expected: 9, found: 8 }));
    let refused = viewport.set_fields([None, Some(&[0.0; 3])]);
    assert_eq!(refused, Err(ViewportError::LengthMismatch { what: "responses", expected: 9, found: 3 }));
}
