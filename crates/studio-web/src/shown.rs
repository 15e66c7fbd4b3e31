//! The photo and the camera's camera stream, as they are shown.

use glam::DVec2;
use rosto_face::Photo;
use rosto_viewport::PictureOnGpu;

/// The photo as it follows the edits, on the stage and on the panel.
#[derive(Default)]
pub(crate) struct PhotoShown {
    /// Of the warp on the GPU; none while the photo is there as it was taken.
    pub(crate) version: Option<u32>,
    /// Whether the edits have gone on since the photo followed them.
    pub(crate) is_due: bool,
    pub(crate) panel: Option<PanelPhoto>,
}

/// The part of the photo that the panel shows, as it was taken.
pub(crate) struct PanelPhoto {
    pub(crate) photo: Photo,
    pub(crate) corner_px: DVec2,
    pub(crate) scale: f64,
}

/// The camera stream on the GPU, and what of it is shown.
pub(crate) struct CameraStream {
    pub(crate) on_gpu: PictureOnGpu,
    pub(crate) size_px: [u32; 2],
    /// Of the layout that is shown; none before there is one.
    pub(crate) version: Option<u32>,
    /// Whether the mesh that is shown has the camera stream on it.
    pub(crate) is_on_mesh: bool,
}
