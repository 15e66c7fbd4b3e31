//! Following a face through a video: jitter, lag, loss and recovery.

use crate::support;
use crate::support::scenes::canvas::Ground;
use crate::support::scenes::{Model, Placement};
use crate::support::seeded::Seeded;
use crate::support::video::{self, FRAME_MS};
use rosto_landmarks::{FaceFinder, Follower, Origin};
use rosto_photo::Photo;

/// Amplitude of the camera noise, of 255.
const NOISE: f64 = 8.0;

fn model(finder: &FaceFinder) -> Model {
    Model::new(finder, &support::assets::portrait())
}

/// The landmarks in each frame, px; each frame must contain a face.
fn followed_px(finder: &FaceFinder, frames: &[Photo]) -> Vec<Vec<[f64; 2]>> {
    video::follow(finder, frames).iter().map(|face| video::px(face.as_ref().unwrap())).collect()
}

/// The landmarks in each frame, px, each frame processed without the previous ones.
fn fresh_px(finder: &FaceFinder, frames: &[Photo]) -> Vec<Vec<[f64; 2]>> {
    let fresh = |frame| video::follow_one(finder, &mut Follower::default(), frame, 0.0).unwrap();
    frames.iter().map(|frame| video::px(&fresh(frame))).collect()
}

fn shifted(landmarks: &[[f64; 2]], [dx, dy]: [f64; 2]) -> Vec<[f64; 2]> {
    landmarks.iter().map(|[x, y]| [x + dx, y + dy]).collect()
}

#[test]
#[ignore = "slow; runs at night"]
fn a_still_face_with_noise_has_little_jitter() {
    /// Frame from which the region, which depends on the landmarks, has also converged.
    const SETTLED: usize = 10;
    let finder = support::attention_finder();
    let model = model(&finder);
    let frames: Vec<Photo> = (0..30).map(|number| video::frame(&model, &[video::middle()], NOISE, number)).collect();
    let followed = followed_px(&finder, &frames);
    let fresh = video::jitter_px(&fresh_px(&finder, &frames[SETTLED..]));
    let (whole, settled) = (video::jitter_px(&followed), video::jitter_px(&followed[SETTLED..]));
    assert!(whole < 0.3, "{whole} px from the first frame on");
    assert!(settled < 0.15 && settled < 0.4 * fresh, "{settled} px; {fresh} px frame by frame");
}

#[test]
fn a_moving_face_is_followed_without_lag() {
    let finder = support::attention_finder();
    let model = model(&finder);
    for speed_px_s in [100.0, 200.0, 300.0] {
        let at = |number: u64| 200.0 + speed_px_s * FRAME_MS / 1000.0 * number as f64;
        let frame = |number| video::frame(&model, &[Placement::upright([at(number), 240.0], 1.6)], NOISE, number);
        let frames: Vec<Photo> = (0..20).map(frame).collect();
        let followed = followed_px(&finder, &frames);
        for number in [1, 4, 10, 19] {
            let truth = shifted(&followed[0], [at(number) - at(0), 0.0]);
            let lag_ms = video::lag_ms(&followed[number as usize], &truth, speed_px_s);
            assert!(lag_ms.abs() < 15.0, "{lag_ms} ms at {speed_px_s} px/s in frame {number}");
        }
    }
}

/// Triangle wave at constant speed, as of a shaken head, at several frame intervals.
#[test]
#[ignore = "slow; runs at night"]
fn a_face_is_followed_without_lag_at_low_frame_rates() {
    const SPEED_PX_S: f64 = 200.0;
    const AMPLITUDE_PX: f64 = 100.0;
    let finder = support::attention_finder();
    let model = model(&finder);
    for every_ms in [33.0, 50.0, 66.0, 70.0, 110.0, 170.0, 230.0, 400.0] {
        let mut follower = Follower::default();
        let mut first = None;
        for number in 0..16_u32 {
            let time_ms = every_ms * f64::from(number);
            let travelled_px = (SPEED_PX_S * time_ms / 1000.0) % (4.0 * AMPLITUDE_PX);
            let offset_px = AMPLITUDE_PX - (travelled_px - 2.0 * AMPLITUDE_PX).abs();
            let placed = Placement::upright([320.0 + offset_px, 240.0], 1.6);
            let frame = video::frame(&model, &[placed], NOISE, number.into());
            let face = video::follow_one(&finder, &mut follower, &frame, time_ms).unwrap();
            let px = video::px(&face);
            let (first_px, from) = first.get_or_insert_with(|| (px.clone(), offset_px));
            let lag_px = video::apart_px(&px, &shifted(first_px, [offset_px - *from, 0.0]));
            assert!(lag_px < 4.0, "every {every_ms} ms, frame {number}: {lag_px} px");
        }
    }
}

