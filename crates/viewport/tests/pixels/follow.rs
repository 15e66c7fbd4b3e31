use glam::DVec3;
use rosto_stage::{Light, RenderSettings, ShadingMode, Visibility};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::{SIDE_PX, Sheet, dome, largest_difference, picture, plain, screen};

fn shaded() -> RenderSettings {
    RenderSettings { shading: ShadingMode::Clay, light: Light::default(), ..plain() }
}

/// A bump with height 1 at its centre.
fn bump(sheet: &Sheet, x: f64, y: f64) -> Vec<f64> {
    let at = DVec3::new(x, y, 0.0);
    sheet.positions.iter().map(|p| (-4.0 * (*p - at).truncate().length_squared()).exp()).collect()
}

#[wasm_bindgen_test]
async fn response_fields_look_like_uploaded_positions() {
    let sheet = dome();
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let rest = picture(&mut screen, shaded()).await;
    let (left, right) = (bump(&sheet, -0.4, 0.2), bump(&sheet, 0.5, -0.1));
    let offsets = [DVec3::new(0.2, 0.1, 0.5), DVec3::new(-0.2, 0.1, 0.4)];
    screen.viewport.set_fields([Some(&left), Some(&right)], None).unwrap();
    screen.stage.set_offsets_m(offsets);
    let followed = picture(&mut screen, shaded()).await;
    let moved: Vec<DVec3> = sheet
        .positions
        .iter()
        .zip(left.iter().zip(&right))
        .map(|(position, (a, b))| *position + offsets[0] * *a + offsets[1] * *b)
        .collect();
    screen.stage.set_offsets_m([DVec3::ZERO; 2]);
    screen.viewport.set_positions(&moved).unwrap();
    let uploaded = picture(&mut screen, shaded()).await;
    assert!(largest_difference(&rest, &uploaded) > 40, "the edit is visible");
    let off = followed.rgba.iter().zip(&uploaded.rgba).filter(|(one, other)| one.abs_diff(**other) > 2).count();
    assert!(off <= 16, "{off} channels differ");
}

#[wasm_bindgen_test]
async fn before_shows_the_original_shape() {
    let sheet = dome();
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let rest = picture(&mut screen, shaded()).await;
    let moved: Vec<DVec3> = sheet.positions.iter().map(|p| *p + DVec3::Z * p.x * 0.4).collect();
    screen.viewport.set_positions(&moved).unwrap();
    let edited = picture(&mut screen, shaded()).await;
    assert!(largest_difference(&rest, &edited) > 40);
    let before = picture(&mut screen, RenderSettings { before: 1.0, ..shaded() }).await;
    assert!(largest_difference(&rest, &before) <= 1);
}

/// Whether two colours look alike on any background, up to rounding.
fn is_about(one: [u8; 4], other: [u8; 4]) -> bool {
    let weight = |[red, green, blue, alpha]: [u8; 4]| {
        [red, green, blue]
            .map(|channel| i32::from(channel) * i32::from(alpha) / 255)
            .into_iter()
            .chain([i32::from(alpha)])
    };
    weight(one).zip(weight(other)).all(|(one, other)| one.abs_diff(other) <= 3)
}

#[wasm_bindgen_test]
async fn the_comparison_slider_shows_both_shapes() {
    let sheet = dome();
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let moved: Vec<DVec3> = sheet.positions.iter().map(|p| *p + DVec3::Z * p.x * 0.4).collect();
    screen.viewport.set_positions(&moved).unwrap();
    let now = picture(&mut screen, shaded()).await;
    let before = picture(&mut screen, RenderSettings { before: 1.0, ..shaded() }).await;
    for share in [0.0, 0.3, 0.5, 1.0] {
        let both = picture(&mut screen, RenderSettings { wipe: Some(share), ..shaded() }).await;
        let edge = (share * f64::from(SIDE_PX)).round() as u32;
        let positions = (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (x, y)));
        let expected = |x: u32, y: u32| if x < edge { before.pixel(x, y) } else { now.pixel(x, y) };
        // Antialiasing of outlines can differ between the two drawings.
        let off = positions.filter(|&(x, y)| !is_about(both.pixel(x, y), expected(x, y))).count();
        assert!(off <= 24, "{off} pixels differ at {share}");
    }
    let apart = before.rgba.iter().zip(&now.rgba).filter(|(one, other)| one.abs_diff(**other) > 8).count();
    assert!(apart > 4_000, "the shapes differ too little: {apart}");
}

#[wasm_bindgen_test]
async fn the_rim_is_a_line_at_the_influence_radius() {
    let sheet = Sheet::new(32, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let influence_distances: Vec<f64> = sheet.positions.iter().map(|p| p.truncate().length() / 0.5).collect();
    screen.viewport.set_fields([None, None], Some(&influence_distances)).unwrap();
    let without = picture(&mut screen, shaded()).await;
    let with = picture(&mut screen, RenderSettings { rim: Visibility::Shown, ..shaded() }).await;
    let differs = |x: u32, y: u32| with.pixel(x, y) != without.pixel(x, y);
    let m_per_px = screen.stage.camera().m_per_px_at(DVec3::ZERO);
    let centre = f64::from(SIDE_PX) / 2.0;
    for (x, y) in (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (x, y))) {
        let away_m = ((f64::from(x) + 0.5 - centre).hypot(f64::from(y) + 0.5 - centre)) * m_per_px;
        let off_px = (away_m - 0.5).abs() / m_per_px;
        assert!(off_px < 4.0 || !differs(x, y), "{off_px} px from the rim at {x}, {y}");
        assert!(off_px > 0.4 || differs(x, y), "{off_px} px from the rim at {x}, {y}");
    }
}

#[wasm_bindgen_test]
async fn the_response_is_coloured_where_the_mesh_follows() {
    let sheet = dome();
    let mut screen = screen().await;
    screen.show(&sheet.input());
    screen.viewport.set_fields([Some(&bump(&sheet, -0.5, 0.0)), None], None).unwrap();
    let seen = picture(&mut screen, RenderSettings { shading: ShadingMode::Response, ..plain() }).await;
    let redness = |x: u32| i32::from(seen.pixel(x, 120)[0]) - i32::from(seen.pixel(x, 120)[2]);
    assert!(redness(75) > redness(190) + 60, "{} and {}", redness(75), redness(190));
}
