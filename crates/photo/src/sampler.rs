use glam::DVec2;

use crate::Photo;

/// Reads a picture between its pixels.
pub struct Sampler<'a> {
    pixels: &'a [u8],
    width: usize,
    height: usize,
}

/// Four pixels of a row.
type Four = [u8; 12];

impl<'a> Sampler<'a> {
    /// Of a picture.
    pub fn new(photo: &'a Photo) -> Self {
        Self { pixels: photo.pixels(), width: photo.width() as usize, height: photo.height() as usize }
    }

    /// Red, green and blue at a place, by Catmull and Rom's cubic through the four pixels around it each way, in sRGB levels:
    /// what it overshoots is below 0 or above 255. Px from the picture's top left corner, where the first pixel's middle is
    /// at (0.5, 0.5); beyond the edge, the edge goes on.
    #[inline]
    pub fn at(&self, place: DVec2) -> [f32; 3] {
        let ((column, across), (row, down)) = (split(place.x - 0.5), split(place.y - 0.5));
        let (column, row) = (column - 1, row - 1);
        let is_inside = column >= 0 && row >= 0 && column + 4 <= self.width as i64 && row + 4 <= self.height as i64;
        let rows: [Four; 4] = match is_inside {
            true => std::array::from_fn(|j| self.four(column as usize, row as usize + j)),
            false => std::array::from_fn(|j| self.four_at_the_edge(column, row + j as i64)),
        };
        mixed(&rows, weights(across), weights(down))
    }

    #[inline]
    fn four(&self, column: usize, row: usize) -> Four {
        let start = 3 * (row * self.width + column);
        self.pixels[start..].first_chunk().copied().unwrap_or_default()
    }

    #[cold]
    fn four_at_the_edge(&self, column: i64, row: i64) -> Four {
        let row = row.clamp(0, self.height as i64 - 1) as usize;
        std::array::from_fn(|byte| {
            let column = (column + byte as i64 / 3).clamp(0, self.width as i64 - 1) as usize;
            self.pixels[3 * (row * self.width + column) + byte % 3]
        })
    }
}

/// The whole number below, and how far it is from there; processors without an instruction for it call a slow function.
#[inline]
fn split(place: f64) -> (i64, f32) {
    let towards_zero = place as i64;
    let below = towards_zero - i64::from(place < towards_zero as f64);
    (below, (place - below as f64) as f32)
}

/// First all rows into one, which is the same for each byte, then its four pixels. Plain loops become vector instructions.
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

/// Catmull and Rom's weights of the four pixels around a place that is so far from the second to the third.
#[inline]
fn weights(share: f32) -> [f32; 4] {
    let t = share;
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3), 0.5 * (t3 - t2)]
}
