use crate::photo::Photo;

/// Resamples to a smaller size, each new pixel the mean of the old ones it covers, weighted by how much of them it
/// covers. One pass over the source rows; means are taken of the sRGB values.
pub(crate) fn area_mean(photo: &Photo, width: u32, height: u32) -> Photo {
    let (columns, rows) = (Cover::all(photo.width(), width), Cover::all(photo.height(), height));
    let row_bytes = photo.width() as usize * 3;
    let mut pixels = Vec::with_capacity(width as usize * height as usize * 3);
    let mut sums = vec![0.0_f32; width as usize * 3];
    for row in &rows {
        sums.fill(0.0);
        for (y, weight) in row.weights() {
            add_row(&mut sums, &photo.pixels()[y * row_bytes..][..row_bytes], &columns, weight);
        }
        pixels.extend(sums.iter().map(|&sum| sum.round() as u8));
    }
    Photo::from_valid(width, height, pixels)
}

fn add_row(sums: &mut [f32], row: &[u8], columns: &[Cover], row_weight: f32) {
    for (sum, column) in sums.as_chunks_mut::<3>().0.iter_mut().zip(columns) {
        for (x, weight) in column.weights() {
            for channel in 0..3 {
                sum[channel] += row_weight * weight * f32::from(row[3 * x + channel]);
            }
        }
    }
}

/// Which old pixels along one axis a new pixel covers: `first..=last`, the two ends in part.
struct Cover {
    first: usize,
    last: usize,
    first_weight: f32,
    inner_weight: f32,
    last_weight: f32,
}

impl Cover {
    fn all(old_extent: u32, new_extent: u32) -> Vec<Self> {
        let ratio = f64::from(old_extent) / f64::from(new_extent);
        (0..new_extent).map(|i| Self::new(f64::from(i) * ratio, f64::from(i + 1) * ratio, old_extent)).collect()
    }

    /// The old pixels between two positions; weights sum to 1.
    fn new(start: f64, end: f64, old_extent: u32) -> Self {
        let first = start.floor();
        let last = (end.ceil() - 1.0).clamp(first, f64::from(old_extent) - 1.0);
        let length = end - start;
        Self {
            first: first as usize,
            last: last as usize,
            first_weight: (((first + 1.0).min(end) - start) / length) as f32,
            inner_weight: (1.0 / length) as f32,
            last_weight: ((end - last) / length) as f32,
        }
    }

    fn weights(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        (self.first..=self.last).map(|i| {
            let weight = match i {
                _ if i == self.first => self.first_weight,
                _ if i == self.last => self.last_weight,
                _ => self.inner_weight,
            };
            (i, weight)
        })
    }
}
