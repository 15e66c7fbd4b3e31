use glam::DVec3;
use rosto_stage::{Axis, Dots, Mark, MarkKind, Pointer, RenderSettings, ShadingMode, Srgb, Visibility};
use rosto_viewport::Snapshot;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::{SIDE_PX, Sheet, luminance, picture, plain, screen};

const ACCENT: [u8; 3] = [0xb8, 0x49, 0x2f];

fn clay() -> RenderSettings {
    RenderSettings { shading: ShadingMode::Clay, ..plain() }
}

/// Number of pixels within `radius_px` of a position that nearly have this colour.
fn count_near(seen: &Snapshot, x: u32, y: u32, radius_px: u32, colour: [u8; 3]) -> usize {
    let around = |at: u32| at.saturating_sub(radius_px)..(at + radius_px).min(SIDE_PX);
    let is_near = |pixel: [u8; 4]| pixel.iter().zip(colour).all(|(found, expected)| found.abs_diff(expected) < 12);
    around(y).flat_map(|y| around(x).map(move |x| (x, y))).filter(|&(x, y)| is_near(seen.pixel(x, y))).count()
}

#[wasm_bindgen_test]
async fn a_selected_vertex_has_a_ring_in_the_accent_colour() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let vertex = 4 * 9 + 4;
    screen.stage.set_marks(vec![Mark { vertex, kind: MarkKind::Ring }]);
    let seen = picture(&mut screen, clay()).await;
    let centre = SIDE_PX / 2;
    let ring = count_near(&seen, centre, centre, 12, ACCENT);
    assert!((60..200).contains(&ring), "{ring} px");
    assert_eq!(count_near(&seen, centre, centre, 4, ACCENT), 0, "the vertex itself remains visible");
    assert_eq!(count_near(&seen, centre - 50, centre, 20, ACCENT), 0);
    screen.stage.set_marks(Vec::new());
    let without = picture(&mut screen, clay()).await;
    assert_eq!(count_near(&without, centre, centre, 12, ACCENT), 0);
}

#[wasm_bindgen_test]
async fn marks_follow_their_vertex_and_grow_with_the_pixel_ratio() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let vertex = 4 * 9 + 4;
    screen.stage.set_marks(vec![Mark { vertex, kind: MarkKind::Dot }]);
    let field: Vec<f64> = sheet.positions.iter().map(|p| f64::from(u8::from(p.truncate().length() < 0.1))).collect();
    screen.viewport.set_fields([Some(&field), None], None).unwrap();
    let offset = DVec3::new(0.6, 0.0, 0.0);
    screen.stage.set_offsets_m([offset, DVec3::ZERO]);
    let position = screen.stage.camera().project(offset).unwrap();
    let seen = picture(&mut screen, clay()).await;
    let once = count_near(&seen, position.x as u32, position.y as u32, 14, ACCENT);
    assert!(once > 20, "{once} px");
    screen.stage.set_pixel_ratio(2.0);
    let seen = picture(&mut screen, clay()).await;
    let twice = count_near(&seen, position.x as u32, position.y as u32, 14, ACCENT);
    assert!(twice > 3 * once, "{once} and {twice} px");
}

#[wasm_bindgen_test]
async fn occluded_marks_are_faint() {
    let behind = Sheet::new(8, |x, _| if x > 0.3 { 0.8 } else { 0.0 });
    let mut screen = screen().await;
    screen.show(&behind.input());
    screen.stage.camera_mut().orbit(80.0, 0.0);
    screen.draw(0.0);
    let vertex = 4 * 9 + 3;
    let marked = |kind| vec![Mark { vertex, kind }];
    let position = screen.stage.camera().project(behind.positions[vertex as usize]).unwrap();
    screen.stage.set_marks(marked(MarkKind::Dot));
    let seen = picture(&mut screen, clay()).await;
    let full = count_near(&seen, position.x as u32, position.y as u32, 8, ACCENT);
    screen.stage.camera_mut().orbit(-160.0, 0.0);
    screen.draw(0.0);
    let position = screen.stage.camera().project(behind.positions[vertex as usize]).unwrap();
    let seen = picture(&mut screen, clay()).await;
    let hidden = count_near(&seen, position.x as u32, position.y as u32, 8, ACCENT);
    assert!(full > 20 && hidden == 0, "{full} and {hidden} px");
}

