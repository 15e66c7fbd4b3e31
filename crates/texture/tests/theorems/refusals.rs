use glam::{DVec2, DVec3};
use rosto_texture::{MAX_SHOTS, Shot, TextureError, texture};

use crate::scenes::*;

#[test]
fn sides_and_numbers_of_photos_are_validated() {
    let sheet = Sheet::bent(0.2);
    let (view, photo) = (sheet.seen(0.0), painted(waves));
    let made = |count: usize, side_px: u32| texture(&sheet.subject(), &vec![view.shot(&photo); count], side_px);
    for side_px in [0, 128, 1000, 8192] {
        assert_eq!(made(1, side_px), Err(TextureError::Side { side_px }));
    }
    for found in [0, MAX_SHOTS + 1] {
        assert_eq!(made(found, 256), Err(TextureError::ShotCount { found }));
    }
    assert!(made(MAX_SHOTS, 256).is_ok());
    let message = made(1, 1000).unwrap_err().to_string();
    assert_eq!(message, "a texture's side must be a power of two from 256 to 4096 px; got 1000");
}

#[test]
fn inconsistent_inputs_are_refused() {
    let (photo, expected) = (painted(waves), Sheet::bent(0.2).positions.len());
    let refused = |change: fn(&mut Sheet, &mut View)| {
        let mut sheet = Sheet::bent(0.2);
        let mut view = sheet.seen(0.0);
        change(&mut sheet, &mut view);
        texture(&sheet.subject(), &[Shot { picture: &photo, ..view.shot(&photo) }], 256).unwrap_err()
    };
    let wrong = |what| TextureError::WrongLength { what, expected, found: expected - 1 };
    assert_eq!(refused(|sheet, _| sheet.positions.truncate(sheet.positions.len() - 1)), wrong("positions"));
    assert_eq!(refused(|sheet, _| sheet.atlas_uvs.truncate(sheet.atlas_uvs.len() - 1)), wrong("texture coordinates"));
    assert_eq!(refused(|sheet, _| sheet.partners.truncate(sheet.partners.len() - 1)), wrong("partners"));
    assert_eq!(refused(|_, view| view.uvs.truncate(view.uvs.len() - 1)), wrong("positions in a photo"));
    let vertex_count = expected;
    let outside = |what| TextureError::VertexOutOfRange { what, vertex: 9999, vertex_count };
    assert_eq!(refused(|sheet, _| sheet.partners[3] = 9999), outside("partners"));
    assert_eq!(refused(|sheet, _| sheet.features = vec![vec![1, 9999]]), outside("features"));
    let not_finite = |what| TextureError::NotFinite { what, vertex: 5 };
    assert_eq!(refused(|sheet, _| sheet.positions[5] = DVec3::INFINITY), not_finite("positions"));
    assert_eq!(refused(|_, view| view.uvs[5] = DVec2::NAN), not_finite("positions in a photo"));
    assert_eq!(refused(|sheet, _| sheet.atlas_uvs.fill(DVec2::ZERO)), TextureError::NoArea);
    assert_eq!(
        refused(|_, view| view.uvs.iter_mut().for_each(|uv| *uv += 3.0)),
        TextureError::NothingSeen { shots: 1 }
    );
}
