use glam::{DVec3, Vec3};
use rosto_mesh::Topology;
use rosto_stage::Visibility;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::shown::ShownPrint;

/// The printed body on the stage.
#[wasm_bindgen]
impl Studio {
    /// Shows a body of the open face in its place, as the worker's `print` returns it, until the face's shape changes,
    /// the photo is displayed, or [`Self::hide_print`]. No effect while the photo is displayed.
    ///
    /// # Errors
    /// `no-face`, or `bad-face` for an invalid mesh.
    #[wasm_bindgen(js_name = showPrint)]
    pub fn show_print(
        &mut self,
        #[wasm_bindgen(js_name = positionsM)] positions_m: &[f32],
        triangles: &[u32],
        colours: &[u8],
    ) -> Result<(), JsValue> {
        let face_m = self.face()?.document().positions().to_vec();
        let positions_m = positions_m.as_chunks().0.iter().map(|&position| Vec3::from(position).as_dvec3());
        let positions_m: Vec<DVec3> = positions_m.collect();
        let topology = Topology::new(positions_m.len(), triangles.as_chunks().0.to_vec());
        let topology = topology.map_err(|_| FacadeError::no_picture())?;
        self.print = Some(ShownPrint { topology, positions_m, colours_srgb: colours.as_chunks().0.to_vec(), face_m });
        self.session.show_print(Visibility::Shown);
        self.show_later();
        Ok(())
    }

    /// Shows the face again.
    #[wasm_bindgen(js_name = hidePrint)]
    pub fn hide_print(&mut self) {
        self.session.show_print(Visibility::Hidden);
        self.show_later();
    }
}

impl Studio {
    /// Removes the body if it is hidden or outdated; returns whether it was removed.
    pub(crate) fn drop_outdated_print(&mut self) -> bool {
        let is_shown = self.session.view().print == Visibility::Shown;
        let is_current = |print: &ShownPrint| self.session.face().is_some_and(|face| print.is_of(face));
        let is_outdated = self.print.as_ref().is_some_and(|print| !is_shown || !is_current(print));
        if is_outdated {
            self.print = None;
            self.session.show_print(Visibility::Hidden);
        }
        is_outdated
    }
}
