use glam::DVec2;
use rosto_photo::Photo;
use rosto_texture::{Eye, Texture};

use crate::scenes::*;

fn mirrored(photo: &Photo) -> Photo {
    let rows = photo.pixels().chunks(3 * photo.width() as usize);
    let pixels = rows.flat_map(|row| row.as_chunks::<3>().0.iter().rev().flatten().copied()).collect();
    Photo::from_rgb(photo.width(), photo.height(), pixels).unwrap()
}

/// The mirror image of a view of a symmetric sheet.
fn mirrored_view(sheet: &Sheet, view: &View) -> View {
    let image = |partner: &u32| DVec2::new(1.0, 0.0) + DVec2::new(-1.0, 1.0) * view.uvs[*partner as usize];
    let Eye::Towards(eye) = view.eye else { panic!("expected a distant camera") };
    View { uvs: sheet.partners.iter().map(image).collect(), eye: Eye::Towards(glam::DVec3::new(-eye.x, eye.y, eye.z)) }
}

#[test]
fn mirrored_photos_give_the_mirrored_texture() {
    for yaw_deg in [0.0, 20.0, 45.0] {
        let sheet = Sheet::bent(0.7);
        let (view, photo) = (sheet.seen(yaw_deg), painted(waves));
        let there = sheet.baked(&[(&view, &photo)]);
        let image = sheet.baked(&[(&mirrored_view(&sheet, &view), &mirrored(&photo))]);
        let back = Texture { picture: mirrored(&image.picture), shares: image.shares };
        let apart: Vec<u8> = texels(&there).zip(texels(&back)).map(|((_, a), (_, b))| apart(a, b)).collect();
        // Rounding differs, and a centre on an edge belongs to one side only.
        let (most, off) = (apart.iter().max().unwrap(), apart.iter().filter(|apart| **apart > 1).count());
        assert!(off * 500 < apart.len(), "{off} texels, by up to {most}, at {yaw_deg}°");
        assert!((there.shares.mirrored - image.shares.mirrored).abs() < 1e-3);
    }
}

#[test]
fn the_hidden_side_is_mirrored() {
    let sheet = Sheet::bent(1.2);
    // Turned so far that its left side is hidden.
    let view = sheet.seen(38.0);
    let texture = sheet.baked(&[(&view, &painted(|_| [180.0, 140.0, 120.0]))]);
    assert!(texture.shares.mirrored > 0.15, "{:?}", texture.shares);
    assert!(texels(&texture).all(|(_, colour)| apart(colour, [180, 140, 120]) <= 1));
}
