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

    /// The nearest colour to amounts of light; what is out of range is clamped.
    pub fn from_linear(linear: [f32; 3]) -> Self {
        Self(linear.map(|amount| {
            let amount = amount.clamp(0.0, 1.0);
            let encoded = if amount <= 0.003_130_8 { 12.92 * amount } else { 1.055 * amount.powf(1.0 / 2.4) - 0.055 };
            (encoded * 255.0).round() as u8
        }))
    }

    pub(crate) fn with_alpha(self, alpha: f32) -> [f32; 4] {
        let [red, green, blue] = self.to_linear();
        [red, green, blue, alpha]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_channel_value_survives_the_round_trip() {
        for value in 0..=255 {
            let colour = Srgb([value, 255 - value, value / 2]);
            assert_eq!(Srgb::from_linear(colour.to_linear()), colour);
        }
    }

    #[test]
    fn half_the_light_is_encoded_as_188() {
        assert_eq!(Srgb::from_linear([0.5; 3]), Srgb([188; 3]));
    }
}
