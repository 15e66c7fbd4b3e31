use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{bail, ensure};

use super::dense::{Dense, Part, Skip};
use super::depthwise::Depthwise;
use super::window::{Span, Window};
use super::{Layer, Value, picture};

/// A convolution over all input channels, optionally preceded by a depthwise convolution.
///
/// A second input is added to the sums before the activation; it may have fewer channels.
pub(crate) struct Convolution {
    pub(crate) depthwise: Option<Depthwise>,
    /// [`Window::POINT`] if a depthwise convolution precedes.
    pub(crate) window: Window,
    pub(crate) channels_in: usize,
    pub(crate) dense: Dense,
}

/// Number of pixels of the depthwise convolution per band, few enough to stay in the cache.
const PIXELS_PER_BAND: usize = 128;

impl Layer for Convolution {
    fn name(&self) -> &'static str {
        "Convolution"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let (input, skip) = match *inputs {
            [input] => (input, None),
            [input, skip] => (input, Some(skip)),
            _ => bail!("{} inputs", inputs.len()),
        };
        let [height, width, channels] = picture(input)?;
        ensure!(channels == self.channels_in, "{channels} channels, expected {}", self.channels_in);
        let window = self.depthwise.as_ref().map_or(&self.window, |depthwise| &depthwise.window);
        let [height, width] = window.output([height, width])?;
        if let Some(skip) = skip {
            let added = picture(skip)?;
            let fits = added[..2] == [height, width] && added[2] <= self.dense.channels;
            ensure!(fits, "cannot add {added:?} to {:?}", [height, width, self.dense.channels]);
        }
        Ok(tvec![1, height, width, self.dense.channels])
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        let skip = match inputs.get(1) {
            Some(skip) => Skip { numbers: skip.numbers, channels: skip.shape[3] },
            None => Skip { numbers: &[], channels: 0 },
        };
        let extents = [inputs[0].shape[1], inputs[0].shape[2]];
        match &self.depthwise {
            Some(depthwise) => self.after(depthwise, inputs[0].numbers, extents, skip, shape[2], output),
            None if self.window == Window::POINT => {
                let part = Part { numbers: inputs[0].numbers, weights: 0..self.channels_in };
                self.dense.run(&[part], self.channels_in, skip, output);
            }
            None => self.slide(inputs[0].numbers, extents, skip, shape[2], output),
        }
    }
}

impl Convolution {
    /// Runs both convolutions band by band, without a buffer for the whole intermediate picture.
    fn after(
        &self,
        depthwise: &Depthwise,
        numbers: &[f32],
        extents: [usize; 2],
        skip: Skip<'_>,
        width: usize,
        output: &mut [f32],
    ) {
        let row_length = width * depthwise.channels();
        let rows_per_band = PIXELS_PER_BAND.div_ceil(width);
        let spans = depthwise.window.spans(1, width, extents[1]);
        let mut intermediate = vec![0.0; rows_per_band * row_length];
        let bands = output.chunks_mut(rows_per_band * width * self.dense.channels);
        for (band, output) in bands.enumerate() {
            let rows = output.len() / (width * self.dense.channels);
            let first = band * rows_per_band;
            for (row, row_output) in intermediate.chunks_exact_mut(row_length).take(rows).enumerate() {
                depthwise.row(numbers, extents, &spans, first + row, row_output);
            }
            let part = Part { numbers: &intermediate, weights: 0..self.channels_in };
            self.dense.run(&[part], self.channels_in, skip.from(first * width), output);
        }
    }

    /// Slides row by row, in spans where the same taps are inside the picture. There, the inputs of a row of taps are
    /// contiguous from pixel to pixel.
    fn slide(&self, numbers: &[f32], extents: [usize; 2], skip: Skip<'_>, width: usize, output: &mut [f32]) {
        let spans = self.window.spans(1, width, extents[1]);
        let step = self.window.strides[1] * self.channels_in;
        for (y, row) in output.chunks_exact_mut(width * self.dense.channels).enumerate() {
            for span in &spans {
                let parts = self.parts(numbers, extents, y, span);
                let output = &mut row[span.positions.start * self.dense.channels..];
                let output = &mut output[..span.positions.len() * self.dense.channels];
                self.dense.run(&parts, step, skip.from(y * width + span.positions.start), output);
            }
        }
    }

    /// The inputs and weights of a span's pixels in row `y`.
    fn parts<'a>(&self, numbers: &'a [f32], extents: [usize; 2], y: usize, span: &Span) -> Vec<Part<'a>> {
        // Dilated taps are not contiguous.
        let together = if self.window.dilations[1] == 1 { span.taps.len().max(1) } else { 1 };
        let rows = self.window.taps(0, y, extents[0]);
        let taps = rows.flat_map(|row| span.taps.clone().step_by(together).map(move |column| (row, column)));
        taps.map(|(row, column)| {
            let pixel = self.window.pixel(0, y, row) * extents[1] + self.window.pixel(1, span.positions.start, column);
            let first_weight = (row * self.window.kernel[1] + column) * self.channels_in;
            Part {
                numbers: &numbers[pixel * self.channels_in..],
                weights: first_weight..first_weight + together * self.channels_in,
            }
        })
        .collect()
    }
}

/// A depthwise convolution that is not fused.
impl Layer for Depthwise {
    fn name(&self) -> &'static str {
        "Depthwise"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        ensure!(inputs.len() == 1, "{} inputs", inputs.len());
        let [height, width, channels] = picture(inputs[0])?;
        ensure!(channels == self.channels(), "{channels} channels, expected {}", self.channels());
        let [height, width] = self.window.output([height, width])?;
        Ok(tvec![1, height, width, channels])
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        let extents = [inputs[0].shape[1], inputs[0].shape[2]];
        let spans = self.window.spans(1, shape[2], extents[1]);
        for (y, row) in output.chunks_exact_mut(shape[2] * shape[3]).enumerate() {
            self.row(inputs[0].numbers, extents, &spans, y, row);
        }
    }
}
