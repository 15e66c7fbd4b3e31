//! Bodies for 3D printing and their reported measures.

use crate::common::*;

fn printed(name: &str, more: &[&str]) -> (Vec<u8>, String) {
    let path = scratch(name);
    let output = mesh(&portrait(), &path, more);
    assert_eq!(code(&output), 0, "{}", said(&output));
    (std::fs::read(path).unwrap(), said(&output))
}

/// Volume enclosed by the triangles of a binary STL in mm, in cm³.
fn volume_cm3(stl: &[u8]) -> f64 {
    let number = |at: usize| f64::from(f32::from_le_bytes(stl[at..at + 4].try_into().unwrap()));
    let vertex = |at: usize| glam::DVec3::new(number(at), number(at + 4), number(at + 8));
    let starts = (0..(stl.len() - 84) / 50).map(|triangle| 84 + 50 * triangle);
    starts.map(|at| vertex(at + 12).dot(vertex(at + 24).cross(vertex(at + 36)))).sum::<f64>() / 6000.0
}

#[test]
fn an_stl_encloses_the_reported_volume() {
    for (solid, least_cm3, most_cm3) in [("thickness:2", 30.0, 150.0), ("flat:60", 200.0, 1500.0)] {
        for topology in ["canonical", "tessellation"] {
            let (file, said) = printed("body.stl", &["--solid", solid, "--topology", topology]);
            let volume = volume_cm3(&file);
            assert!((least_cm3..most_cm3).contains(&volume), "{volume} cm³");
            assert!(
                said.contains(&format!("a body of {volume:.1} cm³")) && said.contains("g in PLA with 15 % infill"),
                "{said}"
            );
        }
    }
    let (surface, said) = printed("surface.stl", &["--solid", "surface"]);
    assert!(surface.len() == 84 + 50 * 14_368 && !said.contains("a body of"));
}

#[test]
fn a_3mf_has_the_colours_of_the_face() {
    let (file, _) = printed("face.3mf", &[]);
    assert!(String::from_utf8_lossy(&file).matches("<m:color ").count() > 200);
}

#[test]
fn the_wall_thickness_does_not_depend_on_the_density() {
    let (coarse, _) = printed("coarse.stl", &["--density", "0"]);
    let (dense, said) = printed("dense.stl", &["--density", "2"]);
    assert!((volume_cm3(&dense) / volume_cm3(&coarse) - 1.0).abs() < 0.05, "{said}");
}

/// The portrait's face fills 1024 px of texture; its head alone, eight times as large, fills 2048 px.
#[test]
#[ignore = "slow; runs at night"]
fn the_texture_size_is_limited_by_the_photo_and_by_the_option() {
    let large = scratch("large.png");
    let head = image::open(portrait()).unwrap().crop_imm(96, 0, 256, 256);
    head.resize_exact(2048, 2048, image::imageops::FilterType::Triangle).save(&large).unwrap();
    for (photo, asked_px, side_px) in [(portrait(), "2048", 1024), (large.clone(), "1024", 1024), (large, "2048", 2048)]
    {
        let picture = scratch("picture.png");
        let output = mesh(&photo, &picture, &["--texture-size", asked_px]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        assert_eq!(image::image_dimensions(picture).unwrap(), (side_px, side_px), "{}", photo.display());
    }
}
