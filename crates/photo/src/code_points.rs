//! Colour encodings given by code points (ITU-T H.273, PNG's `cICP` chunk) or by a gamma (`gAMA`).

use crate::colour::Conversion;
use crate::primaries::{D65, Primaries, SRGB};

/// Colour primaries, transfer characteristics and range, as numbered by ITU-T H.273.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CodePoints {
    pub(crate) primaries: u8,
    pub(crate) transfer: u8,
    pub(crate) full_range: bool,
}

/// Decodes a signal to linear light, both in 0..1.
type Curve = fn(f64) -> f64;

/// Colour encoding of a decoded picture.
pub(crate) enum ColourEncoding {
    /// Missing or not understood.
    Unspecified,
    /// sRGB, or indistinguishable from it.
    Srgb,
    /// Needs a conversion to sRGB.
    Converted(Conversion),
}

impl CodePoints {
    /// Returns the colour encoding that the code points describe.
    pub(crate) fn encoding(self) -> ColourEncoding {
        let (Some(primaries), Some(curve)) = (self.known_primaries(), self.curve()) else {
            return ColourEncoding::Unspecified;
        };
        let Some(colorants) = primaries.colorants_d50() else { return ColourEncoding::Unspecified };
        let table: Vec<f32> = (0..=u8::MAX).map(|value| curve(self.signal(value)) as f32).collect();
        let conversion = Conversion::new([table.clone(), table.clone(), table], colorants);
        conversion.map_or(ColourEncoding::Srgb, ColourEncoding::Converted)
    }

    /// Returns the signal (0..1) of an 8-bit value.
    fn signal(self, value: u8) -> f64 {
        let value = f64::from(value);
        if self.full_range { value / 255.0 } else { ((value - 16.0) / 219.0).clamp(0.0, 1.0) }
    }

    /// Table 2 of H.273.
    fn known_primaries(self) -> Option<Primaries> {
        const ILLUMINANT_C: [f64; 2] = [0.310, 0.316];
        let of = |red, green, blue, white| Some(Primaries { red, green, blue, white });
        match self.primaries {
            1 => Some(SRGB),
            4 => of([0.67, 0.33], [0.21, 0.71], [0.14, 0.08], ILLUMINANT_C),
            5 => of([0.64, 0.33], [0.29, 0.60], [0.15, 0.06], D65),
            6 | 7 => of([0.630, 0.340], [0.310, 0.595], [0.155, 0.070], D65),
            8 => of([0.681, 0.319], [0.243, 0.692], [0.145, 0.049], ILLUMINANT_C),
            9 => of([0.708, 0.292], [0.170, 0.797], [0.131, 0.046], D65),
            11 => of([0.680, 0.320], [0.265, 0.690], [0.150, 0.060], [0.314, 0.351]),
            12 => of([0.680, 0.320], [0.265, 0.690], [0.150, 0.060], D65),
            22 => of([0.630, 0.340], [0.295, 0.605], [0.155, 0.077], D65),
            _ => None,
        }
    }

    /// Table 3 of H.273, without the transfer characteristics that photos do not use.
    fn curve(self) -> Option<Curve> {
        match self.transfer {
            1 | 6 | 11 | 12 | 14 | 15 => Some(bt709),
            4 => Some(|signal| signal.powf(2.2)),
            5 => Some(|signal| signal.powf(2.8)),
            8 => Some(|signal| signal),
            13 => Some(srgb),
            _ => None,
        }
    }

    /// Whether the transfer characteristics are specified (not 2) but unsupported, such as PQ (16) or HLG (18).
    pub(crate) fn has_unsupported_curve(self) -> bool {
        self.transfer != 2 && self.curve().is_none()
    }
}

/// Returns the colour encoding given by PNG's `gAMA` (the encoding exponent, 0.45455 for sRGB) and `cHRM`.
///
/// Either may be missing; implausible values are ignored.
pub(crate) fn encoding_from_gamma(gamma: Option<f64>, primaries: Option<Primaries>) -> ColourEncoding {
    /// Smaller deviations from sRGB's gamma are rounding errors, or the common value 0.45.
    const SIGNIFICANT: f64 = 0.05;
    const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.1..=5.0;
    let gamma = gamma.filter(|gamma| PLAUSIBLE.contains(gamma));
    let colorants = primaries.and_then(|primaries| primaries.colorants_d50());
    if gamma.is_none() && colorants.is_none() {
        return ColourEncoding::Unspecified;
    }
    let Some(colorants) = colorants.or_else(|| SRGB.colorants_d50()) else { return ColourEncoding::Unspecified };
    let exponent = gamma.filter(|gamma| (gamma * 2.2 - 1.0).abs() > SIGNIFICANT).map(|gamma| 1.0 / gamma);
    let light = |value: u8| {
        let signal = f64::from(value) / 255.0;
        exponent.map_or_else(|| srgb(signal), |exponent| signal.powf(exponent)) as f32
    };
    let table: Vec<f32> = (0..=u8::MAX).map(light).collect();
    Conversion::new([table.clone(), table.clone(), table], colorants)
        .map_or(ColourEncoding::Srgb, ColourEncoding::Converted)
}

/// IEC 61966-2-1.
fn srgb(signal: f64) -> f64 {
    if signal <= 0.040_45 { signal / 12.92 } else { ((signal + 0.055) / 1.055).powf(2.4) }
}

/// Inverse of the ITU-R BT.709 transfer function.
fn bt709(signal: f64) -> f64 {
    if signal < 0.081 { signal / 4.5 } else { ((signal + 0.099) / 1.099).powf(1.0 / 0.45) }
}
