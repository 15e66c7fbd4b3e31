use glam::DVec2;
use rosto_photo::Photo;
use rosto_studio::PhotoWarp;
use rosto_warp::{Dab, drawn};

use crate::{Error, FaceMesh, PhotoEdit};

/// A photo to be drawn with the edits of its face.
pub struct PhotoRequest<'a> {
    /// The whole upright photo, in any size.
    pub photo: &'a Photo,
    /// The edited face; its lead photo is this one.
    pub mesh: &'a FaceMesh,
    /// Width of the band around the face in which the warp fades out, as a share of the face's longer side.
    pub falloff_band: f64,
    /// Edits of the photo alone.
    pub edit: PhotoEdit,
}

/// An edited photo.
pub struct EditedPhoto {
    /// The photo, upright, in its own size.
    pub photo: Photo,
    /// Greatest distance in px by which it lags behind the edits to avoid folds.
    pub limited_px: f64,
}

impl PhotoRequest<'_> {
    /// Warps the photo.
    ///
    /// # Errors
    /// [`Error::OtherPhoto`] if the photo's shape is not that of the face's photo, or [`Error::Studio`] if too little of
    /// the face lies in it.
    pub fn image(&self) -> Result<EditedPhoto, Error> {
        let (face, document) = (self.mesh.face(), self.mesh.document());
        let (found_px, face_px) = ([self.photo.width(), self.photo.height()], face.photo_size_px());
        if !have_one_shape(found_px, face_px) {
            return Err(Error::OtherPhoto { found_px, face_px });
        }
        let protected: Vec<Dab> = self.edit.strokes.iter().flatten().copied().collect();
        let mut warp = PhotoWarp::new(face, document, self.falloff_band, &protected)?;
        let seen_by = self.edit.seen_from_m.map_or(*face.camera(), |distance_m| face.seen_from(distance_m));
        warp.follow(document.rest(), document.positions(), face.camera(), &seen_by);
        let scale = f64::from(found_px[0]) / f64::from(face_px[0]);
        let photo = drawn(self.photo, &warp.warp_mesh().cut(DVec2::ZERO, scale));
        Ok(EditedPhoto { photo, limited_px: warp.limited_px() })
    }
}

/// Whether one picture is the other in another size, within the rounding of a side.
fn have_one_shape([width, height]: [u32; 2], [other_width, other_height]: [u32; 2]) -> bool {
    let across = u64::from(width) * u64::from(other_height);
    across.abs_diff(u64::from(height) * u64::from(other_width)) <= u64::from(other_width.max(other_height))
}
