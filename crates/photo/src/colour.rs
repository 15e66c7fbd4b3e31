//! The colours of a picture to sRGB, as its profile, code points, gamma or primaries describe them.

use std::sync::Arc;

use image::ColorType;
use moxcms::{
    Chromaticity, CicpProfile, ColorPrimaries, ColorProfile, DataColorSpace, Layout, MatrixCoefficients,
    ParsingOptions, ToneReprCurve, TransferCharacteristics, Transform8BitExecutor, TransformOptions,
};

/// How a file describes its colours.
pub(crate) enum ColourEncoding {
    /// Not at all, or in a way that is not understood.
    Unknown,
    /// As sRGB, or within rounding of it.
    Srgb,
    /// In another way, which is converted.
    Other(Conversion),
}

impl ColourEncoding {
    /// Reads an ICC profile of three curves and a matrix, as Display P3 is, or for a grey picture of one curve. A profile of
    /// another kind, or a broken one, counts as sRGB.
    pub(crate) fn of_profile(profile: &[u8], layout: ColorType) -> Self {
        /// Each byte of a profile may take 25 bytes of memory.
        const MOST_BYTES: usize = 4_000_000;
        let options = ParsingOptions { max_profile_size: MOST_BYTES, ..ParsingOptions::default() };
        let Ok(profile) = ColorProfile::new_from_slice_with_options(profile, options) else { return Self::Srgb };
        match (profile.color_space, profile.pcs) {
            (DataColorSpace::Rgb, DataColorSpace::Xyz) => Self::of(&profile, true),
            (DataColorSpace::Gray, _) if !layout.has_color() => {
                curve_of_grey(&profile).map_or(Self::Srgb, |curve| Self::of(&srgb_with_curve(curve), true))
            }
            _ => Self::Srgb,
        }
    }

    /// Reads code points (ITU-T H.273), except PQ and HLG, whose highlights do not fit into sRGB.
    pub(crate) fn of_code_points(primaries: u8, transfer: u8, full_range: bool) -> Self {
        let (Ok(color_primaries), Ok(transfer_characteristics)) = (primaries.try_into(), transfer.try_into()) else {
            return Self::Unknown;
        };
        if matches!(transfer_characteristics, TransferCharacteristics::Smpte2084 | TransferCharacteristics::Hlg) {
            return Self::Unknown;
        }
        let matrix_coefficients = MatrixCoefficients::Identity;
        let points = CicpProfile { color_primaries, transfer_characteristics, matrix_coefficients, full_range };
        let profile = ColorProfile::new_from_cicp(points);
        if profile.red_trc.is_some() { Self::of(&profile, full_range) } else { Self::Unknown }
    }

    /// Reads a gamma (the exponent of the encoding, 0.45455 for sRGB) and primaries; each may be missing or absurd.
    pub(crate) fn of_gamma(gamma: Option<f32>, primaries: Option<Primaries>) -> Self {
        /// A smaller difference from sRGB's comes from rounding, or from the old habit of writing 0.45.
        const SIGNIFICANT: f32 = 0.05;
        const PLAUSIBLE: std::ops::RangeInclusive<f32> = 0.1..=5.0;
        let gamma = gamma.filter(|gamma| PLAUSIBLE.contains(gamma));
        let primaries = primaries.filter(Primaries::are_plausible);
        if gamma.is_none() && primaries.is_none() {
            return Self::Unknown;
        }
        let mut profile = match gamma.filter(|gamma| (gamma * 2.2 - 1.0).abs() > SIGNIFICANT) {
            Some(gamma) => srgb_with_curve(ToneReprCurve::Parametric(vec![1.0 / gamma])),
            None => ColorProfile::new_srgb(),
        };
        if let Some(Primaries { red, green, blue, white }) = primaries {
            profile.update_rgb_colorimetry(white.to_xyyb(), ColorPrimaries { red, green, blue });
        }
        Self::of(&profile, true)
    }

