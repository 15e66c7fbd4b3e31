use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{bail, ensure};

use super::activation::activated;
use super::window::Window;
use super::{Layer, Value, picture, widest};

/// Maximum under a window, for each channel.
pub(crate) struct MaxPool {
    pub(crate) window: Window,
}

impl Layer for MaxPool {
    fn name(&self) -> &'static str {
        "MaxPool"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        ensure!(inputs.len() == 1, "{} inputs", inputs.len());
        let [height, width, channels] = picture(inputs[0])?;
        let [height, width] = self.window.output([height, width])?;
        Ok(tvec![1, height, width, channels])
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        widest(
            #[inline(always)]
            || self.pool(&inputs[0], shape, output),
        );
    }
}

impl MaxPool {
    #[inline(always)]
    fn pool(&self, input: &Value<'_>, shape: &[usize], output: &mut [f32]) {
        let (extents, channels) = ([input.shape[1], input.shape[2]], shape[3]);
        for (at, output) in output.chunks_exact_mut(channels).enumerate() {
            let position = [at / shape[2], at % shape[2]];
            let [rows, columns] = [0, 1].map(|axis| self.window.taps(axis, position[axis], extents[axis]));
            output.fill(f32::NEG_INFINITY);
            for (row, column) in rows.flat_map(|row| columns.clone().map(move |column| (row, column))) {
                let pixel =
                    self.window.pixel(0, position[0], row) * extents[1] + self.window.pixel(1, position[1], column);
                for (largest, &number) in output.iter_mut().zip(&input.numbers[pixel * channels..]) {
                    *largest = if number > *largest { number } else { *largest };
                }
            }
        }
    }
}

/// Sum of one or two inputs of the same shape, then the activation with one slope per channel of the last axis, if any.
pub(crate) struct Sum {
    pub(crate) slopes: Option<Vec<f32>>,
}

impl Layer for Sum {
    fn name(&self) -> &'static str {
        "Sum"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let shape = match *inputs {
            [input] => input,
            [a, b] if a == b => a,
            _ => bail!("cannot add values of shapes {inputs:?}"),
        };
        if let Some(slopes) = &self.slopes {
            ensure!(shape.last() == Some(&slopes.len()), "{} slopes for a value of shape {shape:?}", slopes.len());
        }
        Ok(shape.into())
    }

    fn run(&self, inputs: &[Value<'_>], _: &[usize], output: &mut [f32]) {
        for input in inputs {
            output.iter_mut().zip(input.numbers).for_each(|(sum, number)| *sum += number);
        }
        if let Some(slopes) = &self.slopes {
            for pixel in output.chunks_exact_mut(slopes.len().max(1)) {
                pixel.iter_mut().zip(slopes).for_each(|(sum, &slope)| *sum = activated(*sum, slope));
            }
        }
    }
}