#[test]
fn followed_landmarks_match_detected_ones() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let frame = |number: u64| {
        let placed = Placement {
            degrees: 2.0 * number as f64,
            ..Placement::upright([260.0 + 8.0 * number as f64, 240.0], 1.4 + 0.02 * number as f64)
        };
        video::frame(&model, &[placed], 0.0, number)
    };
    let frames: Vec<Photo> = (0..12).map(frame).collect();
    let followed = video::follow(&finder, &frames);
    let origins: Vec<Origin> = followed.iter().flatten().map(|face| face.origin).collect();
    assert_eq!(origins[0], Origin::Detected);
    assert!(origins.len() == 12 && origins[1..].iter().all(|&origin| origin == Origin::Followed), "{origins:?}");
    for (number, (face, fresh)) in followed.iter().flatten().zip(fresh_px(&finder, &frames)).enumerate() {
        let apart = video::apart_px(&video::px(face), &fresh);
        assert!(apart < 2.0, "frame {number}: {apart} px");
    }
}

#[test]
fn a_face_is_followed_while_it_rotates_upside_down() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let turned = |number: u64| Placement { degrees: 12.0 * number as f64, ..Placement::upright([320.0, 240.0], 1.3) };
    let frames: Vec<Photo> = (0..16).map(|number| video::frame(&model, &[turned(number)], 0.0, number)).collect();
    let followed = video::follow(&finder, &frames);
    let origins: Vec<_> = followed.iter().map(|face| face.as_ref().map(|face| face.origin)).collect();
    assert!(origins[1..].iter().all(|&origin| origin == Some(Origin::Followed)), "{origins:?}");
    let (last, truth) = (video::px(followed[15].as_ref().unwrap()), model.truth_px(&turned(15)));
    assert!(video::apart_px(&last, &truth) < 4.0, "{} px", video::apart_px(&last, &truth));
}

#[test]
fn landmarks_move_with_the_picture() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let by = [37.0, -21.0];
    let [x, y] = video::middle().at_px;
    let video_at = |at_px: [f64; 2]| -> Vec<Photo> {
        let placed = |number: u64| Placement::upright([at_px[0] + 3.0 * number as f64, at_px[1]], 1.6);
        (0..5).map(|number| video::frame(&model, &[placed(number)], 0.0, number)).collect()
    };
    let (here, there) = (video_at([x, y]), video_at([x + by[0], y + by[1]]));
    for (here, there) in followed_px(&finder, &here).iter().zip(followed_px(&finder, &there)) {
        let apart = video::apart_px(&shifted(here, by), &there);
        assert!(apart < 0.5, "{apart} px");
    }
}

#[test]
fn a_face_is_lost_when_it_leaves_and_found_when_it_returns() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let at = |x: f64| video::frame(&model, &[Placement::upright([x, 240.0], 1.6)], NOISE, x as u64);
    let mut positions: Vec<f64> = (0..14).map(|number| 400.0 + 30.0 * f64::from(number)).collect();
    positions.extend([2000.0, 320.0, 325.0]);
    let found = video::follow(&finder, &positions.iter().map(|&x| at(x)).collect::<Vec<_>>());
    let seen: Vec<Option<Origin>> = found.iter().map(|face| face.as_ref().map(|face| face.origin)).collect();
    assert!(seen[1..7].iter().all(|&origin| origin == Some(Origin::Followed)), "{seen:?}");
    assert!(seen[11..15].iter().all(Option::is_none), "{seen:?}");
    assert_eq!(seen[15..], [Some(Origin::Detected), Some(Origin::Followed)]);
}

#[test]
fn a_vanished_face_is_lost_at_once_on_any_background() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let with_face = video::frame(&model, &[video::middle()], 0.0, 0);
    for ground in Ground::ALL {
        let [width, height] = video::SIZE_PX;
        let empty = ground.picture(width, height, 7, &model.portrait);
        let found = video::follow(&finder, &[with_face.clone(), empty]);
        assert!(
            found[0].is_some() && found[1].is_none(),
            "{ground:?}: {:?}",
            found[1].as_ref().map(|face| face.presence)
        );
    }
}

