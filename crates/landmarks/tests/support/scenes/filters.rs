//! What happens to a picture between the lens and the file.

use image::codecs::jpeg::JpegEncoder;
use rosto_photo::{Limits, Photo};

use crate::support::pictures;
use crate::support::seeded::Seeded;

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filter {
    None,
    /// Each channel to this power, in 0..1: above 1 is darker.
    Gamma(f64),
    /// The share of the contrast that is left, about a middle grey.
    Contrast(f64),
    /// The factors of red, green and blue.
    Tint([f64; 3]),
    Grey,
    /// The left half lit, the right half at this share of the light.
    SideLight(f64),
    /// Three box blurs of this radius in px.
    Blur(u32),
    /// Up to so much is added to each value.
    Noise(f64),
    /// The quality of a JPEG file.
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

/// Each value anew from its column, its channel and what it was, 0..255.
fn mapped(photo: &Photo, mut value: impl FnMut(u32, usize, f64) -> f64) -> Photo {
    let pixels = photo.pixels().iter().enumerate().map(|(index, &old)| {
        let x = (index / 3 % photo.width() as usize) as u32;
        value(x, index % 3, f64::from(old)).round().clamp(0.0, 255.0) as u8
    });
    Photo::from_rgb(photo.width(), photo.height(), pixels.collect()).expect("as many bytes as before")
}

fn jpeg(photo: &Photo, quality: u8) -> Photo {
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, quality)
        .encode(photo.pixels(), photo.width(), photo.height(), image::ExtendedColorType::Rgb8)
        .expect("a picture can be a JPEG");
    rosto_photo::decode(&bytes, &Limits::default()).expect("what was just written can be read")
}
