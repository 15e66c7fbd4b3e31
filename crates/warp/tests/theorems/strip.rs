//! The stiff strip around the subject.

use glam::DVec2;
use rosto_warp::{Subject, Warp, WarpMesh};

use crate::scenes::*;
use crate::seeded::Seeded;

/// Greatest strain across the strip and across the rest of the falloff band, where the subject's outline grows or
/// shrinks by the same displacement all round.
fn strains(stiff_strip_px: f64, outwards_px: f64) -> [f64; 2] {
    let mut seeded = Seeded::new(3);
    let points = oval(&mut seeded);
    let grown = |point: DVec2| point + outwards_px * ((point - MIDDLE) / AXES);
    let targets: Vec<DVec2> = points.iter().map(|&point| grown(point)).collect();
    let mut warp = Warp::new(&Subject { stiff_strip_px, ..subject(&points) }).unwrap();
    warp.follow(&points, &targets);
    assert_eq!(warp.limited_px(), 0.0);
    assert_bijective(warp.warp_mesh());
    let mut strains = [0.0_f64; 2];
    for (away_px, strain) in outward_strains(&points, warp.warp_mesh()) {
        // Triangles on the strip's border belong to both.
        if away_px < 0.6 * STIFF_STRIP_PX {
            strains[0] = strains[0].max(strain);
        } else if away_px > STIFF_STRIP_PX {
            strains[1] = strains[1].max(strain);
        }
    }
    strains
}

/// For the triangles around the subject, the distance from it and the relative change of lengths away from it.
fn outward_strains(points: &[DVec2], warp_mesh: &WarpMesh) -> Vec<(f64, f64)> {
    let is_outside = |at: DVec2| ((at - MIDDLE) / AXES).length() > 1.08;
    let strain = |corners: &[u32; 3]| {
        let [from, to] = [&warp_mesh.from_px, &warp_mesh.to_px].map(|at| corners.map(|corner| at[corner as usize]));
        let middle = (from[0] + from[1] + from[2]) / 3.0;
        let outwards = ((middle - MIDDLE) / (AXES * AXES)).normalize();
        let edges = |[a, b, c]: [DVec2; 3]| glam::DMat2::from_cols(b - a, c - a);
        let stretched = edges(to) * edges(from).inverse() * outwards;
        (middle, stretched.dot(outwards) - 1.0)
    };
    let outside = warp_mesh.triangles.iter().map(strain).filter(|(middle, _)| is_outside(*middle));
    outside.map(|(middle, strain)| (nearest(points, middle), strain.abs())).collect()
}

#[test]
fn the_strip_is_nearly_rigid_and_the_rest_of_the_band_takes_the_strain() {
    for outwards_px in [-7.0, -3.0, 3.0, 7.0] {
        let [soft, _] = strains(0.0, outwards_px);
        let [stiff, background] = strains(STIFF_STRIP_PX, outwards_px);
        assert!(stiff < 0.1 && stiff < 0.4 * soft, "{outwards_px} px: {soft} without a strip, {stiff} with it");
        assert!(background > 3.0 * stiff, "{outwards_px} px: {stiff} in the strip, {background} beyond");
    }
}

#[test]
fn a_strip_beyond_its_share_of_the_band_is_as_wide_as_the_share() {
    let mut seeded = Seeded::new(4);
    let points = oval(&mut seeded);
    let targets = edited(&points, 9.0, &mut seeded);
    let moved = |stiff_strip_px: f64| {
        let mut warp = Warp::new(&Subject { stiff_strip_px, ..subject(&points) }).unwrap();
        warp.follow(&points, &targets);
        warp.warp_mesh().clone()
    };
    let widest_px = rosto_warp::MAX_STRIP_SHARE * FALLOFF_BAND_PX;
    assert_eq!(moved(f64::INFINITY), moved(widest_px));
    assert_eq!(moved(-1.0), moved(0.0));
    assert_ne!(moved(widest_px), moved(0.0));
}
