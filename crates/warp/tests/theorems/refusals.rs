use glam::DVec2;
use rosto_warp::{Dab, FALLOFF_BAND_SHARES, Subject, Warp, WarpError};

use crate::scenes::*;
use crate::seeded::Seeded;

fn made(size_px: [u32; 2], points_px: &[DVec2], falloff_band_px: f64) -> Result<Warp, WarpError> {
    Warp::new(&Subject { size_px, falloff_band_px, ..subject(points_px) })
}

#[test]
fn too_few_points_are_refused() {
    let refused = |points: &[DVec2]| made([50, 50], points, 10.0).err();
    let three = |at: [DVec2; 3]| refused(&at);
    assert_eq!(refused(&[]), Some(WarpError::TooFewPoints { inside: 0, points: 0 }));
    assert_eq!(three([DVec2::NAN; 3]), Some(WarpError::TooFewPoints { inside: 0, points: 3 }));
    assert_eq!(three([DVec2::splat(20.0); 3]), Some(WarpError::TooFewPoints { inside: 3, points: 3 }));
    let outside = [DVec2::splat(20.0), DVec2::splat(-1.0), DVec2::new(20.0, 50.0)];
    assert_eq!(three(outside), Some(WarpError::TooFewPoints { inside: 1, points: 3 }));
    assert!(three([DVec2::splat(20.0), DVec2::splat(25.0), DVec2::splat(f64::INFINITY)]).is_some());
}

#[test]
fn falloff_bands_outside_the_range_are_refused() {
    let points = oval(&mut Seeded::new(1));
    for falloff_band_px in [0.0, -3.0, 0.01, 1e9, f64::NAN, f64::INFINITY] {
        let refused = made([SIDE, SIDE], &points, falloff_band_px).err();
        assert!(matches!(refused, Some(WarpError::FalloffBand { .. })), "{falloff_band_px}: {refused:?}");
    }
    let high = 2.0 * AXES.y;
    for share in [*FALLOFF_BAND_SHARES.start() * 1.1, *FALLOFF_BAND_SHARES.end() * 0.9] {
        let mut warp = made([SIDE, SIDE], &points, share * high).unwrap();
        warp.follow(&points, &edited(&points, 9.0, &mut Seeded::new(2)));
        assert_bijective(warp.warp_mesh());
    }
}

/// Unusual pictures and points give a result without folds or an error.
#[test]
fn unusual_subjects_are_handled() {
    let line: Vec<DVec2> = (1..40).map(|i| DVec2::new(f64::from(i), 20.0)).collect();
    let slanted: Vec<DVec2> = (1..40).map(|i| DVec2::splat(f64::from(i) * 1.01)).collect();
    let twice: Vec<DVec2> = oval(&mut Seeded::new(1)).iter().flat_map(|point| [*point, *point]).collect();
    let mut with_nan = oval(&mut Seeded::new(1));
    with_nan.iter_mut().step_by(3).for_each(|point| *point = DVec2::NAN);
    let in_a_pixel = [DVec2::new(0.2, 0.3), DVec2::new(0.8, 0.4), DVec2::new(0.5, 0.9)].to_vec();
    let at_the_edge: Vec<DVec2> = (0..60).map(|i| DVec2::new(1e-9, 3.0 * f64::from(i) + 1.0)).collect();
    let grid: Vec<DVec2> = (0..400).map(|i| DVec2::new(f64::from(i % 20), f64::from(i / 20)) * 4.0 + 50.0).collect();
    let far_apart = [DVec2::splat(5.0), DVec2::new(190.0, 10.0), DVec2::new(100.0, 195.0)].to_vec();
    let cases = [line, slanted, twice, with_nan, in_a_pixel, at_the_edge, grid, far_apart];
    for (case, points) in cases.iter().enumerate() {
        for size_px in [[1, 1], [1, 200], [200, 1], [60, 50], [SIDE, SIDE]] {
            for falloff_band_px in [0.2, 10.0, 60.0] {
                let Ok(mut warp) = made(size_px, points, falloff_band_px) else { continue };
                warp.follow(points, &edited(points, 7.0, &mut Seeded::new(case as u64)));
                assert_bijective(warp.warp_mesh());
            }
        }
        let has_answer =
            [0.2, 10.0, 60.0].iter().any(|&falloff_band_px| made([SIDE, SIDE], points, falloff_band_px).is_ok());
        assert!(has_answer, "case {case}");
    }
}

#[test]
fn non_finite_targets_are_handled() {
    let points = oval(&mut Seeded::new(1));
    let targets = vec![DVec2::NAN; points.len()];
    assert_eq!(redrawn(&noise(), &moved(&points, &targets)), noise());
    for far in [f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 1e200] {
        let mut targets = points.clone();
        targets[7] = DVec2::splat(far);
        targets[80].y = far;
        assert_bijective(moved(&points, &targets).warp_mesh());
    }
}

#[test]
fn invalid_circles_protect_nothing() {
    let points = oval(&mut Seeded::new(1));
    for (centre_px, radius_px) in [(DVec2::NAN, 9.0), (MIDDLE, f64::NAN), (DVec2::splat(1e300), 1.0)] {
        let mut warp = warp(&points, &[Dab { centre_px, radius_px }]);
        warp.follow(&points, &edited(&points, 9.0, &mut Seeded::new(2)));
        assert_ne!(redrawn(&noise(), &warp), noise());
        assert_bijective(warp.warp_mesh());
    }
}
