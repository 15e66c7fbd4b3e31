//! Edits applied to the photo.

use glam::DVec2;
use rosto_face::*;
use rosto_studio::*;
use rosto_warp::WarpMesh;

use crate::faces::{observed, portrait_landmarks};
use crate::seeded::Seeded;

const SIZE_PX: u32 = 2048;

/// Edges of the upper and lower lid, from corner to corner.
const LIDS: [[[usize; 7]; 2]; 2] = [
    [[246, 161, 160, 159, 158, 157, 173], [7, 163, 144, 145, 153, 154, 155]],
    [[466, 388, 387, 386, 385, 384, 398], [249, 390, 373, 374, 380, 381, 382]],
];

/// The portrait with closed eyes: both lids at the lower one's position, with the precision of detected landmarks.
fn with_closed_eyes(triangulation: Triangulation) -> FaceModel {
    let mut landmarks = portrait_landmarks();
    let mut seeded = Seeded::new(3);
    for [uppers, lowers] in LIDS {
        for (upper, lower) in uppers.into_iter().zip(lowers) {
            landmarks[upper] = landmarks[lower];
            for landmark in [upper, lower] {
                let off = seeded.vector() * 0.002;
                landmarks[landmark][0] += off.x as f32;
                landmarks[landmark][1] += off.y as f32;
            }
        }
    }
    FaceModel::new(observed(landmarks, SIZE_PX, PhotoLens::Distance(0.6)), triangulation).unwrap()
}

/// Position to which a warp moves a point.
fn warped(warp_mesh: &WarpMesh, point: DVec2) -> DVec2 {
    let area = |[a, b, c]: [DVec2; 3]| (b - a).perp_dot(c - a);
    let shares = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| warp_mesh.from_px[corner as usize]);
        [[point, b, c], [a, point, c], [a, b, point]].map(|part| area(part) / area([a, b, c]))
    };
    let within = |corners: &&[u32; 3]| shares(corners).iter().all(|share| *share >= -1e-9);
    let corners = warp_mesh.triangles.iter().find(within).unwrap();
    shares(corners).iter().zip(corners).map(|(share, corner)| *share * warp_mesh.to_px[*corner as usize]).sum()
}

#[test]
fn the_line_between_closed_lids_stays_smooth() {
    const STEPS: usize = 24;
    for triangulation in [Triangulation::Tessellation, Triangulation::Canonical] {
        let face = with_closed_eyes(triangulation);
        let found = |landmark: usize| {
            let [x, y, _] = face.landmarks()[landmark];
            DVec2::new(x.into(), y.into()) * f64::from(SIZE_PX)
        };
        for density in [0, 2] {
            let mut document = Document::new(Rest::of_face(&face)).unwrap();
            document.set_density(density).unwrap();
            document.apply(FaceSlider::EyeSize.id(), FaceSlider::EyeSize.command(0.003)).unwrap();
            let mut photo_warp = PhotoWarp::new(&face, &document, DEFAULT_FALLOFF_BAND, &[]).unwrap();
            photo_warp.follow(document.rest(), document.positions(), face.camera(), face.camera());
            for lids in LIDS {
                let along = |i: usize| lids.map(|lid| found(lid[i])).iter().sum::<DVec2>() / 2.0;
                let line: Vec<DVec2> = (0..=STEPS)
                    .map(|step| {
                        let at = 6.0 * step as f64 / STEPS as f64;
                        let from = (at as usize).min(5);
                        along(from).lerp(along(from + 1), at - from as f64)
                    })
                    .collect();
                let displacements: Vec<DVec2> =
                    line.iter().map(|&point| warped(photo_warp.warp_mesh(), point) - point).collect();
                let bend_px =
                    |displacements: &[DVec2]| (displacements[1] - 0.5 * (displacements[0] + displacements[2])).length();
                let max_px = displacements.windows(3).map(bend_px).fold(0.0, f64::max);
                assert!(max_px < 2.0, "{triangulation:?}, density {density}: it bends by {max_px} px");
            }
        }
    }
}

/// Outline of the face next to the ears, from below the eyes to the mouth, on the subject's right and left.
const BESIDE_EARS: [[usize; 3]; 2] = [[234, 93, 132], [454, 323, 361]];

/// Greatest relative change of the width of an ear next to the face, for a warp of the portrait taken from
/// `distance_m`.
fn ear_stretch(distance_m: f64, slider: Option<(FaceSlider, f64)>, seen_from_m: Option<f64>) -> f64 {
    let landmarks = portrait_landmarks();
    let px =
        |landmark: usize| DVec2::new(landmarks[landmark][0].into(), landmarks[landmark][1].into()) * f64::from(SIZE_PX);
    let ear_px = 0.15 * px(BESIDE_EARS[0][0]).distance(px(BESIDE_EARS[1][0]));
    let observation = observed(landmarks.clone(), SIZE_PX, PhotoLens::Distance(distance_m));
    let face = FaceModel::new(observation, Triangulation::Tessellation).unwrap();
    let mut document = Document::new(Rest::of_face(&face)).unwrap();
    document.set_density(SMOOTH_DENSITY).unwrap();
    if let Some((slider, amount_m)) = slider {
        document.apply(slider.id(), slider.command(amount_m)).unwrap();
    }
    let mut photo_warp = PhotoWarp::new(&face, &document, DEFAULT_FALLOFF_BAND, &[]).unwrap();
    let seen_by = seen_from_m.map_or(*face.camera(), |distance_m| face.seen_from(distance_m));
    photo_warp.follow(document.rest(), document.positions(), face.camera(), &seen_by);
    let stretch = |inner: DVec2, outwards: f64| {
        let outer = inner + DVec2::X * outwards * ear_px;
        let [inner_to, outer_to] = [inner, outer].map(|point| warped(photo_warp.warp_mesh(), point));
        ((outer_to.x - inner_to.x) / (outer.x - inner.x) - 1.0).abs()
    };
    let sides = BESIDE_EARS.into_iter().zip([-1.0, 1.0]);
    sides.flat_map(|(side, outwards)| side.map(|landmark| stretch(px(landmark), outwards))).fold(0.0, f64::max)
}

#[test]
fn ears_are_nearly_rigid() {
    for slider in FaceSlider::ALL {
        for amount_m in [-slider.range_m(), slider.range_m()] {
            let stretch = ear_stretch(0.6, Some((slider, amount_m)), None);
            assert!(stretch < 0.1, "{slider:?} {amount_m} m: {stretch}");
        }
    }
    for distance_m in [0.3, 0.4] {
        let stretch = ear_stretch(distance_m, None, Some(3.0));
        assert!(stretch < 0.1, "from {distance_m} m: {stretch}");
    }
}
