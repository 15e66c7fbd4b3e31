//! Conversion of pixels to sRGB.

/// Conversion of 8-bit RGB from a device colour space to sRGB.
pub(crate) struct Conversion {
    /// Linear light for each 8-bit value, per channel.
    linear: [Vec<f32>; 3],
    linear_srgb_from_device: [[f32; 3]; 3],
    /// 8-bit sRGB for linear light in steps of `1 / ENCODED_STEPS`.
    encoded: Vec<u8>,
}

const ENCODED_STEPS: usize = 16_384;

/// Linear sRGB from XYZ relative to D50, the profile connection space: the inverse of sRGB's own colorants.
const LINEAR_SRGB_FROM_XYZ_D50: [[f32; 3]; 3] =
    [[3.133_856, -1.616_867, -0.490_615], [-0.978_768, 1.916_142, 0.033_454], [0.071_945, -0.228_991, 1.405_243]];

impl Conversion {
    /// Creates a conversion from tone curves (linear light for each 8-bit value, per channel) and colorants (XYZ of
    /// red, green and blue, relative to D50).
    ///
    /// Returns `None` if the result is indistinguishable from sRGB, or a value is not finite.
    pub(crate) fn new(linear: [Vec<f32>; 3], colorants_d50: [[f32; 3]; 3]) -> Option<Self> {
        let linear_srgb_from_device = LINEAR_SRGB_FROM_XYZ_D50
            .map(|row| colorants_d50.map(|column| row.iter().zip(column).map(|(a, b)| a * b).sum::<f32>()));
        let numbers = linear.iter().flatten().chain(linear_srgb_from_device.as_flattened());
        if !numbers.into_iter().all(|number| number.is_finite()) {
            return None;
        }
        let encoded = (0..=ENCODED_STEPS).map(|step| srgb_encoded(step as f32 / ENCODED_STEPS as f32)).collect();
        let conversion = Self { linear, linear_srgb_from_device, encoded };
        (!conversion.is_nearly_identity()).then_some(conversion)
    }

    /// Converts RGB pixels in place.
    pub(crate) fn apply(&self, pixels: &mut [u8]) {
        for pixel in pixels.as_chunks_mut::<3>().0 {
            *pixel = self.srgb(*pixel);
        }
    }

    fn srgb(&self, pixel: [u8; 3]) -> [u8; 3] {
        let linear: [f32; 3] = std::array::from_fn(|channel| self.linear[channel][usize::from(pixel[channel])]);
        let light =
            self.linear_srgb_from_device.map(|row| row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2]);
        light.map(|light| self.encoded[(light.clamp(0.0, 1.0) * ENCODED_STEPS as f32 + 0.5) as usize])
    }

    /// Whether no sample of a 5 × 5 × 5 grid of the colour cube changes by more than one 8-bit level.
    fn is_nearly_identity(&self) -> bool {
        const LEVELS: [u8; 5] = [0, 64, 128, 192, 255];
        let mut cube = LEVELS.iter().flat_map(|&r| LEVELS.iter().flat_map(move |&g| LEVELS.map(|b| [r, g, b])));
        cube.all(|pixel| self.srgb(pixel).iter().zip(pixel).all(|(new, old)| new.abs_diff(old) <= 1))
    }
}

/// IEC 61966-2-1.
fn srgb_encoded(linear: f32) -> u8 {
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}
