use glam::DVec2;
use rosto_stage::{Background, RenderSettings, ShadingMode};
use rosto_viewport::{Target, ViewportError};
use wasm_bindgen::JsCast;
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::support::{SIDE_PX, Sheet, canvas, dome, on, plain, screen};

/// Content of the canvas as the page would copy it; call it in the task that draws.
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
async fn the_canvas_shows_the_drawing_and_can_be_resized() {
    let canvas = canvas();
    let mut screen = on(canvas.clone()).await;
    screen.show(&dome().input());
    *screen.stage.render_settings_mut() = RenderSettings { shading: ShadingMode::Normals, ..RenderSettings::default() };
    assert!(!screen.draw(0.0));
    let pixels = presented(&canvas);
    let centre = 4 * (SIDE_PX / 2 * SIDE_PX + SIDE_PX / 2) as usize;
    assert!(pixels[centre + 2] > 240 && pixels[centre].abs_diff(128) < 4, "{:?}", &pixels[centre..centre + 4]);
    screen.resize(300, 120);
    assert_eq!(screen.stage.camera().size_px(), DVec2::new(300.0, 120.0));
    assert_eq!((canvas.width(), canvas.height()), (300, 120));
    assert!(!screen.draw(16.0));
    let pixels = presented(&canvas);
    let centre = 4 * (60 * 300 + 150);
    assert!(pixels[centre + 2] > 240, "{:?}", &pixels[centre..centre + 4]);
    assert_eq!(&pixels[..3], &[0xf5, 0xf3, 0xef]);
}

#[wasm_bindgen_test]
async fn the_canvas_size_is_limited_by_the_gpu() {
    let canvas = canvas();
    let mut screen = on(canvas.clone()).await;
    let [width, height] = screen.viewport.resize(u32::MAX, 0);
    assert!((2048..100_000).contains(&width), "{width} px");
    assert_eq!((canvas.width(), canvas.height()), (width, height));
    assert_eq!(height, 1);
}

#[wasm_bindgen_test]
async fn a_snapshot_has_the_requested_size_and_a_transparent_background() {
    let mut screen = screen().await;
    screen.show(&Sheet::new(1, |_, _| 0.0).input());
    *screen.stage.render_settings_mut() = plain();
    let still = screen.viewport.snapshot(&screen.stage, [333, 150], Background::Transparent).unwrap().await.unwrap();
    assert_eq!((still.width, still.height, still.rgba.len()), (333, 150, 4 * 333 * 150));
    assert_eq!(still.pixel(2, 75), [0; 4]);
    assert_eq!(still.pixel(166, 75), [255; 4]);
    assert_eq!(screen.stage.camera().size_px(), DVec2::splat(f64::from(SIDE_PX)), "the canvas does not change");
}

#[wasm_bindgen_test]
async fn a_canvas_with_another_context_is_refused() {
    let canvas = canvas();
    canvas.get_context("2d").unwrap().unwrap();
    let refused = Target::canvas(canvas).await;
    assert!(matches!(refused, Err(ViewportError::CanvasInUse(_))), "{refused:?}");
}

#[wasm_bindgen_test]
async fn lists_of_the_wrong_length_are_refused() {
    let sheet = Sheet::new(2, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let refused = screen.viewport.set_positions(&sheet.positions[1..]);
    assert_eq!(refused, Err(ViewportError::LengthMismatch { what: "positions", expected: 9, found: 8 }));
    let refused = screen.viewport.set_fields([None, Some(&[0.0; 3])], None);
    assert_eq!(refused, Err(ViewportError::LengthMismatch { what: "responses", expected: 9, found: 3 }));
}
