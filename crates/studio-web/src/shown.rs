//! Display state of the photo, the camera stream and the printed body.

use glam::{DVec2, DVec3};
use rosto_face::Photo;
use rosto_mesh::Topology;
use rosto_session::OpenFace;
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};

use crate::error::Result;

/// Display state of the edited photo, on the stage and on the panel.
#[derive(Default)]
pub(crate) struct PhotoShown {
    /// Version of the warp on the GPU; `None` while the original photo is shown.
    pub(crate) version: Option<u32>,
    /// Whether the edits have changed since the last update of the photo.
    pub(crate) is_due: bool,
    pub(crate) panel: Option<PanelPhoto>,
}

/// The part of the original photo that the panel shows.
pub(crate) struct PanelPhoto {
    pub(crate) photo: Photo,
    pub(crate) corner_px: DVec2,
    pub(crate) scale: f64,
}

/// The camera stream on the GPU.
pub(crate) struct CameraStream {
    pub(crate) on_gpu: PictureOnGpu,
    pub(crate) size_px: [u32; 2],
    /// Version of the displayed layout, if there is one.
    pub(crate) version: Option<u32>,
    /// Whether the displayed mesh is textured with the camera stream.
    pub(crate) is_on_mesh: bool,
}

/// A printed body, as the worker made it from the open face.
pub(crate) struct ShownPrint {
    pub(crate) topology: Topology,
    pub(crate) positions_m: Vec<DVec3>,
    pub(crate) colours_srgb: Vec<[u8; 3]>,
    /// Shape of the face from which it was made.
    pub(crate) face_m: Vec<DVec3>,
}

impl ShownPrint {
    pub(crate) fn is_of(&self, face: &OpenFace) -> bool {
        face.document().positions() == self.face_m
    }

    pub(crate) fn show(&self, viewport: &mut Viewport) -> Result<()> {
        let Self { topology, positions_m, colours_srgb, .. } = self;
        Ok(viewport.show(&MeshInput { topology, positions_m, colours_srgb, uvs: &[], picture: None })?)
    }
}