#[test]
fn no_face_is_found_while_the_camera_is_covered() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let with_face = video::frame(&model, &[video::middle()], 0.0, 0);
    let [width, height] = video::SIZE_PX;
    let mut seeded = Seeded::new(5);
    for (level, noise) in [(0.0, 0.0), (8.0, 8.0), (128.0, 0.0), (60.0, 8.0), (255.0, 0.0)] {
        let pixels = (0..3 * width * height).map(|_| (level + noise * seeded.signed()) as u8).collect();
        let covered = Photo::from_rgb(width, height, pixels).unwrap();
        let dim = dimmed(&with_face, 0.15);
        let found = video::follow(&finder, &[with_face.clone(), covered.clone(), covered, dim]);
        let seen: Vec<bool> = found.iter().map(Option::is_some).collect();
        assert_eq!(seen, [true, false, false, true], "level {level}, noise {noise}");
    }
}

/// Reduces the brightness, as in a dark room.
fn dimmed(frame: &Photo, share: f64) -> Photo {
    let pixels = frame.pixels().iter().map(|&value| (f64::from(value) * share) as u8).collect();
    Photo::from_rgb(frame.width(), frame.height(), pixels).unwrap()
}

#[test]
fn a_face_that_jumps_is_found_in_the_same_frame_without_smoothing() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let at = |x: f64| video::frame(&model, &[Placement::upright([x, 200.0], 1.0)], 0.0, 0);
    let frames = [at(120.0), at(520.0)];
    let (followed, fresh) = (video::follow(&finder, &frames), fresh_px(&finder, &frames));
    let last = followed[1].as_ref().unwrap();
    assert_eq!(last.origin, Origin::Detected);
    assert_eq!(video::px(last), fresh[1]);
}

#[test]
fn gaps_decreasing_times_and_size_changes_restart_detection() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let frame = video::frame(&model, &[video::middle()], 0.0, 0);
    let portrait = support::assets::portrait();
    for (second, time_ms, origin) in [
        (&frame, 1033.0, Origin::Followed),
        (&frame, 2001.0, Origin::Detected),
        (&frame, 999.0, Origin::Detected),
        (&frame, f64::NAN, Origin::Detected),
        (&frame, f64::INFINITY, Origin::Detected),
        (&portrait, 1033.0, Origin::Detected),
    ] {
        let mut follower = Follower::default();
        video::follow_one(&finder, &mut follower, &frame, 1000.0);
        let face = video::follow_one(&finder, &mut follower, second, time_ms).unwrap();
        assert_eq!(face.origin, origin, "{time_ms} ms");
        assert!(face.landmarks.as_flattened().iter().all(|number| number.is_finite()));
    }
}

#[test]
fn frames_with_the_same_time_do_not_move_the_face() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let mut follower = Follower::default();
    let at = |x: f64| video::frame(&model, &[Placement::upright([x, 240.0], 1.6)], 0.0, 0);
    let first = video::follow_one(&finder, &mut follower, &at(300.0), 40.0).unwrap();
    let again = video::follow_one(&finder, &mut follower, &at(310.0), 40.0).unwrap();
    assert_eq!(first.landmarks, again.landmarks);
    let later = video::follow_one(&finder, &mut follower, &at(310.0), 73.0).unwrap();
    assert!(later.landmarks.as_flattened().iter().all(|number| number.is_finite()));
    assert!(later.landmarks[1][0] > first.landmarks[1][0]);
}

#[test]
fn the_larger_of_two_faces_is_followed() {
    let finder = support::attention_finder();
    let model = model(&finder);
    let faces = [Placement::upright([110.0, 240.0], 0.7), Placement::upright([430.0, 240.0], 1.4)];
    let found = video::follow(&finder, &[video::frame(&model, &faces, 0.0, 0)]);
    let nose = video::px(found[0].as_ref().unwrap())[1];
    assert!((nose[0] - 430.0).abs() < 60.0, "{nose:?}");
}

#[test]
fn tiny_and_thin_frames_have_no_face() {
    let finder = support::attention_finder();
    let mut follower = Follower::default();
    for (width, height) in [(1, 1), (1, 300), (2000, 2), (7, 5), (7, 5)] {
        let frame = Photo::from_rgb(width, height, vec![90; width as usize * height as usize * 3]).unwrap();
        assert_eq!(video::follow_one(&finder, &mut follower, &frame, 0.0), None, "{width}×{height}");
    }
}
