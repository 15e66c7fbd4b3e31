/// Downscales a picture by area averaging, in one pass over the source rows.
///
/// A new pixel is the mean of the sRGB values that it covers, weighted by the covered area.
pub(crate) fn area_mean(source: &[[u8; 3]], [old_width, old_height]: [u32; 2], [width, height]: [u32; 2]) -> Vec<u8> {
    let (columns, rows) = (Coverage::all(old_width, width), Coverage::all(old_height, height));
    let mut pixels = Vec::with_capacity(width as usize * height as usize * 3);
    let mut sums = vec![[0.0_f32; 3]; width as usize];
    for row in &rows {
        sums.fill([0.0; 3]);
        for y in row.first..=row.last {
            add_row(&mut sums, &source[y * old_width as usize..], &columns, row.weight(y));
        }
        pixels.extend(sums.iter().flatten().map(|&sum| sum.round() as u8));
    }
    pixels
}

fn add_row(sums: &mut [[f32; 3]], row: &[[u8; 3]], columns: &[Coverage], row_weight: f32) {
    for (sum, column) in sums.iter_mut().zip(columns) {
        let mean = column.mean(row);
        for channel in 0..3 {
            sum[channel] += row_weight * mean[channel];
        }
    }
}

/// Source pixels along one axis that a new pixel covers: `first..=last`, partially at both ends. Weights sum to 1.
struct Coverage {
    first: usize,
    last: usize,
    first_weight: f32,
    inner_weight: f32,
    /// 0 if `first == last`.
    last_weight: f32,
}

impl Coverage {
    fn all(old_extent: u32, new_extent: u32) -> Vec<Self> {
        let ratio = f64::from(old_extent) / f64::from(new_extent);
        (0..new_extent).map(|i| Self::new(f64::from(i) * ratio, f64::from(i + 1) * ratio, old_extent)).collect()
    }

    /// Coverage between two source positions.
    fn new(start: f64, end: f64, old_extent: u32) -> Self {
        let first = start.floor();
        let last = (end.ceil() - 1.0).clamp(first, f64::from(old_extent) - 1.0);
        let length = end - start;
        Self {
            first: first as usize,
            last: last as usize,
            first_weight: (((first + 1.0).min(end) - start) / length) as f32,
            inner_weight: (1.0 / length) as f32,
            last_weight: if last > first { ((end - last) / length) as f32 } else { 0.0 },
        }
    }

    fn weight(&self, index: usize) -> f32 {
        match index {
            _ if index == self.first => self.first_weight,
            _ if index == self.last => self.last_weight,
            _ => self.inner_weight,
        }
    }

    /// Mean of the covered pixels of a row; inner pixels are summed as integers.
    fn mean(&self, row: &[[u8; 3]]) -> [f32; 3] {
        let mut inner = [0_u32; 3];
        for pixel in row.get(self.first + 1..self.last).unwrap_or_default() {
            for channel in 0..3 {
                inner[channel] += u32::from(pixel[channel]);
            }
        }
        let (first, last) = (row[self.first], row[self.last]);
        std::array::from_fn(|channel| {
            self.first_weight * f32::from(first[channel])
                + self.inner_weight * inner[channel] as f32
                + self.last_weight * f32::from(last[channel])
        })
    }
}
