/// A colour as pictures and style sheets write it: sRGB, 8 bits a channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Srgb(pub [u8; 3]);

impl Srgb {
    /// White.
    pub const WHITE: Self = Self([255; 3]);

    /// The amounts of light, 0..1, that the GPU computes with (IEC 61966-2-1).
    pub fn to_linear(self) -> [f32; 3] {
        self.0.map(|channel| {
            let encoded = f32::from(channel) / 255.0;
            if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// The channels, still sRGB, as 0..1, and an opacity.
    pub fn with_alpha(self, alpha: f32) -> [f32; 4] {
        let [red, green, blue] = self.0.map(|channel| f32::from(channel) / 255.0);
        [red, green, blue, alpha]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_and_white_are_no_and_all_light() {
        assert_eq!(Srgb([0; 3]).to_linear(), [0.0; 3]);
        assert_eq!(Srgb::WHITE.to_linear(), [1.0; 3]);
    }

    #[test]
    fn half_the_light_is_encoded_as_188() {
        let [amount, ..] = Srgb([188; 3]).to_linear();
        assert!((amount - 0.5).abs() < 3e-3, "{amount}");
    }
}
