/// Linear light (0..=1) of an 8-bit sRGB channel (IEC 61966-2-1).
pub fn linear_from_srgb(channel: u8) -> f64 {
    let encoded = f64::from(channel) / 255.0;
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}
