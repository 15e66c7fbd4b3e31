use glam::DVec2;
use js_sys::Error;
use rosto_photo::{Limits, Photo, decode};
use rosto_warp::{WarpMesh, drawn};
use wasm_bindgen::prelude::*;

use crate::error;

/// An edited photo. Call `free()` after reading the results.
#[wasm_bindgen]
pub struct Warped {
    photo: Photo,
}

#[wasm_bindgen]
impl Warped {
    /// Warps a photo (the bytes of a JPEG, PNG or WebP file), upright and at full size. `from` and `to` hold
    /// alternating x and y in px of a copy of the photo that is `width` px wide; `triangles` holds three point indices
    /// each.
    ///
    /// # Errors
    /// Throws the photo errors of `Vision.find`, and `internal` for an invalid mesh.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8], width: u32, from: &[f64], to: &[f64], triangles: &[u32]) -> Result<Self, Error> {
        console_error_panic_hook::set_once();
        let photo = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
        let scale = f64::from(photo.width()) / f64::from(width.max(1));
        let warp_mesh = warp_mesh(from, to, triangles).ok_or_else(|| error::internal("invalid warp mesh"))?;
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

    /// RGBA pixels.
    pub fn pixels(&self) -> Vec<u8> {
        self.photo.rgba()
    }
}

fn warp_mesh(from: &[f64], to: &[f64], triangles: &[u32]) -> Option<WarpMesh> {
    let positions =
        |flat: &[f64]| flat.as_chunks::<2>().0.iter().map(|&position| DVec2::from(position)).collect::<Vec<_>>();
    let (from_px, to_px, triangles) = (positions(from), positions(to), triangles.as_chunks::<3>().0.to_vec());
    let fits =
        from_px.len() == to_px.len() && triangles.iter().flatten().all(|&corner| (corner as usize) < from_px.len());
    fits.then_some(WarpMesh { from_px, to_px, triangles })
}
