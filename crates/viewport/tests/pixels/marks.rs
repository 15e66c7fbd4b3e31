use glam::DVec3;
use rosto_stage::{Axis, Dots, Mark, MarkKind, Pointer, RenderSettings, ShadingMode, Srgb, Visibility};
use rosto_viewport::Snapshot;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::{SIDE_PX, Sheet, luminance, picture, plain, screen};

const ACCENT: [u8; 3] = [0xb8, 0x49, 0x2f];

fn clay() -> RenderSettings {
    RenderSettings { shading: ShadingMode::Clay, ..plain() }
}

/// How many pixels within `reach_px` of a place have nearly this colour.
fn count_near(seen: &Snapshot, x: u32, y: u32, reach_px: u32, colour: [u8; 3]) -> usize {
    let around = |at: u32| at.saturating_sub(reach_px)..(at + reach_px).min(SIDE_PX);
    let is_near = |pixel: [u8; 4]| pixel.iter().zip(colour).all(|(found, wanted)| found.abs_diff(wanted) < 12);
    around(y).flat_map(|y| around(x).map(move |x| (x, y))).filter(|&(x, y)| is_near(seen.pixel(x, y))).count()
}

#[wasm_bindgen_test]
async fn a_selected_vertex_wears_a_ring_in_the_accent() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let vertex = 4 * 9 + 4;
    screen.stage.set_marks(vec![Mark { vertex, kind: MarkKind::Ring }]);
    let seen = picture(&mut screen, clay()).await;
    let middle = SIDE_PX / 2;
    let ring = count_near(&seen, middle, middle, 12, ACCENT);
    assert!((60..200).contains(&ring), "{ring} px");
    assert_eq!(count_near(&seen, middle, middle, 4, ACCENT), 0, "the vertex itself stays to be seen");
    assert_eq!(count_near(&seen, middle - 50, middle, 20, ACCENT), 0);
    screen.stage.set_marks(Vec::new());
    let without = picture(&mut screen, clay()).await;
    assert_eq!(count_near(&without, middle, middle, 12, ACCENT), 0);
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
    let place = screen.stage.camera().project(offset).unwrap();
    let seen = picture(&mut screen, clay()).await;
    let once = count_near(&seen, place.x as u32, place.y as u32, 14, ACCENT);
    assert!(once > 20, "{once} px");
    screen.stage.set_pixel_ratio(2.0);
    let seen = picture(&mut screen, clay()).await;
    let twice = count_near(&seen, place.x as u32, place.y as u32, 14, ACCENT);
    assert!(twice > 3 * once, "{once} and {twice} px");
}

#[wasm_bindgen_test]
async fn what_is_hidden_shows_only_faintly() {
    let behind = Sheet::new(8, |x, _| if x > 0.3 { 0.8 } else { 0.0 });
    let mut screen = screen().await;
    screen.show(&behind.input());
    screen.stage.camera_mut().orbit(80.0, 0.0);
    screen.draw(0.0);
    let vertex = 4 * 9 + 3;
    let marked = |kind| vec![Mark { vertex, kind }];
    let place = screen.stage.camera().project(behind.positions[vertex as usize]).unwrap();
    screen.stage.set_marks(marked(MarkKind::Dot));
    let seen = picture(&mut screen, clay()).await;
    let full = count_near(&seen, place.x as u32, place.y as u32, 8, ACCENT);
    screen.stage.camera_mut().orbit(-160.0, 0.0);
    screen.draw(0.0);
    let place = screen.stage.camera().project(behind.positions[vertex as usize]).unwrap();
    let seen = picture(&mut screen, clay()).await;
    let hidden = count_near(&seen, place.x as u32, place.y as u32, 8, ACCENT);
    assert!(full > 20 && hidden == 0, "{full} and {hidden} px");
}

#[wasm_bindgen_test]
async fn the_wireframe_darkens_edges_by_less_than_half() {
    let sheet = Sheet::new(4, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let bare = picture(&mut screen, clay()).await;
    let wired = picture(&mut screen, RenderSettings { wireframe: Visibility::Shown, ..clay() }).await;
    let middle = SIDE_PX / 2;
    let row = middle - 12;
    let fills = luminance(bare.pixel(middle, row));
    let darkest = (middle - 20..middle + 20).map(|x| luminance(wired.pixel(x, row))).min().unwrap();
    assert!(darkest < fills - 40 && darkest > fills / 2, "{fills} and {darkest}");
    assert_eq!(wired.pixel(middle - 20, row), bare.pixel(middle - 20, row), "faces stay as they are");
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
        let places = columns.flat_map(|x| (0..SIDE_PX).map(move |y| (x, y)));
        places.filter(|&(x, y)| seen.pixel(x, y) != bare.pixel(x, y)).count()
    };
    assert!(changed(&near, 0..110) > 50);
    assert_eq!(changed(&near, 160..SIDE_PX), 0);
    assert!(changed(&all, 160..SIDE_PX) > 50);
}

#[wasm_bindgen_test]
async fn the_gizmo_has_an_arm_for_each_axis_where_it_can_be_picked() {
    let sheet = Sheet::new(8, |_, _| 0.0);
    let mut screen = screen().await;
    screen.show(&sheet.input());
    let vertex = 4 * 9 + 4;
    screen.stage.set_gizmo(Some(vertex));
    let seen = picture(&mut screen, clay()).await;
    let middle = SIDE_PX / 2;
    let [red, _, blue, _] = seen.pixel(middle + 40, middle);
    assert!(red > blue + 80, "x is red: {red} {blue}");
    let [red, green, ..] = seen.pixel(middle, middle - 40);
    assert!(green > red + 40, "y is green: {red} {green}");
    let pick = |x: u32, y: u32| {
        screen.stage.pick_axis(glam::DVec2::new(f64::from(x), f64::from(y)), &sheet.positions, Pointer::Fine)
    };
    assert_eq!(pick(middle + 40, middle), Some(Axis::X));
    assert_eq!(pick(middle, middle - 40), Some(Axis::Y));
    assert_eq!(pick(middle - 60, middle - 60), None);
}

#[wasm_bindgen_test]
async fn the_mirror_plane_is_a_hairline_where_it_cuts_the_surface() {
    let mut screen = screen().await;
    screen.show(&Sheet::new(1, |_, _| 0.0).input());
    let without = picture(&mut screen, clay()).await;
    let with = picture(&mut screen, RenderSettings { mirror_plane: Visibility::Shown, ..clay() }).await;
    let middle = SIDE_PX / 2;
    for (x, y) in (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (x, y))) {
        let is_on_line = x.abs_diff(middle) <= 1;
        assert!(is_on_line || with.pixel(x, y) == without.pixel(x, y), "{x}, {y}");
    }
    let [red, ..] = Srgb(ACCENT).0;
    let on_line = (middle - 1..=middle)
        .any(|x| with.pixel(x, middle)[0].abs_diff(red) < 40 && with.pixel(x, middle) != without.pixel(x, middle));
    assert!(on_line, "no line at x = 0");
    assert_eq!(with.pixel(middle, 0), without.pixel(middle, 0), "beside the surface there is none");
}
