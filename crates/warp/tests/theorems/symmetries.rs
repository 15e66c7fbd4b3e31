use glam::DVec2;
use rosto_photo::Photo;
use rosto_warp::{Subject, Warp, drawn};

use crate::scenes::*;
use crate::seeded::Seeded;

/// The picture warped from the points to the targets.
fn warped(photo: &Photo, points: &[DVec2], targets: &[DVec2]) -> Photo {
    let size_px = [photo.width(), photo.height()];
    let mut warp = Warp::new(&Subject { size_px, ..subject(points) }).unwrap();
    warp.follow(points, targets);
    drawn(photo, warp.warp_mesh())
}

fn mapped(photo: &Photo, size: [u32; 2], source: impl Fn(u32, u32) -> Option<(u32, u32)>) -> Photo {
    let positions = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
    let bytes = positions.flat_map(|(x, y)| source(x, y).map_or([0; 3], |(x, y)| photo.pixel(x, y)));
    Photo::from_rgb(size[0], size[1], bytes.collect()).unwrap()
}

/// Largest difference of corresponding bytes.
fn most_different(a: &Photo, b: &Photo) -> u8 {
    a.pixels().iter().zip(b.pixels()).map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

fn smooth() -> Photo {
    painted(|at| [0.0, 1.0, 2.0].map(|phase| 127.0 + 90.0 * (at.x * 0.13 + phase).sin() * (at.y * 0.11 - phase).cos()))
}

#[test]
fn the_warp_is_invariant_under_translation() {
    let photo = smooth();
    let (right, down) = (37, 12);
    let framed = |photo: &Photo| {
        let inside = |x: u32, y: u32| {
            (x >= right && y >= down && x - right < SIDE && y - down < SIDE).then(|| (x - right, y - down))
        };
        mapped(photo, [SIDE + 50, SIDE + 50], inside)
    };
    let shift = DVec2::new(f64::from(right), f64::from(down));
    for seed in 0..6 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let targets = edited(&points, 9.0, &mut seeded);
        let shifted = |positions: &[DVec2]| positions.iter().map(|position| *position + shift).collect::<Vec<_>>();
        let there = warped(&framed(&photo), &shifted(&points), &shifted(&targets));
        let here = framed(&warped(&photo, &points, &targets));
        assert!(most_different(&there, &here) <= 1, "edit {seed}: {}", most_different(&there, &here));
    }
}

#[test]
fn the_warp_commutes_with_mirroring() {
    let photo = smooth();
    let size = f64::from(SIDE);
    for seed in 0..6 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let targets = edited(&points, 9.0, &mut seeded);
        let across = |photo: &Photo| mapped(photo, [SIDE, SIDE], |x, y| Some((SIDE - 1 - x, y)));
        let down = |photo: &Photo| mapped(photo, [SIDE, SIDE], |x, y| Some((x, SIDE - 1 - y)));
        let places_across =
            |positions: &[DVec2]| positions.iter().map(|at| DVec2::new(size - at.x, at.y)).collect::<Vec<_>>();
        let places_down =
            |positions: &[DVec2]| positions.iter().map(|at| DVec2::new(at.x, size - at.y)).collect::<Vec<_>>();
        let here = warped(&photo, &points, &targets);
        let there = warped(&across(&photo), &places_across(&points), &places_across(&targets));
        assert!(most_different(&across(&there), &here) <= 1, "{}", most_different(&across(&there), &here));
        let there = warped(&down(&photo), &places_down(&points), &places_down(&targets));
        assert!(most_different(&down(&there), &here) <= 1, "{}", most_different(&down(&there), &here));
    }
}

#[test]
fn the_warp_is_linear_without_folds() {
    let mut seeded = Seeded::new(12);
    let points = oval(&mut seeded);
    let targets = edited(&points, 5.0, &mut seeded);
    let half: Vec<DVec2> = points.iter().zip(&targets).map(|(point, target)| point.lerp(*target, 0.5)).collect();
    let (whole, half) = (moved(&points, &targets), moved(&points, &half));
    for ((from, whole), half) in
        whole.warp_mesh().from_px.iter().zip(&whole.warp_mesh().to_px).zip(&half.warp_mesh().to_px)
    {
        assert!(from.lerp(*whole, 0.5).distance(*half) < 1e-9, "half the target gives half the displacement");
    }
}
