//! Upsampling of a component to full size, bit-exact with libjpeg: sides at half size are interpolated with weights of
//! 3/4 and 1/4, others repeated.

use super::header::{Component, Frame};
use super::plane::Plane;
use crate::widest;

pub(crate) struct Upsampler<'a> {
    plane: &'a Plane,
    /// Size of a sample in px, horizontal and vertical.
    ratio: [usize; 2],
    interpolated: [bool; 2],
    width: usize,
    /// Buffers for the upsampled row and for the weighted sum of two rows.
    row: Vec<u8>,
    sums: Vec<u16>,
}

impl<'a> Upsampler<'a> {
    pub(crate) fn new(frame: &Frame, component: &Component, plane: &'a Plane) -> Self {
        let ratio = [0, 1].map(|axis| frame.largest[axis] / component.sampling[axis]);
        let wide = plane.size[0] > 2;
        let interpolated = [wide && ratio[0] == 2 && ratio[1] <= 2, ratio == [1, 2] || wide && ratio == [2, 2]];
        let row = vec![0; plane.size[0] * ratio[0]];
        Self { plane, ratio, interpolated, width: frame.width, row, sums: vec![0; plane.size[0]] }
    }

    /// Number of rows above and below that a row of samples is blended into.
    pub(crate) fn blurred_rows(&self) -> usize {
        usize::from(self.interpolated[1])
    }

    /// Returns row `y` of the picture.
    pub(crate) fn row(&mut self, y: usize) -> &[u8] {
        if self.ratio == [1, 1] {
            return self.plane.row(y);
        }
        widest(
            #[inline(always)]
            || self.write_row(y),
        );
        &self.row[..self.width]
    }

    #[inline(always)]
    fn write_row(&mut self, y: usize) {
        let own = self.plane.row(y / self.ratio[1]);
        match (self.ratio, self.interpolated) {
            (_, [true, false]) => interpolate_across(own, &mut self.row, pair_of_samples),
            (_, [across, true]) => {
                let near = if y.is_multiple_of(2) {
                    (y / 2).saturating_sub(1)
                } else {
                    (y / 2 + 1).min(self.plane.size[1] - 1)
                };
                let near = self.plane.row(near);
                for (sum, (&own, &near)) in self.sums.iter_mut().zip(own.iter().zip(near)) {
                    *sum = 3 * u16::from(own) + u16::from(near);
                }
                if across {
                    interpolate_across(&self.sums, &mut self.row, pair_of_sums);
                } else {
                    let rounding = 1 + (y % 2) as u16;
                    self.row.iter_mut().zip(&self.sums).for_each(|(to, sum)| *to = ((sum + rounding) / 4) as u8);
                }
            }
            ([across, _], _) => {
                self.row.chunks_exact_mut(across).zip(own).for_each(|(to, &sample)| to.fill(sample));
            }
        }
    }
}

/// Interpolates a row to twice its width; `pair` computes two pixels from the previous, current and next value.
#[inline(always)]
fn interpolate_across<T: Copy>(values: &[T], out: &mut [u8], pair: impl Fn(T, T, T) -> [u8; 2]) {
    let (out, last) = (out.as_chunks_mut::<2>().0, values.len() - 1);
    for (to, near) in out[1..].iter_mut().zip(values.array_windows::<3>()) {
        *to = pair(near[0], near[1], near[2]);
    }
    out[0] = pair(values[0], values[0], values[1]);
    out[last] = pair(values[last - 1], values[last], values[last]);
}

#[inline(always)]
fn pair_of_samples(left: u8, own: u8, right: u8) -> [u8; 2] {
    let [left, own, right] = [left, own, right].map(u16::from);
    [((3 * own + left + 1) / 4) as u8, ((3 * own + right + 2) / 4) as u8]
}

#[inline(always)]
fn pair_of_sums(left: u16, own: u16, right: u16) -> [u8; 2] {
    [((3 * own + left + 8) / 16) as u8, ((3 * own + right + 7) / 16) as u8]
}
