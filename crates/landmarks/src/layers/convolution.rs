use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{bail, ensure};

use super::dense::{Dense, Part, Skip};
use super::depthwise::Depthwise;
use super::window::{Span, Window};
use super::{Layer, Value, picture};

/// A convolution over all input channels, of a picture or of what a depthwise convolution makes of it.
///
/// A second input is added to the sums before they are activated; it may have fewer channels.
pub(crate) struct Convolution {
    pub(crate) depthwise: Option<Depthwise>,
    /// [`Window::POINT`] after a depthwise convolution.
    pub(crate) window: Window,
    pub(crate) channels_in: usize,
    pub(crate) dense: Dense,
}

/// So many pixels of a depthwise convolution are made before they are summed: few enough to stay at hand.
const PIXELS_AT_HAND: usize = 128;

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
        ensure!(channels == self.channels_in, "{channels} channels where {} are read", self.channels_in);
        let window = self.depthwise.as_ref().map_or(&self.window, |depthwise| &depthwise.window);
        let [height, width] = window.output([height, width])?;
        if let Some(skip) = skip {
            let added = picture(skip)?;
            let fits = added[..2] == [height, width] && added[2] <= self.dense.channels;
            ensure!(fits, "{added:?} added to {:?}", [height, width, self.dense.channels]);
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
    /// Some rows at a time, so that what is between the two convolutions needs no memory of its own.
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
        let rows_at_hand = PIXELS_AT_HAND.div_ceil(width);
        let spans = depthwise.window.spans(1, width, extents[1]);
        let mut at_hand = vec![0.0; rows_at_hand * row_length];
        let bands = output.chunks_mut(rows_at_hand * width * self.dense.channels);
        for (band, output) in bands.enumerate() {
            let rows = output.len() / (width * self.dense.channels);
            let first = band * rows_at_hand;
            for (row, made) in at_hand.chunks_exact_mut(row_length).take(rows).enumerate() {
                depthwise.row(numbers, extents, &spans, first + row, made);
            }
            let part = Part { numbers: &at_hand, weights: 0..self.channels_in };
            self.dense.run(&[part], self.channels_in, skip.from(first * width), output);
        }
    }

    /// Row by row, and in a row where the same taps are inside the picture: there, the numbers under a row of taps are
    /// neighbours, pixel after pixel.
    fn slide(&self, numbers: &[f32], extents: [usize; 2], skip: Skip<'_>, width: usize, output: &mut [f32]) {
        let spans = self.window.spans(1, width, extents[1]);
        let step = self.window.strides[1] * self.channels_in;
        for (y, row) in output.chunks_exact_mut(width * self.dense.channels).enumerate() {
            for span in &spans {
                let parts = self.parts(numbers, extents, y, span);
                let output = &mut row[span.places.start * self.dense.channels..];
                let output = &mut output[..span.places.len() * self.dense.channels];
                self.dense.run(&parts, step, skip.from(y * width + span.places.start), output);
            }
        }
    }

    /// What the pixels of a span in row `y` sum.
    fn parts<'a>(&self, numbers: &'a [f32], extents: [usize; 2], y: usize, span: &Span) -> Vec<Part<'a>> {
        // Dilated taps are no neighbours.
        let together = if self.window.dilations[1] == 1 { span.taps.len().max(1) } else { 1 };
        let rows = self.window.taps(0, y, extents[0]);
        let taps = rows.flat_map(|row| span.taps.clone().step_by(together).map(move |column| (row, column)));
        taps.map(|(row, column)| {
            let pixel = self.window.pixel(0, y, row) * extents[1] + self.window.pixel(1, span.places.start, column);
            let first_weight = (row * self.window.kernel[1] + column) * self.channels_in;
            Part {
                numbers: &numbers[pixel * self.channels_in..],
                weights: first_weight..first_weight + together * self.channels_in,
            }
        })
        .collect()
    }
}

/// A depthwise convolution that nothing follows.
impl Layer for Depthwise {
    fn name(&self) -> &'static str {
        "Depthwise"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        ensure!(inputs.len() == 1, "{} inputs", inputs.len());
        let [height, width, channels] = picture(inputs[0])?;
        ensure!(channels == self.channels(), "{channels} channels where {} are read", self.channels());
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
