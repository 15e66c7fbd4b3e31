use glam::{DVec2, DVec3};
use rosto_texture::spans;

use crate::seeded::Seeded;

const SIZE: [usize; 2] = [61, 47];

/// A fan of triangles in either orientation that covers the picture.
fn fan(seeded: &mut Seeded) -> Vec<[DVec2; 3]> {
    let size = DVec2::new(SIZE[0] as f64, SIZE[1] as f64);
    let rim = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner * size);
    // In some cases at a pixel's centre, so that edges pass through centres.
    let centre =
        (size * 0.5 + seeded.vector().truncate() * 12.0).floor() + if seeded.signed() > 0.0 { 0.5 } else { 0.0 };
    (0..4)
        .map(|side| [rim[side], rim[(side + 1) % 4], centre])
        .map(|[a, b, c]| if seeded.signed() > 0.0 { [a, b, c] } else { [b, a, c] })
        .collect()
}

#[test]
fn adjacent_triangles_cover_each_pixel_once() {
    let mut seeded = Seeded::new(1);
    for case in 0..200 {
        let mut count = vec![0; SIZE[0] * SIZE[1]];
        for span in fan(&mut seeded).into_iter().flat_map(|corners| spans(corners, SIZE)) {
            span.columns.for_each(|column| count[span.row * SIZE[0] + column] += 1);
        }
        assert!(count.iter().all(|count| *count == 1), "case {case}");
    }
}

#[test]
fn barycentric_coordinates_give_the_pixels_centre() {
    let mut seeded = Seeded::new(2);
    for _ in 0..100 {
        let corners = [(); 3].map(|()| seeded.vector().truncate() * 40.0 + 20.0);
        for span in spans(corners, SIZE) {
            for (column, shares) in span.pixels() {
                let at: DVec2 = corners.iter().zip(shares.to_array()).map(|(corner, share)| *corner * share).sum();
                let centre = DVec2::new(column as f64 + 0.5, span.row as f64 + 0.5);
                assert!(at.distance(centre) < 1e-6, "{corners:?} at {centre}");
                assert!((shares.dot(DVec3::ONE) - 1.0).abs() < 1e-9 && shares.min_element() > -1e-6);
            }
        }
    }
}

#[test]
fn degenerate_triangles_cover_nothing() {
    let line = [DVec2::ZERO, DVec2::splat(9.0), DVec2::splat(30.0)];
    let infinite = [DVec2::ZERO, DVec2::new(f64::INFINITY, 3.0), DVec2::new(4.0, 30.0)];
    let nan = [DVec2::ZERO, DVec2::NAN, DVec2::new(4.0, 30.0)];
    for corners in [line, infinite, nan] {
        assert_eq!(spans(corners, SIZE).count(), 0, "{corners:?}");
    }
}
