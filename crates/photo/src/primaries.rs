//! Colour primaries as chromaticities.

use glam::{DMat3, DVec3};

/// CIE 1931 x, y of the primaries and the white point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Primaries {
    pub(crate) red: [f64; 2],
    pub(crate) green: [f64; 2],
    pub(crate) blue: [f64; 2],
    pub(crate) white: [f64; 2],
}

pub(crate) const D65: [f64; 2] = [0.3127, 0.3290];

/// Primaries of ITU-R BT.709 and sRGB.
pub(crate) const SRGB: Primaries = Primaries { red: [0.64, 0.33], green: [0.30, 0.60], blue: [0.15, 0.06], white: D65 };

/// XYZ of the D50 white point, as in ICC profiles.
const D50: DVec3 = DVec3::new(0.964_2, 1.0, 0.824_9);

/// Bradford cone response matrix, by columns.
const BRADFORD: DMat3 = DMat3::from_cols(
    DVec3::new(0.895_1, -0.750_2, 0.038_9),
    DVec3::new(0.266_4, 1.713_5, -0.068_5),
    DVec3::new(-0.161_4, 0.036_7, 1.029_6),
);

impl Primaries {
    /// XYZ of red, green and blue, adapted to D50; `None` if the chromaticities are degenerate or implausible.
    pub(crate) fn colorants_d50(&self) -> Option<[[f32; 3]; 3]> {
        let white = xyz(self.white)?;
        let unscaled = DMat3::from_cols(xyz(self.red)?, xyz(self.green)?, xyz(self.blue)?);
        if unscaled.determinant().abs() < 1e-6 {
            return None;
        }
        let xyz_from_device = unscaled * DMat3::from_diagonal(unscaled.inverse() * white);
        let gains = (BRADFORD * D50) / (BRADFORD * white);
        let d50_from_white = BRADFORD.inverse() * DMat3::from_diagonal(gains) * BRADFORD;
        let colorants = d50_from_white * xyz_from_device;
        colorants.is_finite().then(|| colorants.to_cols_array_2d().map(|column| column.map(|value| value as f32)))
    }
}

/// XYZ of a chromaticity at luminance 1.
fn xyz([x, y]: [f64; 2]) -> Option<DVec3> {
    let plausible = (-0.5..=1.5).contains(&x) && (-0.5..=1.5).contains(&y) && y.abs() > 1e-6;
    plausible.then(|| DVec3::new(x / y, 1.0, (1.0 - x - y) / y))
}