#[wasm_bindgen_test]
async fn the_wireframe_darkens_edges_moderately() {
    let sheet = Sheet::new(4, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let bare = picture(&mut screen, clay()).await;
    let wired = picture(&mut screen, RenderSettings { wireframe: Visibility::Shown, ..clay() }).await;
    let centre = SIDE_PX / 2;
    let row = centre - 12;
    let fills = luminance(bare.pixel(centre, row));
    let darkest = (centre - 20..centre + 20).map(|x| luminance(wired.pixel(x, row))).min().unwrap();
    assert!(darkest < fills - 40 && darkest > fills / 2, "{fills} and {darkest}");
    assert_eq!(wired.pixel(centre - 20, row), bare.pixel(centre - 20, row), "faces do not change");
}

#[wasm_bindgen_test]
async fn dots_show_near_the_pointer_or_everywhere() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let bare = picture(&mut screen, clay()).await;
    screen.stage.set_pointer(Some(glam::DVec2::new(60.0, 120.0)));
    let near = picture(&mut screen, RenderSettings { dots: Dots::NearPointer, ..clay() }).await;
    let all = picture(&mut screen, RenderSettings { dots: Dots::All, ..clay() }).await;
    let changed = |seen: &Snapshot, columns: std::ops::Range<u32>| {
        let positions = columns.flat_map(|x| (0..SIDE_PX).map(move |y| (x, y)));
        positions.filter(|&(x, y)| seen.pixel(x, y) != bare.pixel(x, y)).count()
    };
    assert!(changed(&near, 0..110) > 50);
    assert_eq!(changed(&near, 160..SIDE_PX), 0);
    assert!(changed(&all, 160..SIDE_PX) > 50);
}

#[wasm_bindgen_test]
async fn the_gizmos_arms_are_drawn_where_they_are_picked() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let vertex = 4 * 9 + 4;
    screen.stage.set_gizmo(Some(vertex));
    let seen = picture(&mut screen, clay()).await;
    let centre = SIDE_PX / 2;
    let [red, _, blue, _] = seen.pixel(centre + 40, centre);
    assert!(red > blue + 80, "x is red: {red} {blue}");
    let [red, green, ..] = seen.pixel(centre, centre - 40);
    assert!(green > red + 40, "y is green: {red} {green}");
    let pick = |x: u32, y: u32| {
        screen.stage.pick_axis(glam::DVec2::new(f64::from(x), f64::from(y)), &sheet.positions, Pointer::Fine)
    };
    assert_eq!(pick(centre + 40, centre), Some(Axis::X));
    assert_eq!(pick(centre, centre - 40), Some(Axis::Y));
    assert_eq!(pick(centre - 60, centre - 60), None);
}

#[wasm_bindgen_test]
async fn the_mirror_plane_is_a_thin_line_on_the_surface() {
    let mut screen = screen().await;
    screen.show(&Sheet::new(1, |_, _| 0.0).input());
    let without = picture(&mut screen, clay()).await;
    let with = picture(&mut screen, RenderSettings { mirror_plane: Visibility::Shown, ..clay() }).await;
    let centre = SIDE_PX / 2;
    for (x, y) in (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (x, y))) {
        let is_on_line = x.abs_diff(centre) <= 1;
        assert!(is_on_line || with.pixel(x, y) == without.pixel(x, y), "{x}, {y}");
    }
    let [red, ..] = Srgb(ACCENT).0;
    let on_line = (centre - 1..=centre)
        .any(|x| with.pixel(x, centre)[0].abs_diff(red) < 40 && with.pixel(x, centre) != without.pixel(x, centre));
    assert!(on_line, "no line at x = 0");
    assert_eq!(with.pixel(centre, 0), without.pixel(centre, 0), "no line outside the surface");
}
