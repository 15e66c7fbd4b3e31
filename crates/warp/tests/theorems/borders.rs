use glam::DVec2;
use rosto_warp::{Dab, Subject, Warp, drawn};

use crate::scenes::*;
use crate::seeded::Seeded;

/// Value and slope are continuous at the outer border of the falloff band.
#[test]
fn value_and_slope_vanish_at_the_border() {
    // A cubic from 1 to 0 with zero end slope has fallen to a tenth at 4/5 of the distance, a straight line to a fifth.
    assert_vanishing(0.0, 0.12);
    // From a stiff strip on, the distance is shorter, and both are higher.
    assert_vanishing(STIFF_STRIP_PX, 0.15);
}

fn assert_vanishing(stiff_strip_px: f64, limit: f64) {
    let mut seeded = Seeded::new(6);
    let points = oval(&mut seeded);
    let targets: Vec<DVec2> = points.iter().map(|&point| point + DVec2::new(10.0, 0.0)).collect();
    let mut warp = Warp::new(&Subject { stiff_strip_px, ..subject(&points) }).unwrap();
    warp.follow(&points, &targets);
    let warp_mesh = warp.warp_mesh();
    let offsets =
        || warp_mesh.from_px.iter().zip(&warp_mesh.to_px).map(|(from, to)| (nearest(&points, *from), *to - *from));
    let within = |low: f64, high: f64| {
        let chosen = offsets().filter(move |(away, _)| (low..high).contains(&(away / FALLOFF_BAND_PX)));
        chosen.map(|(_, offset)| offset.length()).fold(0.0, f64::max)
    };
    assert_eq!(within(0.95, 9.0), 0.0, "beyond the border");
    assert!(within(0.0, 0.2) > 8.0, "next to the subject");
    assert!(within(0.75, 0.95) < limit * 10.0, "{}", within(0.75, 0.95));
    let falls: Vec<f64> = [0.1, 0.3, 0.5, 0.7, 0.9].map(|share| within(share - 0.1, share + 0.1)).to_vec();
    assert!(falls.is_sorted_by(|nearer, farther| nearer > farther), "{falls:?}");
}

#[test]
fn protected_pixels_do_not_change() {
    let photo = noise();
    for seed in 0..8 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let protected: Vec<Dab> = (0..3)
            .map(|_| Dab {
                centre_px: MIDDLE + AXES * 1.4 * plane(&mut seeded),
                radius_px: 7.0 + 6.0 * seeded.signed(),
            })
            .collect();
        let mut warp = warp(&points, &protected);
        warp.follow(&points, &edited(&points, 15.0, &mut seeded));
        assert_bijective(warp.warp_mesh());
        let after = redrawn(&photo, &warp);
        let is_protected =
            |position: DVec2| protected.iter().any(|dab| dab.centre_px.distance(position) <= dab.radius_px);
        for ((position, before), (_, after)) in pixels(&photo).zip(pixels(&after)) {
            assert!(before == after || !is_protected(position), "{position} , edit {seed}");
        }
    }
}

#[test]
fn a_fully_protected_picture_does_not_change() {
    let mut seeded = Seeded::new(9);
    let points = oval(&mut seeded);
    let mut warp = warp(&points, &[Dab { centre_px: MIDDLE, radius_px: 500.0 }]);
    warp.follow(&points, &edited(&points, 15.0, &mut seeded));
    assert_eq!((warp.limited_px(), redrawn(&noise(), &warp)), (0.0, noise()));
}

/// A subject cut by the picture's border and moved outward and inward.
#[test]
fn the_border_of_the_picture_does_not_move() {
    let white = painted(|_| [255.0; 3]);
    for (seed, shift) in
        [DVec2::new(-98.0, 0.0), DVec2::new(80.0, 90.0), DVec2::new(0.0, -103.0)].into_iter().enumerate()
    {
        let mut seeded = Seeded::new(seed as u64);
        let points: Vec<DVec2> = oval(&mut seeded).iter().map(|point| *point + shift).collect();
        assert!(points.iter().any(|point| point.min_element() < 0.0 || point.max_element() > f64::from(SIDE)));
        for offset in [DVec2::new(14.0, 9.0), DVec2::new(-14.0, -9.0)] {
            let targets: Vec<DVec2> = points.iter().map(|point| *point + offset).collect();
            let warp = moved(&points, &targets);
            assert_bijective(warp.warp_mesh());
            let size = f64::from(SIDE);
            let at_edge =
                |position: &DVec2| position.x == 0.0 || position.y == 0.0 || position.x == size || position.y == size;
            for (from, to) in warp.warp_mesh().from_px.iter().zip(&warp.warp_mesh().to_px) {
                assert!(!at_edge(from) || from == to);
                assert!(to.min_element() >= 0.0 && to.max_element() <= size, "{to}");
            }
            assert_eq!(redrawn(&white, &warp), white, "no hole appears");
        }
    }
}

#[test]
fn a_wider_falloff_band_changes_more_distant_pixels() {
    let mut seeded = Seeded::new(10);
    let points = oval(&mut seeded);
    let targets: Vec<DVec2> = points.iter().map(|&point| point + DVec2::X * 8.0).collect();
    let photo = noise();
    let extents_px = [15.0, 30.0, 60.0].map(|falloff_band_px| {
        let mut warp = Warp::new(&Subject { falloff_band_px, ..subject(&points) }).unwrap();
        warp.follow(&points, &targets);
        let after = drawn(&photo, warp.warp_mesh());
        let changed = pixels(&photo).zip(pixels(&after)).filter(|((_, before), (_, after))| before != after);
        changed.map(|((position, _), _)| nearest(&points, position)).fold(0.0, f64::max)
    });
    for (extent_px, falloff_band_px) in extents_px.into_iter().zip([15.0, 30.0, 60.0]) {
        assert!((0.6 * falloff_band_px..falloff_band_px).contains(&extent_px), "{extent_px} of {falloff_band_px}");
    }
}
