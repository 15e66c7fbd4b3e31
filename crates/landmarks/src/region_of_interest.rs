use std::f64::consts::PI;

use crate::outline::Outline;

/// A rotated rectangle in a picture. x and widths are in units of the picture's width, y and heights in units of its
/// height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegionOfInterest {
    /// Centre (x, y), normalised.
    pub centre: [f32; 2],
    /// Width and height, normalised. They differ for a square in px unless the picture is square.
    pub size: [f32; 2],
    /// Clockwise rotation, in [−π, π).
    pub rotation_rad: f32,
}

/// A rotated rectangle in px.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RegionPx {
    pub(crate) centre: [f32; 2],
    pub(crate) size: [f32; 2],
    pub(crate) rotation_rad: f32,
}

/// Size of a picture, px.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PictureSize {
    pub(crate) width: f32,
    pub(crate) height: f32,
}

impl RegionOfInterest {
    /// A square around a box, with 1.5 × its longer side in px. It is rotated so that the direction from `start` to
    /// `end` points right.
    pub(crate) fn around(Outline { min, max }: Outline, [start, end]: [[f32; 2]; 2], picture: PictureSize) -> Self {
        const ENLARGEMENT: f32 = 1.5;
        let size = [0, 1].map(|axis| max[axis] - min[axis]);
        let centre = [0, 1].map(|axis| min[axis] + size[axis] / 2.0);
        let long_px = (size[0] * picture.width).max(size[1] * picture.height);
        let dx_px = end[0] * picture.width - start[0] * picture.width;
        let dy_px = end[1] * picture.height - start[1] * picture.height;
        Self {
            centre,
            size: [long_px / picture.width * ENLARGEMENT, long_px / picture.height * ENLARGEMENT],
            rotation_rad: normalised_angle(-(-dy_px).atan2(dx_px)),
        }
    }

    pub(crate) fn px(&self, picture: PictureSize) -> RegionPx {
        RegionPx {
            centre: [self.centre[0] * picture.width, self.centre[1] * picture.height],
            size: [self.size[0] * picture.width, self.size[1] * picture.height],
            rotation_rad: self.rotation_rad,
        }
    }
}

impl RegionPx {
    /// The square that encloses the picture, with the same centre.
    pub(crate) fn whole(picture: PictureSize) -> Self {
        let side = picture.width.max(picture.height);
        Self { centre: [0.5 * picture.width, 0.5 * picture.height], size: [side, side], rotation_rad: 0.0 }
    }

    /// The affine map from this region (0..1) to normalised positions in the picture, as two rows
    /// `[per x, per y, constant]`.
    pub(crate) fn picture_from_region(&self, picture: PictureSize) -> [[f32; 3]; 2] {
        let ([width, height], [x, y]) = (self.size, self.centre);
        let (sin, cos) = (self.rotation_rad.sin(), self.rotation_rad.cos());
        let (per_width, per_height) = (1.0 / picture.width, 1.0 / picture.height);
        [
            [
                width * cos * per_width,
                -height * sin * per_width,
                (-0.5 * width * cos + 0.5 * height * sin + x) * per_width,
            ],
            [
                width * sin * per_height,
                height * cos * per_height,
                (-0.5 * height * cos - 0.5 * width * sin + y) * per_height,
            ],
        ]
    }
}

/// The angle in [−π, π).
fn normalised_angle(angle_rad: f32) -> f32 {
    let angle_rad = f64::from(angle_rad);
    (angle_rad - 2.0 * PI * ((angle_rad + PI) / (2.0 * PI)).floor()) as f32
}
