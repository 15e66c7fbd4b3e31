use glam::DVec2;
use js_sys::Error;
use rosto_photo::{Limits, Photo, decode};
use rosto_warp::{WarpMesh, drawn};
use wasm_bindgen::prelude::*;

use crate::error;

/// A photo with what was edited in it. `free()` it when everything has been taken out.
#[wasm_bindgen]
pub struct Warped {
    photo: Photo,
}

#[wasm_bindgen]
impl Warped {
    /// Draws a photo (the bytes of a JPEG, PNG or WebP file) upright and at its full size, with its places moved: `from` and
    /// `to` hold x and y in turn, in px of a copy of the photo `width` px wide, and `triangles` three places each.
    ///
    /// # Errors
    /// Throws what `Vision.find` throws of the photo, and `internal` for triangles that do not fit.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8], width: u32, from: &[f64], to: &[f64], triangles: &[u32]) -> Result<Self, Error> {
        console_error_panic_hook::set_once();
        let photo = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
        let scale = f64::from(photo.width()) / f64::from(width.max(1));
        let warp_mesh = warp_mesh(from, to, triangles).ok_or_else(|| error::internal("triangles that do not fit"))?;
        Ok(Self { photo: drawn(&photo, &warp_mesh.cut(DVec2::ZERO, scale)) })
    }

    /// Width in px.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.photo.width()
    }

    /// Height in px.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.photo.height()
    }

    /// Its pixels, RGBA.
    pub fn pixels(&self) -> Vec<u8> {
        self.photo.rgba()
    }
}

fn warp_mesh(from: &[f64], to: &[f64], triangles: &[u32]) -> Option<WarpMesh> {
    let places = |flat: &[f64]| flat.as_chunks::<2>().0.iter().map(|&place| DVec2::from(place)).collect::<Vec<_>>();
    let (from_px, to_px, triangles) = (places(from), places(to), triangles.as_chunks::<3>().0.to_vec());
    let fits =
        from_px.len() == to_px.len() && triangles.iter().flatten().all(|&corner| (corner as usize) < from_px.len());
    fits.then_some(WarpMesh { from_px, to_px, triangles })
}
