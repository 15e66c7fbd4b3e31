//! Display state of the photo and the camera stream.

use glam::DVec2;
use rosto_face::Photo;
use rosto_viewport::PictureOnGpu;

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
