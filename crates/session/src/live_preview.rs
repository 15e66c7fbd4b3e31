use glam::{DMat3, DVec2, DVec3};
use rosto_face::{Camera, LANDMARK_COUNT, PoseFit, without_fillings};
use rosto_studio::{StreamWarp, fading};
use rosto_warp::WarpMesh;

use crate::open_face::OpenFace;
use crate::{SessionError, View};

/// The open face's edits on the face of whoever is before the camera, frame by frame.
///
/// The edits are ways in the model's frame. The open face, as it was found, is fitted to the landmarks of each frame, which tells
/// where that frame is and how large; the ways are taken there, less where the face has another shape than the one that was edited
/// ([`fading`]), and lead the frame as they lead a photo.
#[derive(Default)]
pub struct LivePreview {
    landmarks: Vec<[f32; 3]>,
    size_px: [u32; 2],
    is_seen: bool,
    camera: Option<Camera>,
    /// Of every vertex shown, in metres in the model's frame: as the camera sees it, and with the edits.
    seen_m: Vec<DVec3>,
    edited_m: Vec<DVec3>,
    uvs: Vec<DVec2>,
    stream_warp: StreamWarp,
}

/// So many metres are as high as a frame in which no face has been seen yet. Any number would do: all of the frame is shown.
const HEIGHT_M: f64 = 0.4;

impl LivePreview {
    /// Whether the last frame had a face in it.
    pub fn is_seen(&self) -> bool {
        self.is_seen
    }

    /// Width and height of the last frame in px.
    pub fn size_px(&self) -> [u32; 2] {
        self.size_px
    }

    /// The face as the camera saw it last, every vertex shown, in metres in the model's frame; empty before one was seen.
    pub fn seen_m(&self) -> &[DVec3] {
        &self.seen_m
    }

    /// The same with the edits.
    pub fn edited_m(&self) -> &[DVec3] {
        &self.edited_m
    }

    /// Places in that frame for every vertex shown, 0..=1 from its top left.
    pub fn uvs(&self) -> &[DVec2] {
        &self.uvs
    }

    /// What of the frame moves, in its px, and the number of the layout ([`StreamWarp::warp mesh`]).
    pub fn warp_mesh(&self) -> (&WarpMesh, u32) {
        self.stream_warp.warp_mesh()
    }

    /// What saw the face last, or would see one in the middle of the frame.
    pub(crate) fn camera(&self) -> Camera {
        self.camera.unwrap_or_else(|| front(self.size_px))
    }

    pub(crate) fn take(&mut self, landmarks: Option<&[[f32; 3]]>, size_px: [u32; 2]) {
        self.size_px = size_px;
        self.is_seen = landmarks.is_some();
        if let Some(landmarks) = landmarks {
            self.landmarks = landmarks.to_vec();
        }
    }

    /// Where the open face is in the frame that was taken last; none where no face is in it.
    pub(crate) fn pose_fit(&self, face: &OpenFace) -> Result<Option<PoseFit>, SessionError> {
        let seen = self.is_seen.then_some(self.landmarks.as_slice());
        pose_fit(face, seen, self.size_px)
    }

    /// Brings the edits to the frame that was taken last.
    pub(crate) fn follow(&mut self, pose_fit: Option<PoseFit>, face: &OpenFace, view: &View) {
        let Some(PoseFit { camera, positions_m }) = pose_fit else { return self.stream_warp.rest() };
        let (known_m, document) = (face.model().positions_m(), face.document());
        let left = document.from_cage(&fading(face.model().topology(), known_m, &positions_m));
        self.seen_m = document.from_cage(&positions_m);
        let ways = document.positions().iter().zip(document.rest()).zip(left);
        self.edited_m.clear();
        self.edited_m
            .extend(self.seen_m.iter().zip(ways).map(|(seen, ((now, rest), left))| *seen + (*now - *rest) * left));
        let uv = |landmark: &[f32; 3]| DVec2::new(landmark[0].into(), landmark[1].into());
        let uvs: Vec<DVec2> = self.landmarks[..LANDMARK_COUNT].iter().map(uv).collect();
        self.uvs = document.from_cage(&uvs);
        self.camera = Some(camera);
        // The frame follows smoothly whatever leads it: denser points than those that were moved would only cost time.
        let leads = document.topology_at(document.edited_level()).unwrap_or(document.topology());
        let place = |place_m: &DVec3| camera.project(*place_m).unwrap_or(DVec2::NAN);
        let placed = |seen: &DVec3| place(seen).extend(camera.towards_camera_m(*seen));
        let places: Vec<DVec3> = self.seen_m[..leads.vertex_count()].iter().map(placed).collect();
        let targets_px: Vec<DVec2> = self.edited_m[..leads.vertex_count()].iter().map(place).collect();
        let skin = || without_fillings(face.model().topology().triangles(), leads.triangles());
        // A face that is as good as outside of the frame leads nothing in it.
        if self.stream_warp.follow(skin, &places, &targets_px, self.size_px, view.falloff_band).is_err() {
            self.stream_warp.rest();
        }
    }
}

/// Where the open face is in a frame with these landmarks; none without any.
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
