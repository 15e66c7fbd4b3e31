use glam::{DMat2, DVec2};
use rosto_photo::Photo;
use rosto_warp::WarpMesh;

use crate::scenes::*;
use crate::seeded::Seeded;

#[test]
fn without_displacements_pixels_do_not_change() {
    let points = oval(&mut Seeded::new(1));
    let photo = noise();
    assert_eq!(redrawn(&photo, &warp(&points, &[])), photo, "before follow");
    assert_eq!(redrawn(&photo, &moved(&points, &points)), photo, "targets equal to the points");
    let mut there_and_back = moved(&points, &edited(&points, 9.0, &mut Seeded::new(2)));
    assert_ne!(redrawn(&photo, &there_and_back), photo);
    there_and_back.follow(&points, &points);
    assert_eq!(redrawn(&photo, &there_and_back), photo, "after moving back");
}

#[test]
fn pixels_beyond_the_falloff_band_do_not_change() {
    let photo = noise();
    for seed in 0..12 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let after = redrawn(&photo, &moved(&points, &edited(&points, 20.0, &mut seeded)));
        assert_ne!(after, photo);
        for ((position, before), (_, after)) in pixels(&photo).zip(pixels(&after)) {
            assert!(before == after || nearest(&points, position) < FALLOFF_BAND_PX, "{position} , edit {seed}");
        }
    }
}

/// On slopes of one level per px, adjacent pixels differ by at most the map's largest stretch.
#[test]
fn there_is_no_seam() {
    let slopes = painted(|at| [at.x + 20.0, at.y + 20.0, 240.0 - at.x]);
    for seed in 0..8 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let warp = moved(&points, &edited(&points, 14.0, &mut seeded));
        // Allows for rounding of the slopes and of the result.
        let limit = max_stretch(warp.warp_mesh()) + 2.0;
        let after = redrawn(&slopes, &warp);
        for (x, y) in (1..SIDE).flat_map(|y| (1..SIDE).map(move |x| (x, y))) {
            let here = after.pixel(x, y);
            for adjacent in [after.pixel(x - 1, y), after.pixel(x, y - 1)] {
                let jump = (0..3).map(|channel| here[channel].abs_diff(adjacent[channel])).max().unwrap();
                assert!(
                    f64::from(jump) <= limit,
                    "a jump of {jump} at ({x}, {y}) in edit {seed}, the limit is {limit}"
                );
            }
        }
    }
}

/// Largest distance between the sources of two adjacent pixels.
fn max_stretch(warp_mesh: &WarpMesh) -> f64 {
    let edges = |positions: &[DVec2], corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        DMat2::from_cols(b - a, c - a)
    };
    let stretch = |corners: &[u32; 3]| {
        let back = edges(&warp_mesh.from_px, corners) * edges(&warp_mesh.to_px, corners).inverse();
        back.x_axis.length().max(back.y_axis.length())
    };
    warp_mesh.triangles.iter().map(stretch).fold(1.0, f64::max)
}

#[test]
fn the_picture_at_a_point_moves_to_its_target() {
    for seed in 0..12 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let targets = edited(&points, 6.0, &mut seeded);
        let warp = moved(&points, &targets);
        assert_eq!(warp.limited_px(), 0.0, "edit {seed}");
        let chosen = seeded.below(points.len());
        let dot = |at: DVec2| 255.0 * (-(at - points[chosen]).length_squared() / 4.0).exp();
        let found = centroid(&redrawn(&painted(|at| [dot(at), 0.0, 0.0]), &warp));
        assert!(found.distance(targets[chosen]) < 0.5, "edit {seed}: {found} for {}", targets[chosen]);
    }
}

fn centroid(photo: &Photo) -> DVec2 {
    let weighed = pixels(photo).map(|(position, [red, ..])| (position, f64::from(red)));
    let (sum, all) = weighed.fold((DVec2::ZERO, 0.0), |(sum, all), (position, red)| (sum + position * red, all + red));
    sum / all
}

/// Pixels on edges and corners of triangles are drawn as well.
#[test]
fn triangles_leave_no_gaps() {
    // At pixel centres, so that edges pass through many of them.
    let points: Vec<DVec2> = (0..81).map(|i| DVec2::new(f64::from(i % 9), f64::from(i / 9)) * 10.0 + 60.5).collect();
    let targets: Vec<DVec2> = points.iter().map(|&point| point + DVec2::new(8.0, 4.0)).collect();
    let warp = moved(&points, &targets);
    let inside = |at: DVec2| (at - 100.5).abs().max_element();
    let photo = painted(|at| if inside(at) < 40.0 { [255.0; 3] } else { [0.0; 3] });
    for (position, colour) in pixels(&redrawn(&photo, &warp)) {
        let is_within = inside(position - DVec2::new(8.0, 4.0)) < 37.0;
        assert!(!is_within || colour == [255; 3], "{colour:?} at {position}");
    }
}

#[test]
fn the_warp_scales_with_the_picture() {
    let mut seeded = Seeded::new(3);
    let points = oval(&mut seeded);
    let warp = moved(&points, &edited(&points, 9.0, &mut seeded));
    let twice = warp.warp_mesh().cut(DVec2::ZERO, 2.0);
    let mut larger = LargerWarp::of(&points);
    larger.follow(&twice);
    assert!(larger.max_difference_px(&twice) < 1e-6, "{}", larger.max_difference_px(&twice));
}

/// The same subject in a picture twice as large.
struct LargerWarp(rosto_warp::Warp, Vec<DVec2>);

impl LargerWarp {
    fn of(points: &[DVec2]) -> Self {
        let points: Vec<DVec2> = points.iter().map(|point| *point * 2.0).collect();
        let subject = rosto_warp::Subject {
            size_px: [2 * SIDE, 2 * SIDE],
            points_px: &points,
            falloff_band_px: 2.0 * FALLOFF_BAND_PX,
            stiff_strip_px: 2.0 * STIFF_STRIP_PX,
            protected: &[],
        };
        Self(rosto_warp::Warp::new(&subject).unwrap(), points)
    }

    /// Uses the scaled warp mesh's points as targets.
    fn follow(&mut self, warp_mesh: &WarpMesh) {
        let target = |point: &DVec2| {
            let at = warp_mesh.from_px.iter().position(|from| from.distance(*point) < 1e-9).unwrap();
            warp_mesh.to_px[at]
        };
        let targets: Vec<DVec2> = self.1.iter().map(target).collect();
        self.0.follow(&self.1, &targets);
    }

    fn max_difference_px(&self, warp_mesh: &WarpMesh) -> f64 {
        let apart = self.0.warp_mesh().to_px.iter().zip(&warp_mesh.to_px).map(|(a, b)| a.distance(*b));
        apart.fold(0.0, f64::max)
    }
}

/// The alpha channel, a copy of red, stays equal to red.
#[test]
fn alpha_is_warped_like_the_colours() {
    let mut seeded = Seeded::new(3);
    let points = oval(&mut seeded);
    let warp = moved(&points, &edited(&points, 14.0, &mut seeded));
    let photo = noise();
    let alpha = photo.pixels().iter().step_by(3).copied().collect();
    let after = redrawn(&photo.clone().with_alpha(alpha).unwrap(), &warp);
    let reds: Vec<u8> = after.pixels().iter().step_by(3).copied().collect();
    assert_eq!(after.alpha(), Some(reds.as_slice()));
    assert_eq!(after.pixels(), redrawn(&photo, &warp).pixels());
    assert_ne!(after.pixels(), photo.pixels());
}
