use std::ops::RangeInclusive;

use glam::{DVec2, DVec3};
use rosto_face::{Camera, FaceModel, without_fillings};
use rosto_warp::{self as warp, Dab, Subject, Warp, WarpMesh};

use crate::{Document, StudioError};

/// Range of the falloff band, as a share of the longer side of the face.
pub const FALLOFF_BAND_SHARES: RangeInclusive<f64> = 0.1..=0.8;

/// Default falloff band, as a share of the longer side of the face.
pub const DEFAULT_FALLOFF_BAND: f64 = 0.45;

/// Stiff strip around the face, as a share of its longer side: room for the skin beyond the control points, and an ear.
pub(crate) const STIFF_STRIP: f64 = 0.18;

/// Depth tolerance of the visibility test, in metres.
const BEHIND_M: f64 = 0.004;

/// Lids and lips that are farther apart than this drive the warp; share of the face's longer side (about 3 mm).
const APART_SHARE: f64 = 0.02;

/// Edits of a face applied to its photo. The vertices that the photo's camera sees drive a warp, which falls off around
/// the face.
pub struct PhotoWarp {
    /// Vertices that drive the warp.
    vertices: Vec<u32>,
    from_px: Vec<DVec2>,
    to_px: Vec<DVec2>,
    warp: Warp,
}

impl PhotoWarp {
    /// Creates the warp for a document's displayed mesh. `falloff_band` is a share of the face's longer side within
    /// [`FALLOFF_BAND_SHARES`]. The photo does not move under `protected`, in its px.
    ///
    /// # Errors
    /// [`StudioError::Warp`] if too little of the face lies in its photo.
    pub fn new(
        face: &FaceModel,
        document: &Document,
        falloff_band: f64,
        protected: &[Dab],
    ) -> Result<Self, StudioError> {
        let camera = face.camera();
        let size_px = DVec2::from(face.photo_size_px().map(f64::from));
        // The found landmarks, since those on the hidden side of the model have left their rays.
        let found_px = document.from_cage(face.uvs()).into_iter().map(|uv| uv * size_px);
        let positions: Vec<DVec3> = (found_px.zip(document.rest()))
            .map(|(found_px, &position_m)| found_px.extend(camera.towards_camera_m(position_m)))
            .collect();
        let skin = without_fillings(face.topology().triangles(), document.topology().triangles());
        let (vertices, from_px) = driving_vertices(&skin, &positions);
        let side_px = longer_side(&from_px);
        let subject = Subject {
            size_px: face.photo_size_px(),
            points_px: &from_px,
            falloff_band_px: falloff_band * side_px,
            stiff_strip_px: STIFF_STRIP * side_px,
            protected,
        };
        let warp = Warp::new(&subject)?;
        Ok(Self { vertices, to_px: from_px.clone(), from_px, warp })
    }

    /// Moves the photo with the vertices, from `rest_m` seen by the camera `from` to `now_m` seen by `to`: the photo's
    /// camera, or the same at another distance. Positions are in metres in the model's frame. Costs one back
    /// substitution of both axes.
    pub fn follow(&mut self, rest_m: &[DVec3], now_m: &[DVec3], from: &Camera, to: &Camera) {
        for ((target, from_px), &vertex) in self.to_px.iter_mut().zip(&self.from_px).zip(&self.vertices) {
            let positions = (from.project(rest_m[vertex as usize]), to.project(now_m[vertex as usize]));
            // Vertices outside a camera's view do not drive the warp.
            let displacement = if let (Some(before), Some(after)) = positions { after - before } else { DVec2::ZERO };
            *target = *from_px + displacement;
        }
        self.warp.follow(&self.from_px, &self.to_px);
    }

    /// The moved part of the photo, in its px.
    pub fn warp_mesh(&self) -> &WarpMesh {
        self.warp.warp_mesh()
    }

    /// Greatest distance, in px, by which the photo lags behind the mesh to avoid folds.
    pub fn limited_px(&self) -> f64 {
        self.warp.limited_px()
    }
}

/// The vertices of a face's skin that drive a warp, with their positions in px. `places` are in px, y down, and metres
/// towards the camera.
pub(crate) fn driving_vertices(skin: &[[u32; 3]], positions: &[DVec3]) -> (Vec<u32>, Vec<DVec2>) {
    let finite: Vec<DVec2> =
        positions.iter().filter(|position| position.is_finite()).map(|position| position.truncate()).collect();
    let drives = warp::leading(skin, positions, BEHIND_M, APART_SHARE * longer_side(&finite));
    let driving = (0..).zip(positions).zip(drives).filter(|(_, drives)| *drives);
    driving.map(|((vertex, position), _)| (vertex, position.truncate())).unzip()
}

pub(crate) fn longer_side(positions: &[DVec2]) -> f64 {
    let first = positions.first().copied().unwrap_or_default();
    let (low, high) =
        positions.iter().fold((first, first), |(low, high), position| (low.min(*position), high.max(*position)));
    (high - low).max_element()
}
