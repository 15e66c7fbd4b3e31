use glam::DVec2;
use rosto_photo::{Photo, Sampler};

use crate::scenes::*;
use crate::seeded::Seeded;

/// Width of the colour fade at the sheet's rim, as a share of the texture.
const RIM: f64 = 0.02;

fn is_within(uv: DVec2, margin: f64) -> bool {
    ((uv - 0.5).abs().max_element() - 0.45) < -margin
}

#[test]
fn frontal_areas_have_the_photos_colours() {
    for bulge in [0.0, 0.3] {
        let sheet = Sheet::bent(bulge);
        let (view, photo) = (sheet.seen(0.0), painted(waves));
        let texture = sheet.baked(&[(&view, &photo)]);
        let sampler = Sampler::new(&photo);
        for (uv, colour) in texels(&texture).filter(|(uv, _)| is_within(*uv, RIM)) {
            // The sheet fills 0.72 of the photo and 0.9 of the texture.
            let seen = (uv - 0.5) / 0.9 * 0.72 + 0.5;
            let expected = sampler.at(seen * f64::from(PHOTO_PX)).map(|level| (level + 0.5) as u8);
            assert!(apart(colour, expected) <= 1, "{colour:?} at {uv}, and {expected:?} in the photo");
        }
        assert!(texture.shares.seen > 0.94, "{:?}", texture.shares);
    }
}

#[test]
fn a_constant_colour_is_preserved() {
    let colour = [201, 150, 117];
    let photo = painted(|_| colour.map(f64::from));
    for seed in 0..6 {
        let mut seeded = Seeded::new(seed);
        let sheet = Sheet::bent(0.8 * seeded.signed().abs());
        let views: Vec<View> = (0..=seed as usize % 3).map(|_| sheet.seen(60.0 * seeded.signed())).collect();
        let texture = sheet.baked(&views.iter().map(|view| (view, &photo)).collect::<Vec<_>>());
        assert!(texels(&texture).all(|(_, found)| found == colour), "seed {seed}");
    }
}

#[test]
fn a_second_photos_exposure_is_compensated() {
    let sheet = Sheet::bent(0.6);
    let (front, side) = (sheet.seen(-25.0), sheet.seen(30.0));
    // The same skin in both photos.
    let exposed = |gains: [f64; 3]| {
        painted(|at| std::array::from_fn(|i| gains[i] * [190.0, 150.0, 120.0][i] * (0.8 + 0.25 * at.y)))
    };
    let (first, same) = (exposed([1.0; 3]), exposed([1.0; 3]));
    let same_exposure = sheet.baked(&[(&front, &first), (&side, &same)]);
    for gains in [[0.6, 0.65, 0.7], [1.2, 1.15, 1.1]] {
        let other = sheet.baked(&[(&front, &first), (&side, &exposed(gains))]);
        let most = texels(&same_exposure).zip(texels(&other)).map(|((_, a), (_, b))| apart(a, b)).max().unwrap();
        assert!(most <= 3, "{most} levels with {gains:?}");
    }
}

#[test]
fn a_feature_comes_from_one_photo() {
    let mut sheet = Sheet::bent(0.4);
    let is_feature = |uv: &DVec2| (*uv - DVec2::new(0.35, 0.5)).abs().max_element() < 0.09;
    sheet.features =
        vec![(0..).zip(&sheet.atlas_uvs).filter(|(_, uv)| is_feature(uv)).map(|(vertex, _)| vertex).collect()];
    let (front, side) = (sheet.seen(-12.0), sheet.seen(12.0));
    let photo = |view: &View, colour: [f64; 3]| {
        let centre = sheet.features[0].iter().map(|&vertex| view.uvs[vertex as usize]).sum::<DVec2>();
        let centre = centre / sheet.features[0].len() as f64;
        painted(|at| if at.distance(centre) < 0.08 { colour } else { [180.0, 150.0, 130.0] })
    };
    let (red, blue) = ([200.0, 40.0, 40.0], [40.0, 40.0, 200.0]);
    let texture = sheet.baked(&[(&front, &photo(&front, red)), (&side, &photo(&side, blue))]);
    let is_core = |uv: DVec2| (uv - DVec2::new(0.35, 0.5)).abs().max_element() < 0.05;
    let core: Vec<[u8; 3]> = texels(&texture).filter(|(uv, _)| is_core(*uv)).map(|(_, colour)| colour).collect();
    let is = |colour: [f64; 3]| core.iter().all(|found| apart(*found, colour.map(|level| level as u8)) <= 3);
    assert!(is(red) || is(blue), "{:?} and {:?}", core[0], core[core.len() / 2]);
}

#[test]
fn the_texture_is_completely_filled_and_reproducible() {
    for seed in 0..8 {
        let mut seeded = Seeded::new(seed);
        let mut sheet = Sheet::bent(seeded.signed());
        sheet.positions.iter_mut().for_each(|position| *position += seeded.vector() * 0.1);
        let mut view = sheet.seen(90.0 * seeded.signed());
        let shift = seeded.vector().truncate() * 0.6;
        view.uvs.iter_mut().for_each(|uv| *uv += shift + seeded.vector().truncate() * 0.05);
        let levels = (0..PHOTO_PX * PHOTO_PX * 3).map(|_| 120 + seeded.below(40) as u8).collect();
        let photo = Photo::from_rgb(PHOTO_PX, PHOTO_PX, levels).unwrap();
        let texture = sheet.baked(&[(&view, &photo)]);
        let shares = texture.shares;
        assert!((shares.seen + shares.mirrored + shares.filled - 1.0).abs() < 1e-3, "{shares:?}");
        // NaN would become black.
        let least = texels(&texture).flat_map(|(_, colour)| colour).min().unwrap();
        assert!(least > 60, "{least} in seed {seed}");
        assert_eq!(sheet.baked(&[(&view, &photo)]), texture, "seed {seed}");
    }
}
