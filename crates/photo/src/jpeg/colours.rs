//! Colour spaces of JPEG components (JFIF 1.02; Adobe Technical Note 5116) and their conversion to RGB.

use crate::widest;

/// Colour space of the components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Colours {
    Grey,
    Rgb,
    YCbCr,
    /// Inverted, as Adobe's programs store it: 255 means no ink.
    Cmyk,
    /// Inverted like [`Self::Cmyk`], with the inks as luminance and chrominance.
    Ycck,
}

impl Colours {
    /// Determines the colour space. As in libjpeg, JFIF takes precedence over Adobe's segment, and that over the
    /// component ids.
    pub(crate) fn new(components: usize, jfif: bool, adobe: Option<u8>, ids: &[u8]) -> Self {
        match (components, adobe) {
            (1, _) => Self::Grey,
            (4, Some(1..)) => Self::Ycck,
            (4, _) => Self::Cmyk,
            _ if jfif => Self::YCbCr,
            (_, Some(0)) => Self::Rgb,
            (_, None) if ids == b"RGB" => Self::Rgb,
            _ => Self::YCbCr,
        }
    }

    /// Converts a row of each component to a row of RGB.
    pub(crate) fn write_rgb(self, rows: &[&[u8]], out: &mut [u8]) {
        widest(
            #[inline(always)]
            || self.write_row(rows, out),
        );
    }

    #[inline(always)]
    fn write_row(self, rows: &[&[u8]], out: &mut [u8]) {
        let out = out.as_chunks_mut::<3>().0;
        match (self, rows) {
            (Self::YCbCr, [y, cb, cr, ..]) => {
                for (((to, &y), &cb), &cr) in out.iter_mut().zip(*y).zip(*cb).zip(*cr) {
                    *to = rgb(y, cb, cr);
                }
            }
            (Self::Rgb, [r, g, b, ..]) => {
                for (((to, &r), &g), &b) in out.iter_mut().zip(*r).zip(*g).zip(*b) {
                    *to = [r, g, b];
                }
            }
            (Self::Cmyk | Self::Ycck, [c, m, y, k]) => {
                for ((((to, &c), &m), &y), &k) in out.iter_mut().zip(*c).zip(*m).zip(*y).zip(*k) {
                    let inks = if self == Self::Ycck { rgb(c, m, y).map(|ink| 255 - ink) } else { [c, m, y] };
                    *to = inks.map(|ink| ((u16::from(ink) * u16::from(k) + 127) / 255) as u8);
                }
            }
            _ => out.iter_mut().zip(rows[0]).for_each(|(to, &grey)| *to = [grey; 3]),
        }
    }
}

/// Full-range ITU-R BT.601 in 16-bit fixed point. Integer parts are added separately, so that the factors fit in 16
/// bits.
#[inline(always)]
fn rgb(y: u8, cb: u8, cr: u8) -> [u8; 3] {
    const HALF: i32 = 1 << 15;
    let [y, cb, cr] = [i32::from(y), i32::from(cb) - 128, i32::from(cr) - 128];
    let red = y + cr + ((26_345 * cr + HALF) >> 16);
    let green = y - cr + ((-22_554 * cb + 18_734 * cr + HALF) >> 16);
    let blue = y + 2 * cb + ((-14_942 * cb + HALF) >> 16);
    [red, green, blue].map(|channel| channel.clamp(0, 255) as u8)
}
