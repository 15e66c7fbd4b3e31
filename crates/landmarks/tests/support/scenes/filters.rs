//! Degradations of a picture.

use image::codecs::jpeg::JpegEncoder;
use rosto_photo::{Limits, Photo};

use crate::support::pictures;
use crate::support::seeded::Seeded;

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filter {
    None,
    /// Exponent of each channel in 0..1; above 1 darkens.
    Gamma(f64),
    /// Remaining fraction of the contrast, about middle grey.
    Contrast(f64),
    /// Factors of red, green and blue.
    Tint([f64; 3]),
    Grey,
    /// Brightness of the right border relative to the left one; linear in between.
    SideLight(f64),
    /// Radius of three box blurs, px.
    Blur(u32),
    /// Greatest change of a value.
    Noise(f64),
    /// JPEG quality.
    Jpeg(u8),
}

impl Filter {
    pub fn of(self, photo: &Photo, seed: u64) -> Photo {
        match self {
            Self::None => photo.clone(),
            Self::Gamma(power) => pictures::toned(photo, |value| value.powf(power)),
            Self::Contrast(share) => pictures::toned(photo, |value| 0.5 + (value - 0.5) * share),
            Self::Tint(factors) => mapped(photo, |_, channel, value| value * factors[channel]),
            Self::Grey => pictures::grey(photo),
            Self::SideLight(share) => {
                let width = f64::from(photo.width());
                mapped(photo, |x, _, value| value * (1.0 - (1.0 - share) * f64::from(x) / width))
            }
            Self::Blur(radius) => pictures::blurred(photo, radius),
            Self::Noise(amount) => {
                let mut seeded = Seeded::new(seed);
                mapped(photo, |_, _, value| value + amount * seeded.signed())
            }
            Self::Jpeg(quality) => jpeg(photo, quality),
        }
    }
}

/// Maps each value from its column, its channel and its old value, 0..255.
fn mapped(photo: &Photo, mut value: impl FnMut(u32, usize, f64) -> f64) -> Photo {
    let pixels = photo.pixels().iter().enumerate().map(|(index, &old)| {
        let x = (index / 3 % photo.width() as usize) as u32;
        value(x, index % 3, f64::from(old)).round().clamp(0.0, 255.0) as u8
    });
    Photo::from_rgb(photo.width(), photo.height(), pixels.collect()).expect("the number of bytes is unchanged")
}

fn jpeg(photo: &Photo, quality: u8) -> Photo {
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, quality)
        .encode(photo.pixels(), photo.width(), photo.height(), image::ExtendedColorType::Rgb8)
        .expect("the picture fits a JPEG");
    rosto_photo::decode(&bytes, &Limits::default()).expect("the encoder writes valid files")
}
