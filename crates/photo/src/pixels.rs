//! Conversion of decoded pixels to 8-bit RGB.

use image::ColorType;

/// Converts decoded pixels to RGB and, unless all are opaque, their opacity.
///
/// Grey is repeated, 16-bit samples (big-endian, PNG only) are rounded to 8 bits, and transparency is blended over
/// white. Returns `None` for a layout that the decoders do not produce.
pub(crate) fn to_rgb(decoded: Vec<u8>, layout: ColorType) -> Option<(Vec<u8>, Option<Vec<u8>>)> {
    Some(match layout {
        ColorType::Rgb8 => (decoded, None),
        ColorType::L8 => (rgb_from::<1>(&decoded, |[grey]| [grey; 3]), None),
        ColorType::La8 => (rgb_from::<2>(&decoded, |[grey, alpha]| [blended(grey, alpha); 3]), alpha_of::<2>(&decoded)),
        ColorType::Rgba8 => (over_white(&decoded), alpha_of::<4>(&decoded)),
        ColorType::L16 => to_rgb(eight_bit(&decoded), ColorType::L8)?,
        ColorType::La16 => to_rgb(eight_bit(&decoded), ColorType::La8)?,
        ColorType::Rgb16 => (eight_bit(&decoded), None),
        ColorType::Rgba16 => to_rgb(eight_bit(&decoded), ColorType::Rgba8)?,
        _ => return None,
    })
}

/// Last byte of each pixel; `None` if all are opaque.
fn alpha_of<const N: usize>(decoded: &[u8]) -> Option<Vec<u8>> {
    let alpha: Vec<u8> = decoded.as_chunks::<N>().0.iter().map(|pixel| pixel[N - 1]).collect();
    alpha.iter().any(|&alpha| alpha < u8::MAX).then_some(alpha)
}

/// Returns RGBA from colours blended over white and their opacity.
pub(crate) fn to_rgba(rgb: &[u8], alpha: Option<&[u8]>) -> Vec<u8> {
    let mut rgba = vec![u8::MAX; rgb.len() / 3 * 4];
    for (to, pixel) in rgba.as_chunks_mut::<4>().0.iter_mut().zip(rgb.as_chunks::<3>().0) {
        to[..3].copy_from_slice(pixel);
    }
    for (pixel, &alpha) in rgba.as_chunks_mut::<4>().0.iter_mut().zip(alpha.unwrap_or_default()) {
        if alpha < u8::MAX {
            let [r, g, b, _] = pixel.map(|channel| without_white(channel, alpha));
            *pixel = [r, g, b, alpha];
        }
    }
    rgba
}

/// Drops the last of each four bytes.
pub(crate) fn drop_fourth(pixels: &[u8]) -> Vec<u8> {
    let mut rgb = vec![0; pixels.len() / 4 * 3];
    for (to, from) in rgb.as_chunks_mut::<3>().0.iter_mut().zip(pixels.as_chunks::<4>().0) {
        *to = [from[0], from[1], from[2]];
    }
    rgb
}

fn rgb_from<const N: usize>(decoded: &[u8], rgb: impl Fn([u8; N]) -> [u8; 3]) -> Vec<u8> {
    decoded.as_chunks::<N>().0.iter().flat_map(|&pixel| rgb(pixel)).collect()
}

/// Blends RGBA over white.
pub(crate) fn over_white(rgba: &[u8]) -> Vec<u8> {
    rgb_from::<4>(rgba, |[r, g, b, a]| [r, g, b].map(|channel| blended(channel, a)))
}

/// Blends a channel over white.
fn blended(channel: u8, alpha: u8) -> u8 {
    let (channel, alpha) = (u16::from(channel), u16::from(alpha));
    ((channel * alpha + 255 * (255 - alpha) + 127) / 255) as u8
}

/// Inverse of [`blended`].
fn without_white(channel: u8, alpha: u8) -> u8 {
    let (channel, alpha) = (i32::from(channel), i32::from(alpha.max(1)));
    ((channel * 255 - 255 * (255 - alpha) + alpha / 2) / alpha).clamp(0, 255) as u8
}

/// `round(sample · 255 / 65535)`.
fn eight_bit(decoded: &[u8]) -> Vec<u8> {
    let sample = |&bytes: &[u8; 2]| ((u32::from(u16::from_be_bytes(bytes)) + 128) / 257) as u8;
    decoded.as_chunks::<2>().0.iter().map(sample).collect()
}
