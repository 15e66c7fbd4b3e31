use rosto_stage::{Background, Light, RenderSettings, ShadingMode, Srgb, Theme};
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::{SIDE_PX, Sheet, assert_close, dome, luminance, picture, plain, screen};

const CENTRE: u32 = SIDE_PX / 2;

#[wasm_bindgen_test]
async fn without_a_mesh_only_the_background_is_drawn() {
    let mut screen = screen().await;
    let empty = picture(&mut screen, plain()).await;
    assert!(empty.rgba.iter().all(|&channel| channel == 0));
    let light = picture(&mut screen, RenderSettings::default()).await;
    assert_close(light.pixel(CENTRE, 0), [0xf5, 0xf3, 0xef]);
    assert_close(light.pixel(CENTRE, SIDE_PX - 1), [0xe7, 0xe3, 0xdb]);
    let dark = picture(&mut screen, RenderSettings { theme: Theme::Dark, ..RenderSettings::default() }).await;
    assert_close(dark.pixel(CENTRE, 0), [0x1c, 0x1d, 0x20]);
}

#[wasm_bindgen_test]
async fn a_plain_background_surrounds_the_mesh() {
    let mut screen = screen().await;
    screen.show(&dome().input());
    let bare = picture(&mut screen, plain()).await;
    let colour = [12, 180, 250];
    let seen = picture(&mut screen, RenderSettings { background: Background::Plain(Srgb(colour)), ..plain() }).await;
    let mut around = 0;
    for (y, x) in (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (y, x))) {
        match bare.pixel(x, y)[3] {
            0 => {
                assert_eq!(seen.pixel(x, y), [12, 180, 250, 255]);
                around += 1;
            }
            255 => assert_eq!(seen.pixel(x, y), bare.pixel(x, y)),
            _ => {}
        }
    }
    assert!(around > 0);
}

#[wasm_bindgen_test]
async fn unlit_vertex_colours_are_reproduced_exactly() {
    let sheet = Sheet::new(1, |_, _| 0.0);
    let mut screen = screen().await;
    for colour in [[200, 120, 40], [3, 250, 9], [128, 128, 128], [255, 255, 255], [0, 0, 0]] {
        screen.show(&MeshInput { colours_srgb: &[colour; 4], ..sheet.input() });
        let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Colours, ..plain() }).await;
        assert_close(seen.pixel(CENTRE, CENTRE), colour);
        assert_eq!(seen.pixel(0, 0), [0; 4]);
    }
}

#[wasm_bindgen_test]
async fn vertex_colours_blend_in_linear_light() {
    let sheet = Sheet::new(1, |_, _| 0.0);
    let mut screen = screen().await;
    let colours = [[0, 0, 0], [255, 255, 255], [0, 0, 0], [255, 255, 255]];
    screen.show(&MeshInput { colours_srgb: &colours, ..sheet.input() });
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Colours, ..plain() }).await;
    let [red, ..] = seen.pixel(CENTRE, CENTRE);
    assert!(red.abs_diff(188) <= 2, "expected 188 for half the light, found {red}");
}

#[wasm_bindgen_test]
async fn the_picture_follows_the_texture_coordinates() {
    let sheet = Sheet::new(1, |_, _| 0.0);
    let mut screen = screen().await;
    let side = 64;
    let quarter =
        |x: usize, y: usize| [40 + 150 * u8::from(x * 2 >= side), 50 + 160 * u8::from(y * 2 >= side), 90, 255];
    let rgba: Vec<u8> = (0..side * side).flat_map(|i| quarter(i % side, i / side)).collect();
    let photo = on_gpu(&screen.viewport, side as u32, &rgba);
    screen.show(&MeshInput { picture: Some(&photo), ..sheet.input() });
    let seen = picture(&mut screen, plain()).await;
    let (near, far) = (CENTRE - 40, CENTRE + 40);
    assert_close(seen.pixel(near, near), [40, 50, 90]);
    assert_close(seen.pixel(far, near), [190, 50, 90]);
    assert_close(seen.pixel(near, far), [40, 210, 90]);
    assert_close(seen.pixel(far, far), [190, 210, 90]);
}

