use glam::DVec2;

use crate::Photo;

/// Bicubic sampler of a picture.
pub struct Sampler<'a> {
    pixels: &'a [u8],
    width: usize,
    height: usize,
}

/// Four consecutive pixels of a row.
type Four = [u8; 12];

impl<'a> Sampler<'a> {
    /// Creates a sampler for a picture.
    pub fn new(photo: &'a Photo) -> Self {
        Self { pixels: photo.pixels(), width: photo.width() as usize, height: photo.height() as usize }
    }

    /// Samples red, green and blue with a Catmull–Rom kernel over 4 × 4 pixels, in sRGB levels.
    ///
    /// `position` is in px from the top left corner; the first pixel's centre is at (0.5, 0.5). Edge pixels extend
    /// beyond the picture. Overshoot yields values below 0 or above 255.
    #[inline]
    pub fn at(&self, position: DVec2) -> [f32; 3] {
        let ((column, across), (row, down)) = (split(position.x - 0.5), split(position.y - 0.5));
        let (column, row) = (column - 1, row - 1);
        let is_inside = column >= 0 && row >= 0 && column + 4 <= self.width as i64 && row + 4 <= self.height as i64;
        let rows: [Four; 4] = match is_inside {
            true => std::array::from_fn(|j| self.four(column as usize, row as usize + j)),
            false => std::array::from_fn(|j| self.four_at_edge(column, row + j as i64)),
        };
        mixed(&rows, weights(across), weights(down))
    }

    #[inline]
    fn four(&self, column: usize, row: usize) -> Four {
        let start = 3 * (row * self.width + column);
        self.pixels[start..].first_chunk().copied().unwrap_or_default()
    }

    #[cold]
    fn four_at_edge(&self, column: i64, row: i64) -> Four {
        let row = row.clamp(0, self.height as i64 - 1) as usize;
        std::array::from_fn(|byte| {
            let column = (column + byte as i64 / 3).clamp(0, self.width as i64 - 1) as usize;
            self.pixels[3 * (row * self.width + column) + byte % 3]
        })
    }
}

/// Splits a coordinate into its floor and fraction. `f64::floor` is a slow call on targets without the instruction.
#[inline]
fn split(position: f64) -> (i64, f32) {
    let towards_zero = position as i64;
    let below = towards_zero - i64::from(position < towards_zero as f64);
    (below, (position - below as f64) as f32)
}

/// Combines the four rows first, which vectorises over bytes, then the four pixels.
#[inline]
fn mixed(rows: &[Four; 4], across: [f32; 4], down: [f32; 4]) -> [f32; 3] {
    let mut column = [0.0_f32; 12];
    for (row, weight) in rows.iter().zip(down) {
        for (sum, byte) in column.iter_mut().zip(row) {
            *sum += weight * f32::from(*byte);
        }
    }
    [0, 1, 2].map(|channel| {
        across[0] * column[channel]
            + across[1] * column[3 + channel]
            + across[2] * column[6 + channel]
            + across[3] * column[9 + channel]
    })
}

/// Catmull–Rom weights of four pixels; `t` in 0..1 is the position between the second and the third.
#[inline]
fn weights(t: f32) -> [f32; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3), 0.5 * (t3 - t2)]
}
