//! Test pictures and subjects.

use glam::DVec2;
use rosto_photo::Photo;
use rosto_warp::{Dab, Subject, Warp, WarpMesh, drawn};

use crate::seeded::Seeded;

pub const SIDE: u32 = 200;
pub const FALLOFF_BAND_PX: f64 = 40.0;
pub const STIFF_STRIP_PX: f64 = 12.0;
/// Centre and half axes of [`oval`].
pub const MIDDLE: DVec2 = DVec2::new(98.0, 103.0);
pub const AXES: DVec2 = DVec2::new(34.0, 45.0);

/// 150 points in an oval, in pseudo-random order, about as dense as landmarks.
pub fn oval(seeded: &mut Seeded) -> Vec<DVec2> {
    let turns = (0..150).map(|i| DVec2::from_angle(f64::from(i) * 2.399_963) * (f64::from(i) / 150.0).sqrt());
    turns.map(|turn| MIDDLE + AXES * turn + plane(seeded) * 0.8).collect()
}

/// A vector with coordinates between −1 and 1.
pub fn plane(seeded: &mut Seeded) -> DVec2 {
    seeded.vector().truncate()
}

/// Targets with three smooth bumps of up to `most_px`, as edits make them.
pub fn edited(points: &[DVec2], most_px: f64, seeded: &mut Seeded) -> Vec<DVec2> {
    let bumps: Vec<(DVec2, DVec2, f64)> = (0..3)
        .map(|_| (points[seeded.below(points.len())], plane(seeded) * most_px, 14.0 + 8.0 * seeded.signed()))
        .collect();
    let offset = |point: DVec2| -> DVec2 {
        bumps
            .iter()
            .map(|(centre, offset, width)| *offset * (-(point - *centre).length_squared() / (width * width)).exp())
            .sum()
    };
    points.iter().map(|&point| point + offset(point)).collect()
}

pub fn subject(points_px: &[DVec2]) -> Subject<'_> {
    Subject {
        size_px: [SIDE, SIDE],
        points_px,
        falloff_band_px: FALLOFF_BAND_PX,
        stiff_strip_px: STIFF_STRIP_PX,
        protected: &[],
    }
}

pub fn warp(points: &[DVec2], protected: &[Dab]) -> Warp {
    Warp::new(&Subject { protected, ..subject(points) }).unwrap()
}

pub fn moved(points: &[DVec2], targets: &[DVec2]) -> Warp {
    let mut warp = warp(points, &[]);
    warp.follow(points, targets);
    warp
}

/// White noise.
pub fn noise() -> Photo {
    let mut seeded = Seeded::new(7);
    Photo::from_rgb(SIDE, SIDE, (0..SIDE * SIDE * 3).map(|_| seeded.bits() as u8).collect()).unwrap()
}

/// A picture sampled from a function at the pixel centres.
pub fn painted(colour: impl Fn(DVec2) -> [f64; 3]) -> Photo {
    let centres = (0..SIDE * SIDE).map(|i| DVec2::new(f64::from(i % SIDE) + 0.5, f64::from(i / SIDE) + 0.5));
    let bytes = centres.flat_map(|centre| colour(centre).map(|value| value.round().clamp(0.0, 255.0) as u8));
    Photo::from_rgb(SIDE, SIDE, bytes.collect()).unwrap()
}

/// Pixels with their centres.
pub fn pixels(photo: &Photo) -> impl Iterator<Item = (DVec2, [u8; 3])> {
    let centre = |x: u32, y: u32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    (0..photo.height()).flat_map(move |y| (0..photo.width()).map(move |x| (centre(x, y), photo.pixel(x, y))))
}

pub fn nearest(points: &[DVec2], position: DVec2) -> f64 {
    points.iter().map(|point| point.distance(position)).fold(f64::INFINITY, f64::min)
}

/// Twice the signed area of each triangle.
pub fn areas(warp_mesh: &WarpMesh, positions: &[DVec2]) -> Vec<f64> {
    let area = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        (b - a).perp_dot(c - a)
    };
    warp_mesh.triangles.iter().map(area).collect()
}

/// Asserts that no triangle is inverted and the covered area stays the same, so the map is one to one and onto.
#[track_caller]
pub fn assert_bijective(warp_mesh: &WarpMesh) {
    let (before, after) = (areas(warp_mesh, &warp_mesh.from_px), areas(warp_mesh, &warp_mesh.to_px));
    for (triangle, (before, after)) in before.iter().zip(&after).enumerate() {
        assert!(before * after > 0.0 || before == after, "triangle {triangle}: {before} to {after}");
    }
    let [before, after] = [before, after].map(|areas| areas.iter().sum::<f64>());
    assert!((after / before - 1.0).abs() < 1e-9, "{before} to {after}");
}

pub fn redrawn(photo: &Photo, warp: &Warp) -> Photo {
    drawn(photo, warp.warp_mesh())
}
