//! MediaPipe's landmark network with attention: a trunk finds 468 points and a feature map, and heads refine lips and
//! eyes from rotated crops of the feature map.
//!
//! Cropping and merging follow MediaPipe's TFLite operators (`landmarks_to_transform_matrix.cc`,
//! `transform_tensor_bilinear.cc`, `transform_landmarks.cc`, version 2 of each) and its graph
//! `tensors_to_face_landmarks_with_attention.pbtxt`.

mod parts;
mod region;

use crate::LandmarksError;
use crate::network::{Input, Network};
use crate::raw_mesh::{LANDMARK_COUNT, NAME, RawMesh, SIDE};
use parts::{IRIS_POINTS, LEFT_EYE, LIPS, Part, RIGHT_EYE};
use region::{CROP_SIDE, FEATURE_CHANNELS, FEATURE_SIDE, FeatureRegion};

/// The attention network, split into trunk and heads.
pub(crate) struct Attention {
    trunk: Network,
    heads: Network,
}

const TRUNK_OUTPUTS: [&str; 3] = ["output_mesh", "conv_faceflag", "p_re_lu_3"];
const HEAD_INPUTS: [&str; 3] =
    ["transform_tensor_bilinear_v2", "transform_tensor_bilinear_v2_1", "transform_tensor_bilinear_v2_2"];
const HEAD_OUTPUTS: [&str; 5] = ["conv_lips", "conv_left_eye", "conv_right_eye", "conv_left_iris", "conv_right_iris"];

/// The parts, in the order of [`HEAD_INPUTS`].
const PARTS: [&Part; 3] = [&LIPS, &RIGHT_EYE, &LEFT_EYE];

impl Attention {
    pub(crate) fn new(onnx: &[u8]) -> Result<Self, LandmarksError> {
        let picture = Input { name: "input_1", channels: 3, side: SIDE };
        let crops = HEAD_INPUTS.map(|name| Input { name, channels: FEATURE_CHANNELS, side: CROP_SIDE });
        Ok(Self {
            trunk: Network::part(NAME, onnx, &[picture], &TRUNK_OUTPUTS)?,
            heads: Network::part(NAME, onnx, &crops, &HEAD_OUTPUTS)?,
        })
    }

    /// Runs on the picture that `fill` writes. Returns 478 points in px of that picture.
    pub(crate) fn run(&self, fill: impl Fn(&mut [f32])) -> Result<RawMesh, LandmarksError> {
        let features_length = FEATURE_CHANNELS * FEATURE_SIDE * FEATURE_SIDE;
        let [points, flag, features] =
            self.trunk.run(|_, planes| fill(planes), [LANDMARK_COUNT * 3, 1, features_length])?;
        let mut points = points.as_chunks::<3>().0.to_vec();
        let regions = PARTS.map(|part| FeatureRegion::around(part, &points));
        let [_, right_eye, left_eye] = &regions;
        let answers = self.heads.run(
            |index, crop| regions[index].cut(&features, crop),
            [LIPS.points.len(), RIGHT_EYE.points.len(), LEFT_EYE.points.len(), IRIS_POINTS, IRIS_POINTS].map(|n| 2 * n),
        )?;
        let [lips, right, left, right_iris, left_iris] = &answers;
        for (part, region, answer) in
            [(&LIPS, &regions[0], lips), (&RIGHT_EYE, right_eye, right), (&LEFT_EYE, left_eye, left)]
        {
            part.move_points(&mut points, region.in_picture(answer));
        }
        for (eye, region, answer) in [(&RIGHT_EYE, right_eye, right_iris), (&LEFT_EYE, left_eye, left_iris)] {
            let z = eye.mean_lid_z(&points);
            points.extend(region.in_picture(answer).map(|[x, y]| [x, y, z]));
        }
        Ok(RawMesh { points, flag: flag[0] })
    }
}
