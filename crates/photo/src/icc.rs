//! Embedded colour profiles to sRGB: those that are three curves and a matrix, as Display P3 of every newer phone is.
//!
//! ICC.1:2022. A profile of another kind, or one that cannot be read, is ignored, and the values are taken for sRGB.

/// How the values of a picture become sRGB.
pub(crate) struct Conversion {
    /// Linear light by 8-bit value, for each channel.
    linear: [Vec<f32>; 3],
    linear_srgb_from_device: [[f32; 3]; 3],
    /// 8-bit sRGB by linear light in steps of `1 / ENCODED_STEPS`.
    encoded: Vec<u8>,
}

const ENCODED_STEPS: usize = 16_384;

/// Linear sRGB from XYZ relative to D50, the profiles' meeting place: the inverse of sRGB's own colorants.
const LINEAR_SRGB_FROM_XYZ_D50: [[f32; 3]; 3] =
    [[3.133_856, -1.616_867, -0.490_615], [-0.978_768, 1.916_142, 0.033_454], [0.071_945, -0.228_991, 1.405_243]];

impl Conversion {
    /// What a profile asks for; `None` if it is as good as sRGB or is not understood.
    pub(crate) fn from_profile(profile: &[u8]) -> Option<Self> {
        if profile.get(16..24)? != b"RGB XYZ " {
            return None;
        }
        let columns = [xyz(tag(profile, b"rXYZ")?)?, xyz(tag(profile, b"gXYZ")?)?, xyz(tag(profile, b"bXYZ")?)?];
        let curves = [tag(profile, b"rTRC")?, tag(profile, b"gTRC")?, tag(profile, b"bTRC")?];
        let [red, green, blue] = curves.map(|curve| table(&Curve::read(curve)?));
        let linear = [red?, green?, blue?];
        let linear_srgb_from_device =
            LINEAR_SRGB_FROM_XYZ_D50.map(|row| columns.map(|column| row.iter().zip(column).map(|(a, b)| a * b).sum()));
        let encoded = (0..=ENCODED_STEPS).map(|step| srgb_encoded(step as f32 / ENCODED_STEPS as f32)).collect();
        let conversion = Self { linear, linear_srgb_from_device, encoded };
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
        self.linear_srgb_from_device.map(|row| {
            let light = row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2];
            self.encoded[(light.clamp(0.0, 1.0) * ENCODED_STEPS as f32 + 0.5) as usize]
        })
    }

    /// Whether it would change no corner or middle of the colour cube by more than a step of an 8-bit value.
    fn is_nearly_none(&self) -> bool {
        const LEVELS: [u8; 5] = [0, 64, 128, 192, 255];
        let mut cube = LEVELS.iter().flat_map(|&r| LEVELS.iter().flat_map(move |&g| LEVELS.map(|b| [r, g, b])));
        cube.all(|pixel| self.srgb(pixel).iter().zip(pixel).all(|(new, old)| new.abs_diff(old) <= 1))
    }
}

/// The contents of a tag: signature, offset and size stand in a table behind the 128 bytes of the header.
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

/// From a stored value to linear light, both 0..1.
enum Curve {
    Table(Vec<u16>),
    /// `(a·x + b)^g + e` from `d` on, `c·x + f` below it: `[g, a, b, c, d, e, f]`.
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

/// Linear light of each 8-bit value; `None` if the curve leaves the numbers.
fn table(curve: &Curve) -> Option<Vec<f32>> {
    let table: Vec<f32> = (0..=u8::MAX).map(|value| curve.linear(f32::from(value) / 255.0)).collect();
    table.iter().all(|light| light.is_finite()).then_some(table)
}

/// IEC 61966-2-1.
fn srgb_encoded(linear: f32) -> u8 {
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round() as u8
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}

/// An s15Fixed16 number.
fn fixed_at(bytes: &[u8], at: usize) -> Option<f32> {
    Some(u32_at(bytes, at)?.cast_signed() as f32 / 65_536.0)
}
