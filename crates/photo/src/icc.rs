//! Embedded ICC profiles (ICC.1:2022) that consist of three curves and a matrix, such as Display P3, or of one grey
//! curve.
//!
//! Other profiles, and those that cannot be read, are ignored: the values are taken as sRGB.

use image::ColorType;

use crate::code_points::ColourEncoding;
use crate::colour::Conversion;
use crate::primaries::SRGB;

/// Returns the colour encoding that a profile describes for a picture with the given layout.
pub(crate) fn encoding(profile: &[u8], layout: ColorType) -> ColourEncoding {
    let conversion = match profile.get(16..24) {
        Some(b"RGB XYZ ") => rgb_conversion(profile),
        Some(b"GRAYXYZ ") if !layout.has_color() => grey_conversion(profile, |luminance| luminance),
        Some(b"GRAYLab ") if !layout.has_color() => grey_conversion(profile, luminance_of_lightness),
        _ => None,
    };
    conversion.map_or(ColourEncoding::Srgb, ColourEncoding::Converted)
}

/// Returns `None` if the profile is indistinguishable from sRGB, or is not understood.
fn rgb_conversion(profile: &[u8]) -> Option<Conversion> {
    let columns = [xyz(tag(profile, b"rXYZ")?)?, xyz(tag(profile, b"gXYZ")?)?, xyz(tag(profile, b"bXYZ")?)?];
    let curves = [tag(profile, b"rTRC")?, tag(profile, b"gTRC")?, tag(profile, b"bTRC")?];
    let [red, green, blue] = curves.map(|curve| Some(table(&Curve::read(curve)?)));
    Conversion::new([red?, green?, blue?], columns)
}

/// Conversion for a grey profile; `luminance` maps the curve's output to luminance, both 0..1.
fn grey_conversion(profile: &[u8], luminance: fn(f32) -> f32) -> Option<Conversion> {
    let curve = table(&Curve::read(tag(profile, b"kTRC")?)?).into_iter().map(luminance).collect::<Vec<_>>();
    Conversion::new([curve.clone(), curve.clone(), curve], SRGB.colorants_d50()?)
}

/// CIE 1976, L*/100 to Y.
fn luminance_of_lightness(lightness: f32) -> f32 {
    const LINEAR_BELOW: f32 = 0.08;
    if lightness > LINEAR_BELOW { ((lightness + 0.16) / 1.16).powi(3) } else { lightness / 9.033 }
}

/// Returns the contents of a tag. The tag table (signature, offset, size) follows the 128-byte header.
fn tag<'a>(profile: &'a [u8], signature: &[u8; 4]) -> Option<&'a [u8]> {
    let count = u32_at(profile, 128)? as usize;
    let entries = profile.get(132..)?.as_chunks::<12>().0;
    let entry = entries.iter().take(count).find(|entry| entry.starts_with(signature))?;
    let (start, size) = (u32_at(entry, 4)? as usize, u32_at(entry, 8)? as usize);
    profile.get(start..start.checked_add(size)?)
}

fn xyz(tag: &[u8]) -> Option<[f32; 3]> {
    let fixed = |index: usize| fixed_at(tag, 8 + 4 * index);
    tag.starts_with(b"XYZ ").then_some([fixed(0)?, fixed(1)?, fixed(2)?])
}

/// Tone curve from a stored value to linear light, both 0..1.
enum Curve {
    Table(Vec<u16>),
    /// `(a·x + b)^g + e` for `x ≥ d`, otherwise `c·x + f`: `[g, a, b, c, d, e, f]`.
    Parametric([f32; 7]),
}

impl Curve {
    fn read(tag: &[u8]) -> Option<Self> {
        match tag.get(..4)? {
            b"curv" => Self::sampled(tag),
            b"para" => Self::parametric(tag),
            _ => None,
        }
    }

    fn sampled(tag: &[u8]) -> Option<Self> {
        let count = u32_at(tag, 8)? as usize;
        let values = tag.get(12..12_usize.checked_add(count.checked_mul(2)?)?)?;
        let values: Vec<u16> = values.as_chunks::<2>().0.iter().map(|&bytes| u16::from_be_bytes(bytes)).collect();
        Some(match values.as_slice() {
            [] => Self::gamma(1.0),
            &[gamma] => Self::gamma(f32::from(gamma) / 256.0),
            _ => Self::Table(values),
        })
    }

    fn parametric(tag: &[u8]) -> Option<Self> {
        let value = |index: usize| fixed_at(tag, 12 + 4 * index);
        let kind = u16::from_be_bytes(tag.get(8..10)?.try_into().ok()?);
        let g = value(0)?;
        Some(match kind {
            0 => Self::gamma(g),
            1 => Self::Parametric([g, value(1)?, value(2)?, 0.0, -value(2)? / value(1)?, 0.0, 0.0]),
            2 => Self::Parametric([g, value(1)?, value(2)?, 0.0, -value(2)? / value(1)?, value(3)?, value(3)?]),
            3 => Self::Parametric([g, value(1)?, value(2)?, value(3)?, value(4)?, 0.0, 0.0]),
            4 => Self::Parametric([g, value(1)?, value(2)?, value(3)?, value(4)?, value(5)?, value(6)?]),
            _ => return None,
        })
    }

    fn gamma(g: f32) -> Self {
        Self::Parametric([g, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    fn linear(&self, x: f32) -> f32 {
        match self {
            Self::Table(values) => {
                let position = x * (values.len() - 1) as f32;
                let low = (position as usize).min(values.len() - 2);
                let (a, b) = (f32::from(values[low]), f32::from(values[low + 1]));
                (a + (b - a) * (position - low as f32)) / f32::from(u16::MAX)
            }
            &Self::Parametric([g, a, b, c, d, e, f]) => {
                if x >= d {
                    (a * x + b).powf(g) + e
                } else {
                    c * x + f
                }
            }
        }
    }
}

/// Linear light for each 8-bit value.
fn table(curve: &Curve) -> Vec<f32> {
    (0..=u8::MAX).map(|value| curve.linear(f32::from(value) / 255.0)).collect()
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}

/// Reads an s15Fixed16 number.
fn fixed_at(bytes: &[u8], at: usize) -> Option<f32> {
    Some(u32_at(bytes, at)?.cast_signed() as f32 / 65_536.0)
}
