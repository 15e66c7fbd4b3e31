//! The colours of a picture to sRGB.

/// How the values of a picture become sRGB.
pub(crate) struct Conversion {
    /// Linear light by 8-bit value, for each channel.
    linear: [Vec<f32>; 3],
    linear_srgb_from_device: [[f32; 3]; 3],
    light: Light,
    /// 8-bit sRGB by linear light in steps of `1 / ENCODED_STEPS`.
    encoded: Vec<u8>,
}

/// What linear light means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Light {
    /// 1 is white, and nothing is brighter.
    OfTheScreen,
    /// 1 is a white page (203 cd/m², ITU-R BT.2408), and highlights are brighter.
    WithHighlights,
    /// Relative light of the scene, before the system's own rendering (hybrid log-gamma).
    OfTheScene,
}

const ENCODED_STEPS: usize = 16_384;

/// Linear sRGB from XYZ relative to D50, where profiles meet: the inverse of sRGB's own colorants.
const LINEAR_SRGB_FROM_XYZ_D50: [[f32; 3]; 3] =
    [[3.133_856, -1.616_867, -0.490_615], [-0.978_768, 1.916_142, 0.033_454], [0.071_945, -0.228_991, 1.405_243]];

impl Conversion {
    /// From curves (linear light by 8-bit value, for each channel) and colorants (XYZ relative to D50 of red, green and
    /// blue); `None` if they are as good as sRGB, or a number among them is not finite.
    pub(crate) fn new(linear: [Vec<f32>; 3], colorants_d50: [[f32; 3]; 3], light: Light) -> Option<Self> {
        let linear_srgb_from_device = LINEAR_SRGB_FROM_XYZ_D50
            .map(|row| colorants_d50.map(|column| row.iter().zip(column).map(|(a, b)| a * b).sum::<f32>()));
        let numbers = linear.iter().flatten().chain(linear_srgb_from_device.as_flattened());
        if !numbers.into_iter().all(|number| number.is_finite()) {
            return None;
        }
        let encoded = (0..=ENCODED_STEPS).map(|step| srgb_encoded(step as f32 / ENCODED_STEPS as f32)).collect();
        let conversion = Self { linear, linear_srgb_from_device, light, encoded };
        (!conversion.is_nearly_none()).then_some(conversion)
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
        let light = match self.light {
            Light::OfTheScreen => light,
            Light::WithHighlights => with_highlights_compressed(light),
            Light::OfTheScene => with_highlights_compressed(rendered(light)),
        };
        light.map(|light| self.encoded[(light.clamp(0.0, 1.0) * ENCODED_STEPS as f32 + 0.5) as usize])
    }

    /// Whether it would change no corner or middle of the colour cube by more than a step of an 8-bit value.
    fn is_nearly_none(&self) -> bool {
        const LEVELS: [u8; 5] = [0, 64, 128, 192, 255];
        let mut cube = LEVELS.iter().flat_map(|&r| LEVELS.iter().flat_map(move |&g| LEVELS.map(|b| [r, g, b])));
        cube.all(|pixel| self.srgb(pixel).iter().zip(pixel).all(|(new, old)| new.abs_diff(old) <= 1))
    }
}

/// Light up to three quarters of white stays; what is brighter draws near to white without reaching it. All channels
/// keep their proportions, so that the hue stays.
fn with_highlights_compressed(light: [f32; 3]) -> [f32; 3] {
    const KNEE: f32 = 0.75;
    let brightest = light.into_iter().fold(0.0, f32::max);
    if brightest <= KNEE {
        return light;
    }
    let compressed = 1.0 - (1.0 - KNEE) * (-(brightest - KNEE) / (1.0 - KNEE)).exp();
    light.map(|channel| channel * compressed / brightest)
}

/// From the scene's light to that of a screen of 1000 cd/m² in units of a white page: the opto-optical transfer function
/// of ITU-R BT.2100, table 5.
fn rendered(light: [f32; 3]) -> [f32; 3] {
    const PEAK_IN_WHITE_PAGES: f32 = 1000.0 / 203.0;
    const SYSTEM_GAMMA: f32 = 1.2;
    let luminance = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
    let gain = PEAK_IN_WHITE_PAGES * luminance.max(0.0).powf(SYSTEM_GAMMA - 1.0);
    light.map(|channel| channel * gain)
}

/// IEC 61966-2-1.
fn srgb_encoded(linear: f32) -> u8 {
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}
