//! Printable bodies.

mod choices;
mod facts;

pub use choices::{DEPTH_MM, HEIGHT_MM, ParseHeightError, ParseSolidError, PrintHeight, SOLID_MM, Solid};
pub use facts::{PrintPose, SolidFacts};

use glam::DVec3;
use rosto_face::CarvedEyes;
use rosto_mesh::Surface;
use rosto_solid::{Body, Carving, Closing};

use crate::model::MM_PER_M;
use crate::{ExportError, Model};
use choices::{BACK_MM, extent};
use facts::THIN;

/// A body for 3D printing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Print {
    /// Its shape.
    pub solid: Solid,
    /// Its height. Lengths of `solid` are those of the print.
    pub height: PrintHeight,
}

/// The body of a print.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintedBody {
    /// The body, in metres.
    pub body: Body,
    /// Size of the print, relative to the face.
    pub scale: f64,
    /// sRGB colour of each vertex of its front.
    pub colours_srgb: Vec<[u8; 3]>,
}

impl PrintedBody {
    /// Positions in metres, as large as the face.
    pub fn face_sized_m(&self) -> Vec<DVec3> {
        self.body.positions_m().iter().map(|position| *position / self.scale).collect()
    }

    /// sRGB colour of each vertex: clay, and amber where the wall is notably thinner than requested.
    pub fn thinness_colours(&self, solid: Solid) -> Vec<[u8; 3]> {
        let front = self.body.front_vertices();
        let is_thin = |vertex: usize| match solid {
            // A wall's back has a vertex behind each of the first ones, those of the uncarved front.
            Solid::Thickness { mm } => {
                let of_front = if vertex < front { vertex } else { vertex - front };
                self.body.thickness_m()[of_front] < THIN * mm / MM_PER_M
            }
            Solid::FlatBack { .. } | Solid::Surface => false,
        };
        (0..self.body.positions_m().len()).map(|vertex| if is_thin(vertex) { AMBER } else { CLAY }).collect()
    }
}

/// Largest relative difference from the chosen height.
const MAX_HEIGHT_ERROR: f64 = 0.001;

/// Grid to which the surface of a print is rounded. Solvers on different machines differ in the last bits, and the
/// separation of crossing triangles would turn that into tenths of a millimetre.
const ROUNDED_M: f64 = 1e-7;

/// Closes the surface of a scaled model.
fn closed(model: &Model<'_>, scale: DVec3, closing: Closing) -> Result<Body, ExportError> {
    let rounded = |position: &DVec3| (*position * scale / ROUNDED_M).round() * ROUNDED_M;
    let scaled = |positions_m: &[DVec3]| positions_m.iter().map(rounded).collect::<Vec<_>>();
    let (positions_m, smoothed_m) = (scaled(model.positions_m), model.smoothed_m.map(scaled));
    let surface = Surface::new(model.topology, &positions_m).map_err(rosto_solid::SolidError::from)?;
    Ok(Body::closed_or_smoothed(surface, smoothed_m.as_ref().unwrap_or(&positions_m), closing)?)
}

/// Colours of a printed body on the stage.
const CLAY: [u8; 3] = [0xc9, 0xbd, 0xb0];
const AMBER: [u8; 3] = [0xf0, 0x9a, 0x14];

impl Print {
    /// Makes the body from a model; `None` for [`Solid::Surface`]. The model's eyes are carved. The surface is rounded to
    /// 0.1 µm, so that each machine makes the same body.
    ///
    /// # Errors
    /// [`ExportError`] if a length does not match, a position is not finite, the mesh is empty, or the body cannot be
    /// made.
    pub fn body(self, model: &Model<'_>) -> Result<Option<PrintedBody>, ExportError> {
        model.check()?;
        let closing = match self.solid {
            Solid::Surface => return Ok(None),
            Solid::Thickness { mm } => Closing::Thickness { thickness_m: mm / MM_PER_M },
            Solid::FlatBack { .. } => Closing::FlatBack { thickness_m: BACK_MM / MM_PER_M },
        };
        let mut scale = self.scale(model.positions_m);
        let mut body = closed(model, scale, closing)?;
        // Smoothing can lower the highest or raise the lowest point.
        let printed_m = extent(&body.positions_m()[..body.front_vertices()], 1);
        let times = scale.y * extent(model.positions_m, 1) / printed_m;
        if self.height != PrintHeight::Life && (times - 1.0).abs() > MAX_HEIGHT_ERROR {
            scale *= times;
            body = closed(model, scale, closing)?;
        }
        let Some(eyes) = model.eyes else {
            return Ok(Some(PrintedBody { body, scale: scale.y, colours_srgb: model.colours_srgb.to_vec() }));
        };
        let front_m = &body.positions_m()[..body.front_vertices()];
        let eyes = CarvedEyes::new(eyes.face, model.topology, front_m, eyes.gazes);
        // A flat relief has room for flat eyes only.
        let depth_share = (2.0 * scale.z / scale.y).min(1.0);
        let depths_m: Vec<f64> = eyes.depths(front_m).into_iter().map(|depth_m| depth_share * depth_m).collect();
        let carving = Carving { topology: eyes.topology(), midpoints: eyes.midpoints(), depths_m: &depths_m };
        let body = body.carved(model.topology, &carving);
        let mut colours_srgb = eyes.colours(model.colours_srgb);
        colours_srgb.truncate(body.front_vertices());
        Ok(Some(PrintedBody { body, scale: scale.y, colours_srgb }))
    }

    /// Factors along x, y and z from the face to its print.
    fn scale(self, positions_m: &[DVec3]) -> DVec3 {
        let [face_height_mm, face_depth_mm] = [1, 2].map(|axis| extent(positions_m, axis) * MM_PER_M);
        let scale = if self.height == PrintHeight::Life { 1.0 } else { self.height.mm(positions_m) / face_height_mm };
        let Solid::FlatBack { depth_mm } = self.solid else { return DVec3::splat(scale) };
        let depth_mm = depth_mm.unwrap_or_else(|| Solid::usual_depth_mm(scale * face_height_mm));
        DVec3::new(scale, scale, scale.min((depth_mm - BACK_MM) / face_depth_mm))
    }
}