    fn of(profile: &ColorProfile, full_range: bool) -> Self {
        Conversion::new(profile, full_range).map_or(Self::Srgb, Self::Other)
    }
}

/// Chromaticities of the primaries and of white.
pub(crate) struct Primaries {
    pub(crate) red: Chromaticity,
    pub(crate) green: Chromaticity,
    pub(crate) blue: Chromaticity,
    pub(crate) white: Chromaticity,
}

impl Primaries {
    fn are_plausible(&self) -> bool {
        let Self { red, green, blue, white } = self;
        let plausible = |place: &Chromaticity| (-0.5..=1.5).contains(&place.x) && (1e-6..=1.5).contains(&place.y.abs());
        let twice_the_area = (green.x - red.x) * (blue.y - red.y) - (blue.x - red.x) * (green.y - red.y);
        [red, green, blue, white].into_iter().all(plausible) && twice_the_area.abs() > 1e-6
    }
}

/// From stored 8-bit RGB to sRGB.
pub(crate) struct Conversion {
    to_srgb: Arc<Transform8BitExecutor>,
    full_range: bool,
}

impl Conversion {
    /// `None` if the profile is as good as sRGB, or is not made of curves and a matrix.
    fn new(profile: &ColorProfile, full_range: bool) -> Option<Self> {
        let exactly = TransformOptions {
            prefer_fixed_point: false,
            allow_use_cicp_transfer: false,
            ..TransformOptions::default()
        };
        let srgb = ColorProfile::new_srgb();
        let to_srgb = profile.create_transform_8bit(Layout::Rgb, &srgb, Layout::Rgb, exactly).ok()?;
        let conversion = Self { to_srgb, full_range };
        (!conversion.is_nearly_none()).then_some(conversion)
    }

    /// Converts RGB pixels in place.
    pub(crate) fn apply(&self, pixels: &mut [u8]) {
        const PART_BYTES: usize = 3 * 4096;
        let full = |&value: &u8| ((f32::from(value) - 16.0) / 219.0 * 255.0).round() as u8;
        for part in pixels.chunks_mut(PART_BYTES) {
            let stored = if self.full_range { part.to_vec() } else { part.iter().map(full).collect() };
            self.to_srgb.transform(&stored, part).expect("invariant: both hold the same whole pixels");
        }
    }

    /// Whether it changes no corner or middle of the colour cube by more than a step of an 8-bit value.
    fn is_nearly_none(&self) -> bool {
        const LEVELS: [u8; 5] = [0, 64, 128, 192, 255];
        let cube = LEVELS.iter().flat_map(|&r| LEVELS.iter().flat_map(move |&g| LEVELS.map(|b| [r, g, b])));
        let stored = cube.collect::<Vec<_>>().into_flattened();
        let mut converted = stored.clone();
        self.apply(&mut converted);
        converted.iter().zip(stored).all(|(new, old)| new.abs_diff(old) <= 1)
    }
}

/// From grey to luminance, in a profile that leads to it or to lightness (CIE 1976).
fn curve_of_grey(profile: &ColorProfile) -> Option<ToneReprCurve> {
    let luminance = |lightness: f32| {
        if lightness > 0.08 { ((lightness + 0.16) / 1.16).powi(3) } else { lightness / 9.033 }
    };
    match profile.pcs {
        DataColorSpace::Xyz => profile.gray_trc.clone(),
        DataColorSpace::Lab => {
            let lightness = profile.build_8bit_lin_table(&profile.gray_trc).ok()?;
            Some(ToneReprCurve::Lut(lightness.map(|value| (luminance(value) * 65_535.0).round() as u16).to_vec()))
        }
        _ => None,
    }
}

fn srgb_with_curve(curve: ToneReprCurve) -> ColorProfile {
    let mut profile = ColorProfile::new_srgb();
    profile.red_trc = Some(curve.clone());
    profile.green_trc = Some(curve.clone());
    profile.blue_trc = Some(curve);
    profile
}