#[wasm_bindgen_test]
async fn minification_averages_in_linear_light() {
    let sheet = Sheet::new(1, |_, _| 0.0);
    let mut screen = screen().await;
    let side = 1024;
    let rgba: Vec<u8> =
        (0..side * side).flat_map(|i| [255 * ((i % side + i / side) % 2) as u8; 3].into_iter().chain([255])).collect();
    let photo = on_gpu(&screen.viewport, side as u32, &rgba);
    screen.show(&MeshInput { picture: Some(&photo), ..sheet.input() });
    let seen = picture(&mut screen, plain()).await;
    for (x, y) in [(CENTRE, CENTRE), (CENTRE + 31, CENTRE - 17), (CENTRE - 40, CENTRE + 8)] {
        let [red, ..] = seen.pixel(x, y);
        assert!(red.abs_diff(188) <= 3, "({x}, {y}) is {red}");
    }
}

#[wasm_bindgen_test]
async fn the_side_towards_the_light_is_brighter() {
    let mut screen = screen().await;
    screen.show(&dome().input());
    let lit = |azimuth_deg| RenderSettings {
        shading: ShadingMode::Clay,
        light: Light { azimuth_deg, ..Light::default() },
        ..plain()
    };
    let (left, right) = (CENTRE - 60, CENTRE + 60);
    let from_left = picture(&mut screen, lit(-60.0)).await;
    assert!(luminance(from_left.pixel(left, CENTRE)) > luminance(from_left.pixel(right, CENTRE)) + 60);
    let from_right = picture(&mut screen, lit(60.0)).await;
    assert!(luminance(from_right.pixel(right, CENTRE)) > luminance(from_right.pixel(left, CENTRE)) + 60);
    let top = luminance(from_left.pixel(CENTRE, CENTRE - 60));
    assert!(top > luminance(from_left.pixel(CENTRE, CENTRE + 60)) + 30, "the default light comes from above");
}

#[wasm_bindgen_test]
async fn coloured_light_tints_the_surface() {
    let mut screen = screen().await;
    screen.show(&dome().input());
    let light =
        Light { colour: Srgb([255, 0, 0]), ambient: 0.0, azimuth_deg: 0.0, elevation_deg: 0.0, ..Light::default() };
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Colours, light, ..plain() }).await;
    let [red, green, blue, _] = seen.pixel(CENTRE, CENTRE);
    assert!(red > 200 && green == 0 && blue == 0, "{red} {green} {blue}");
}

#[wasm_bindgen_test]
async fn normals_are_shown_as_colours() {
    let mut screen = screen().await;
    screen.show(&dome().input());
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Normals, ..plain() }).await;
    assert_close(seen.pixel(CENTRE, CENTRE), [128, 128, 255]);
    assert!(seen.pixel(CENTRE + 60, CENTRE)[0] > 150 && seen.pixel(CENTRE - 60, CENTRE)[0] < 106);
    assert!(seen.pixel(CENTRE, CENTRE - 60)[1] > 150 && seen.pixel(CENTRE, CENTRE + 60)[1] < 106);
}

#[wasm_bindgen_test]
async fn scalars_map_from_blue_to_red() {
    let sheet = Sheet::new(2, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let scalars: Vec<f64> = sheet.positions.iter().map(|position| position.x).collect();
    screen.viewport.set_scalars(&scalars).unwrap();
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Distortion, ..plain() }).await;
    let [red, _, blue, _] = seen.pixel(CENTRE - 60, CENTRE + 10);
    assert!(blue > red + 60, "{red} {blue}");
    let [red, _, blue, _] = seen.pixel(CENTRE + 60, CENTRE + 10);
    assert!(red > blue + 60, "{red} {blue}");
    let [red, green, blue, _] = seen.pixel(CENTRE, CENTRE + 10);
    assert!(red.abs_diff(blue) < 14 && green.abs_diff(red) < 14, "{red} {green} {blue}");
}

#[wasm_bindgen_test]
async fn back_faces_do_not_show_the_picture() {
    let sheet = Sheet::new(1, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&MeshInput { colours_srgb: &[[0, 0, 255]; 4], ..sheet.input() });
    screen.stage.camera_mut().turn(std::f64::consts::PI);
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Colours, ..plain() }).await;
    let [red, _, blue, alpha] = seen.pixel(CENTRE, CENTRE);
    assert!(alpha == 255 && red > blue, "{red} {blue} {alpha}");
}

/// A square picture, written in two parts.
fn on_gpu(viewport: &Viewport, side: u32, rgba: &[u8]) -> PictureOnGpu {
    let photo = viewport.reserve_picture(side, side).unwrap();
    let first_rows = side / 3;
    let (upper, lower) = rgba.split_at((4 * side * first_rows) as usize);
    viewport.write_picture_rows(&photo, 0, upper).unwrap();
    viewport.write_picture_rows(&photo, first_rows, lower).unwrap();
    viewport.finish_picture(&photo);
    photo
}
