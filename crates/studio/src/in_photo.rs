use std::ops::RangeInclusive;

use glam::{DVec2, DVec3};
use rosto_face::{Camera, FaceModel, without_fillings};
use rosto_warp::{self as warp, Dab, Subject, Warp, WarpMesh};

use crate::{Document, StudioError};

/// How far around the face a photo can give way, in shares of the face's longer side.
pub const FALLOFF_BAND_SHARES: RangeInclusive<f64> = 0.1..=0.8;

/// And how far it does if nobody says otherwise.
pub const DEFAULT_FALLOFF_BAND: f64 = 0.35;

/// What lies less than this behind the surface is seen all the same, in metres.
const BEHIND_M: f64 = 0.004;

/// Lids and lips lead where they are further apart than this, in shares of the face's longer side: some 3 mm.
const APART: f64 = 0.02;

/// The edits of a face in its photo: what of the mesh the photo's camera sees leads the picture, which gives way around it.
pub struct InPhoto {
    /// Vertices of the mesh that lead.
    vertices: Vec<u32>,
    from_px: Vec<DVec2>,
    to_px: Vec<DVec2>,
    warp: Warp,
}

impl InPhoto {
    /// Of the mesh that a document shows. The photo gives way around it by `falloff band`, a share of the face's longer side within
    /// [`FALLOFF_BAND_SHARES`], and stays where `kept` says, in its px.
    ///
    /// # Errors
    /// [`StudioError::Warp`] where too little of the face lies in its photo.
    pub fn new(face: &FaceModel, document: &Document, falloff_band: f64, kept: &[Dab]) -> Result<Self, StudioError> {
        let camera = face.camera();
        let places: Vec<DVec3> = document.rest().iter().map(|&place_m| place(camera, place_m)).collect();
        let skin = without_fillings(face.topology().triangles(), document.topology().triangles());
        let (vertices, from_px) = leading(&skin, &places);
        let falloff_band_px = falloff_band * longer_side(&from_px);
        let subject = Subject { size_px: face.photo_size_px(), points_px: &from_px, falloff_band_px, kept };
        let warp = Warp::new(&subject)?;
        Ok(Self { vertices, to_px: from_px.clone(), from_px, warp })
    }

    /// Lets the photo follow vertices from `rest_m`, as the camera `from` sees them, to `now_m`, as `to` does: the photo's own
    /// camera, or that one from another distance. Metres in the model's frame; one back-substitution for each axis.
    pub fn follow(&mut self, rest_m: &[DVec3], now_m: &[DVec3], from: &Camera, to: &Camera) {
        for ((target, from_px), &vertex) in self.to_px.iter_mut().zip(&self.from_px).zip(&self.vertices) {
            let places = (from.project(rest_m[vertex as usize]), to.project(now_m[vertex as usize]));
            // What a camera does not see leads nowhere.
            let way = if let (Some(before), Some(after)) = places { after - before } else { DVec2::ZERO };
            *target = *from_px + way;
        }
        self.warp.follow(&self.from_px, &self.to_px);
    }

    /// What of the photo moves, in its px.
    pub fn warp_mesh(&self) -> &WarpMesh {
        self.warp.warp_mesh()
    }

    /// By how much the photo stays behind the mesh at most, in px, so that nothing in it folds.
    pub fn limited_px(&self) -> f64 {
        self.warp.limited_px()
    }
}

fn place(camera: &Camera, place_m: DVec3) -> DVec3 {
    camera.project(place_m).unwrap_or(DVec2::NAN).extend(camera.towards_camera_m(place_m))
}

/// The vertices of a face's skin that lead what is around them, and where they are, of places in px, y down, and metres towards
/// the camera.
pub(crate) fn leading(skin: &[[u32; 3]], places: &[DVec3]) -> (Vec<u32>, Vec<DVec2>) {
    let finite: Vec<DVec2> = places.iter().filter(|place| place.is_finite()).map(|place| place.truncate()).collect();
    let leads = warp::leading(skin, places, BEHIND_M, APART * longer_side(&finite));
    let leading = (0..).zip(places).zip(leads).filter(|(_, leads)| *leads);
    leading.map(|((vertex, place), _)| (vertex, place.truncate())).unzip()
}

pub(crate) fn longer_side(places: &[DVec2]) -> f64 {
    let first = places.first().copied().unwrap_or_default();
    let (low, high) = places.iter().fold((first, first), |(low, high), place| (low.min(*place), high.max(*place)));
    (high - low).max_element()
}
