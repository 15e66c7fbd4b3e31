//! Whatever a decoder gives to 8-bit RGB.

use image::ColorType;

/// Converts decoded pixels to RGB; `None` if the layout is none that the decoders give.
///
/// Grey is repeated, 16-bit samples (native-endian) are rounded to 8 bits, and transparency is laid over white, as on
/// paper.
pub(crate) fn to_rgb(decoded: Vec<u8>, layout: ColorType) -> Option<Vec<u8>> {
    Some(match layout {
        ColorType::Rgb8 => decoded,
        ColorType::L8 => rgb_from::<1>(&decoded, |[grey]| [grey; 3]),
        ColorType::La8 => rgb_from::<2>(&decoded, |[grey, alpha]| [over_white(grey, alpha); 3]),
        ColorType::Rgba8 => rgb_from::<4>(&decoded, |[r, g, b, alpha]| [r, g, b].map(|c| over_white(c, alpha))),
        ColorType::L16 => to_rgb(eight_bit(&decoded), ColorType::L8)?,
        ColorType::La16 => to_rgb(eight_bit(&decoded), ColorType::La8)?,
        ColorType::Rgb16 => eight_bit(&decoded),
        ColorType::Rgba16 => to_rgb(eight_bit(&decoded), ColorType::Rgba8)?,
        _ => return None,
    })
}

/// The first three of every four bytes.
pub(crate) fn without_the_fourth(pixels: &[u8]) -> Vec<u8> {
    let mut rgb = vec![0; pixels.len() / 4 * 3];
    for (to, from) in rgb.as_chunks_mut::<3>().0.iter_mut().zip(pixels.as_chunks::<4>().0) {
        *to = [from[0], from[1], from[2]];
    }
    rgb
}

fn rgb_from<const N: usize>(decoded: &[u8], rgb: impl Fn([u8; N]) -> [u8; 3]) -> Vec<u8> {
    decoded.as_chunks::<N>().0.iter().flat_map(|&pixel| rgb(pixel)).collect()
}

fn over_white(channel: u8, alpha: u8) -> u8 {
    let (channel, alpha) = (u16::from(channel), u16::from(alpha));
    ((channel * alpha + 255 * (255 - alpha) + 127) / 255) as u8
}

/// `round(sample · 255 / 65535)`.
fn eight_bit(decoded: &[u8]) -> Vec<u8> {
    let sample = |&bytes: &[u8; 2]| ((u32::from(u16::from_ne_bytes(bytes)) + 128) / 257) as u8;
    decoded.as_chunks::<2>().0.iter().map(sample).collect()
}
