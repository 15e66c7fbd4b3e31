use glam::{DMat3, DVec2, DVec3};
use rosto_face::{Camera, LANDMARK_COUNT, PoseFit, without_fillings};
use rosto_studio::{StreamWarp, fading};
use rosto_warp::WarpMesh;

use crate::open_face::OpenFace;
use crate::{SessionError, View};

/// The edits of the open face applied to a camera stream, frame by frame.
///
/// Edits are displacements in the model's frame. The unedited face is fitted to the landmarks of each frame, which
/// gives the pose and scale. The displacements are transformed by that pose, reduced where the face's shape differs
/// from the edited one ([`fading`]), and warp the frame as they warp a photo.
#[derive(Default)]
pub struct LivePreview {
    landmarks: Vec<[f32; 3]>,
    size_px: [u32; 2],
    is_seen: bool,
    camera: Option<Camera>,
    /// Position of each displayed vertex, in metres in the model's frame: as seen by the camera, and with the edits.
    seen_m: Vec<DVec3>,
    edited_m: Vec<DVec3>,
    uvs: Vec<DVec2>,
    stream_warp: StreamWarp,
}

/// Height of a frame in metres before a face is found. The value has no visible effect, because the whole frame is
/// shown.
const HEIGHT_M: f64 = 0.4;

impl LivePreview {
    /// Whether the last frame contains a face.
    pub fn is_seen(&self) -> bool {
        self.is_seen
    }

    /// Width and height of the last frame, in px.
    pub fn size_px(&self) -> [u32; 2] {
        self.size_px
    }

    /// Positions of the face as last seen, one per displayed vertex, in metres in the model's frame; empty before the
    /// first.
    pub fn seen_m(&self) -> &[DVec3] {
        &self.seen_m
    }

    /// Positions of the face as last seen, with the edits.
    pub fn edited_m(&self) -> &[DVec3] {
        &self.edited_m
    }

    /// Position in that frame of each displayed vertex, 0..=1 from its top left.
    pub fn uvs(&self) -> &[DVec2] {
        &self.uvs
    }

    /// The moved part of the frame, in its px, and the version of the layout ([`StreamWarp::warp_mesh`]).
    pub fn warp_mesh(&self) -> (&WarpMesh, u32) {
        self.stream_warp.warp_mesh()
    }

    /// Camera of the last fit, or a frontal one before the first.
    pub(crate) fn camera(&self) -> Camera {
        self.camera.unwrap_or_else(|| front(self.size_px))
    }

    pub(crate) fn set_frame(&mut self, landmarks: Option<&[[f32; 3]]>, size_px: [u32; 2]) {
        self.size_px = size_px;
        self.is_seen = landmarks.is_some();
        if let Some(landmarks) = landmarks {
            self.landmarks = landmarks.to_vec();
        }
    }

    /// Fits the open face to the last frame; `None` if it contains no face.
    pub(crate) fn pose_fit(&self, face: &OpenFace) -> Result<Option<PoseFit>, SessionError> {
        let seen = self.is_seen.then_some(self.landmarks.as_slice());
        pose_fit(face, seen, self.size_px)
    }

    /// Applies the edits to the last frame.
    pub(crate) fn follow(&mut self, pose_fit: Option<PoseFit>, face: &OpenFace, view: &View) {
        let Some(PoseFit { camera, positions_m }) = pose_fit else { return self.stream_warp.reset() };
        let (model_m, document) = (face.model().positions_m(), face.document());
        let weights = document.from_cage(&fading(face.model().topology(), model_m, &positions_m));
        self.seen_m = document.from_cage(&positions_m);
        let moved = document.positions().iter().zip(document.rest()).zip(weights);
        self.edited_m.clear();
        self.edited_m.extend(
            self.seen_m.iter().zip(moved).map(|(seen, ((now, rest), weights))| *seen + (*now - *rest) * weights),
        );
        let uv = |landmark: &[f32; 3]| DVec2::new(landmark[0].into(), landmark[1].into());
        let uvs: Vec<DVec2> = self.landmarks[..LANDMARK_COUNT].iter().map(uv).collect();
        self.uvs = document.from_cage(&uvs);
        self.camera = Some(camera);
        // The warp is smooth: points denser than the edited level would cost time without a visible difference.
        let driving_mesh = document.topology_at(document.edited_level()).unwrap_or(document.topology());
        let project = |position_m: &DVec3| camera.project(*position_m).unwrap_or(DVec2::NAN);
        let with_depth = |seen: &DVec3| project(seen).extend(camera.towards_camera_m(*seen));
        let positions: Vec<DVec3> = self.seen_m[..driving_mesh.vertex_count()].iter().map(with_depth).collect();
        let targets_px: Vec<DVec2> = self.edited_m[..driving_mesh.vertex_count()].iter().map(project).collect();
        let skin = || without_fillings(face.model().topology().triangles(), driving_mesh.triangles());
        // A face that is almost outside the frame cannot drive the warp.
        if self.stream_warp.follow(skin, &positions, &targets_px, self.size_px, view.falloff_band).is_err() {
            self.stream_warp.reset();
        }
    }
}

/// Fits the open face to the landmarks of a frame; `None` without landmarks.
pub(crate) fn pose_fit(
    face: &OpenFace,
    landmarks: Option<&[[f32; 3]]>,
    size_px: [u32; 2],
) -> Result<Option<PoseFit>, SessionError> {
    let seen = landmarks.map(|landmarks| PoseFit::new(face.model().positions_m(), landmarks, size_px));
    Ok(seen.transpose()?)
}

fn front(size_px: [u32; 2]) -> Camera {
    let size_px = DVec2::from(size_px.map(f64::from));
    Camera::parallel(DMat3::IDENTITY, DVec3::ZERO, size_px.y / HEIGHT_M, size_px / 2.0)
}
