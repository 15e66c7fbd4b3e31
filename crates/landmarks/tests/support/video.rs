//! Synthetic videos of the portrait with known face positions.

use rosto_landmarks::{FaceFinder, FollowedFace, Follower};
use rosto_photo::Photo;

use super::scenes::canvas::Ground;
use super::scenes::filters::Filter;
use super::scenes::{Model, Part, Placement, Scene};

pub const SIZE_PX: [u32; 2] = [640, 480];
pub const FRAME_MS: f64 = 1000.0 / 30.0;

/// A centred face, of a typical size for a laptop camera.
pub fn middle() -> Placement {
    Placement::upright([320.0, 240.0], 1.6)
}

/// One frame: the head on a static background, with noise of the given amplitude, of 255.
pub fn frame(model: &Model, faces: &[Placement], noise: f64, number: u64) -> Photo {
    let filter = if noise > 0.0 { Filter::Noise(noise) } else { Filter::None };
    let scene = Scene {
        family: "video",
        name: String::new(),
        size_px: SIZE_PX,
        ground: Ground::Gradient,
        seed: number,
        part: Part::Head,
        faces: faces.to_vec(),
        filter,
    };
    scene.picture(model)
}

/// Follows the face through frames at an interval of [`FRAME_MS`].
pub fn follow(finder: &FaceFinder, frames: &[Photo]) -> Vec<Option<FollowedFace>> {
    let mut follower = Follower::default();
    let moments = (0..).map(|number| f64::from(number) * FRAME_MS);
    frames.iter().zip(moments).map(|(frame, time_ms)| follow_one(finder, &mut follower, frame, time_ms)).collect()
}

pub fn follow_one(finder: &FaceFinder, follower: &mut Follower, frame: &Photo, time_ms: f64) -> Option<FollowedFace> {
    finder.follow(follower, frame, time_ms).expect("the networks run")
}

/// x and y of each landmark in px of a frame.
pub fn px(face: &FollowedFace) -> Vec<[f64; 2]> {
    let size = SIZE_PX.map(f64::from);
    face.landmarks.iter().map(|landmark| [0, 1].map(|axis| f64::from(landmark[axis]) * size[axis])).collect()
}

/// Root mean square distance of the landmarks in all frames from their mean positions, px.
pub fn jitter_px(frames: &[Vec<[f64; 2]>]) -> f64 {
    let mut squares = 0.0;
    for landmark in 0..frames[0].len() {
        for axis in [0, 1] {
            let along = || frames.iter().map(|frame| frame[landmark][axis]);
            let mean = along().sum::<f64>() / frames.len() as f64;
            squares += along().map(|at| (at - mean).powi(2)).sum::<f64>();
        }
    }
    (squares / (frames.len() * frames[0].len()) as f64).sqrt()
}

/// Root mean square distance between landmarks, px.
pub fn apart_px(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let squares = a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Mean lag of the landmarks of a face that moves to the right, ms.
pub fn lag_ms(found: &[[f64; 2]], truth: &[[f64; 2]], speed_px_s: f64) -> f64 {
    let behind = found.iter().zip(truth).map(|(found, truth)| truth[0] - found[0]);
    1000.0 * behind.sum::<f64>() / found.len() as f64 / speed_px_s
}
