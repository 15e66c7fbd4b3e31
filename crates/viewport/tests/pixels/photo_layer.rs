use glam::{DAffine3, DVec2, DVec3};
use rosto_stage::{PicturePlane, Pinhole, RenderSettings, Scene, Visibility};
use rosto_viewport::{PhotoLayerInput, PictureOnGpu};
use wasm_bindgen_test::wasm_bindgen_test;

use crate::support::{SIDE_PX, Screen, assert_close, dome, largest_difference, picture, plain, screen};

/// Side of the picture in px.
const PICTURE_PX: u32 = 60;
const RED: [u8; 3] = [200, 30, 20];
const BLUE: [u8; 3] = [20, 40, 180];

/// Red in the left half, blue in the right half.
fn halves(screen: &Screen) -> PictureOnGpu {
    let picture = screen.viewport.reserve_picture(PICTURE_PX, PICTURE_PX).unwrap();
    let row = (0..PICTURE_PX).flat_map(|x| {
        let [r, g, b] = if x < PICTURE_PX / 2 { RED } else { BLUE };
        [r, g, b, 255]
    });
    let rgba: Vec<u8> = row.collect::<Vec<u8>>().repeat(PICTURE_PX as usize);
    screen.viewport.write_picture_rows(&picture, 0, &rgba).unwrap();
    screen.viewport.finish_picture(&picture);
    picture
}

/// A square picture around the origin with this half side.
fn plane(half_m: f64) -> PicturePlane {
    let per_px = 2.0 * half_m / f64::from(PICTURE_PX);
    PicturePlane {
        origin_m: DVec3::new(-half_m, half_m, 0.0),
        right_m: DVec3::new(per_px, 0.0, 0.0),
        down_m: DVec3::new(0.0, -per_px, 0.0),
        size_px: DVec2::splat(f64::from(PICTURE_PX)),
    }
}

/// A dome in front of its picture, whose middle column of points moves.
async fn with_photo_layer() -> Screen {
    let mut screen = screen().await;
    screen.show(&dome().input());
    screen.stage.set_picture(Some(plane(1.0)));
    screen.stage.show(Scene::Picture);
    screen.stage.settle_picture();
    screen.stage.advance(0.0);
    let picture = halves(&screen);
    screen.viewport.show_photo_layer(Some(&PhotoLayerInput {
        size_px: DVec2::splat(f64::from(PICTURE_PX)),
        from_px: &positions(30.0),
        triangles: &[[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]],
        picture: &picture,
    }));
    screen
}

/// Two rows of three points: left edge, column, right edge.
fn positions(column: f64) -> Vec<DVec2> {
    [0.0, f64::from(PICTURE_PX)].iter().flat_map(|&y| [0.0, column, 60.0].map(|x| DVec2::new(x, y))).collect()
}

#[wasm_bindgen_test]
async fn the_picture_is_drawn_on_its_plane_and_hides_the_mesh() {
    let mut screen = with_photo_layer().await;
    let seen = picture(&mut screen, plain()).await;
    for y in [10, SIDE_PX / 2, SIDE_PX - 10] {
        assert_close(seen.pixel(SIDE_PX / 4, y), RED);
        assert_close(seen.pixel(3 * SIDE_PX / 4, y), BLUE);
    }
}

#[wasm_bindgen_test]
async fn the_picture_follows_its_points_and_before_restores_it() {
    let mut screen = with_photo_layer().await;
    let still = picture(&mut screen, plain()).await;
    screen.viewport.move_photo_layer(&positions(45.0)).unwrap();
    let moved = picture(&mut screen, plain()).await;
    let right_of_centre = SIDE_PX * 5 / 8;
    assert_close(still.pixel(right_of_centre, SIDE_PX / 2), BLUE);
    assert_close(moved.pixel(right_of_centre, SIDE_PX / 2), RED);
    let before = picture(&mut screen, RenderSettings { before: 1.0, ..plain() }).await;
    assert_eq!(largest_difference(&still, &before), 0);
    assert!(screen.viewport.move_photo_layer(&[]).is_err(), "wrong number of points");
}

#[wasm_bindgen_test]
async fn behind_the_mesh_the_picture_is_dimmed_evenly() {
    let mut screen = with_photo_layer().await;
    screen.viewport.show_photo_layer(Some(&PhotoLayerInput {
        size_px: DVec2::splat(f64::from(PICTURE_PX)),
        from_px: &[DVec2::ZERO, DVec2::new(60.0, 0.0), DVec2::new(60.0, 30.0), DVec2::new(0.0, 30.0)],
        triangles: &[[0, 1, 2], [0, 2, 3]],
        picture: &halves(&screen),
    }));
    let camera_from_model = DAffine3::from_translation(DVec3::new(0.0, 0.0, -10.0));
    screen.stage.camera_mut().set_pinhole(Some(Pinhole { camera_from_model }));
    screen.stage.set_picture(Some(plane(2.0)));
    screen.stage.show(Scene::Solid);
    screen.stage.set_backdrop(Visibility::Shown);
    screen.stage.settle_picture();
    screen.stage.advance(16.0);
    let seen = picture(&mut screen, plain()).await;
    let (moving, still) = (seen.pixel(2, 2), seen.pixel(2, SIDE_PX - 3));
    assert_eq!(moving, still, "the moving part hides the whole picture");
    assert!((60..200).contains(&moving[3]), "the picture is dimmed: {moving:?}");
    assert_eq!(seen.pixel(SIDE_PX / 2, SIDE_PX / 2)[3], 255, "the mesh is in front of it");
}

#[wasm_bindgen_test]
async fn the_picture_is_transparent_where_its_pixels_are() {
    let mut screen = with_photo_layer().await;
    let picture_on_gpu = screen.viewport.reserve_picture(PICTURE_PX, PICTURE_PX).unwrap();
    screen.viewport.write_picture_rows(&picture_on_gpu, 0, &[0; 4 * (PICTURE_PX * PICTURE_PX) as usize]).unwrap();
    screen.viewport.finish_picture(&picture_on_gpu);
    screen.viewport.show_photo_layer(Some(&PhotoLayerInput {
        size_px: DVec2::splat(f64::from(PICTURE_PX)),
        from_px: &[],
        triangles: &[],
        picture: &picture_on_gpu,
    }));
    let seen = picture(&mut screen, plain()).await;
    assert_eq!(seen.pixel(1, 1), [0; 4]);
}

#[wasm_bindgen_test]
async fn the_solid_scene_hides_the_picture() {
    let mut screen = with_photo_layer().await;
    screen.stage.show(Scene::Solid);
    screen.stage.settle_picture();
    screen.stage.advance(16.0);
    let seen = picture(&mut screen, plain()).await;
    assert_eq!(seen.pixel(1, 1), [0; 4]);
    assert_eq!(seen.pixel(SIDE_PX / 2, SIDE_PX / 2)[3], 255, "the mesh is visible");
}
