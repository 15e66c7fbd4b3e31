/// sRGB colour with 8 bits per channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Srgb(pub [u8; 3]);

impl Srgb {
    /// White.
    pub const WHITE: Self = Self([255; 3]);

    /// Linear RGB, 0..1 (IEC 61966-2-1).
    pub fn to_linear(self) -> [f32; 3] {
        self.0.map(|channel| {
            let encoded = f32::from(channel) / 255.0;
            if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// sRGB channels as 0..1, with an opacity.
    pub fn with_alpha(self, alpha: f32) -> [f32; 4] {
        let [red, green, blue] = self.0.map(|channel| f32::from(channel) / 255.0);
        [red, green, blue, alpha]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_and_white_map_to_0_and_1() {
        assert_eq!(Srgb([0; 3]).to_linear(), [0.0; 3]);
        assert_eq!(Srgb::WHITE.to_linear(), [1.0; 3]);
    }

    #[test]
    fn level_188_is_half_the_light() {
        let [amount, ..] = Srgb([188; 3]).to_linear();
        assert!((amount - 0.5).abs() < 3e-3, "{amount}");
    }
}
