//! Layers that rearrange numbers without arithmetic.

use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::ensure;

use super::{Layer, Value};

/// Concatenation along an axis.
pub(crate) struct Concat {
    pub(crate) axis: usize,
}

impl Layer for Concat {
    fn name(&self) -> &'static str {
        "Concat"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let like = |a: &[usize], b: &[usize]| {
            a.len() == b.len() && (0..a.len()).all(|axis| axis == self.axis || a[axis] == b[axis])
        };
        let first = inputs.first().copied().unwrap_or_default();
        let fits = self.axis < first.len() && inputs.iter().all(|input| like(first, input));
        ensure!(fits, "values of shapes {inputs:?} cannot be concatenated along axis {}", self.axis);
        let mut shape: TVec<usize> = first.into();
        shape[self.axis] = inputs.iter().map(|input| input[self.axis]).sum();
        Ok(shape)
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        let length = |shape: &[usize]| shape[self.axis..].iter().product::<usize>();
        for (at, mut output) in output.chunks_exact_mut(length(shape).max(1)).enumerate() {
            for input in inputs {
                let length = length(input.shape);
                let (part, rest) = output.split_at_mut(length);
                part.copy_from_slice(&input.numbers[at * length..][..length]);
                output = rest;
            }
        }
    }
}

/// Zero padding, as (before, after) for each axis.
pub(crate) struct Pad {
    pub(crate) by_axis: Vec<[usize; 2]>,
}

impl Layer for Pad {
    fn name(&self) -> &'static str {
        "Pad"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let fits = inputs.len() == 1 && inputs[0].len() == self.by_axis.len();
        ensure!(fits, "cannot pad values of shapes {inputs:?} by {:?}", self.by_axis);
        let padded = inputs[0].iter().zip(&self.by_axis);
        Ok(padded.map(|(&extent, [before, after])| extent.saturating_add(*before).saturating_add(*after)).collect())
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        let strides = strides(shape);
        let start = self.by_axis.iter().zip(&strides).map(|([before, _], stride)| before * stride).sum();
        scatter(inputs[0].numbers, inputs[0].shape, &strides, start, output);
    }
}

/// Permutation of the axes: axis `i` of the output is axis `axes[i]` of the input.
pub(crate) struct Permute {
    pub(crate) axes: Vec<usize>,
}

impl Layer for Permute {
    fn name(&self) -> &'static str {
        "Permute"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let each_once = (0..self.axes.len()).all(|axis| self.axes.contains(&axis));
        let fits = each_once && inputs.len() == 1 && inputs[0].len() == self.axes.len();
        ensure!(fits, "cannot permute the axes of values of shapes {inputs:?} by {:?}", self.axes);
        Ok(self.axes.iter().map(|&axis| inputs[0][axis]).collect())
    }

    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]) {
        let mut steps = vec![0; shape.len()];
        for (&axis, stride) in self.axes.iter().zip(strides(shape)) {
            steps[axis] = stride;
        }
        scatter(inputs[0].numbers, inputs[0].shape, &steps, 0, output);
    }
}

/// Change of shape that keeps the order of the numbers.
pub(crate) struct Reshape {
    pub(crate) shape: TVec<usize>,
}

impl Layer for Reshape {
    fn name(&self) -> &'static str {
        "Reshape"
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let count = |shape: &[usize]| shape.iter().try_fold(1_usize, |count, &extent| count.checked_mul(extent));
        let fits = inputs.len() == 1 && count(inputs[0]) == count(&self.shape);
        ensure!(fits, "cannot reshape values of shapes {inputs:?} to {:?}", self.shape);
        Ok(self.shape.clone())
    }

    fn run(&self, inputs: &[Value<'_>], _: &[usize], output: &mut [f32]) {
        output.copy_from_slice(inputs[0].numbers);
    }
}

/// Row-major strides of a shape.
fn strides(shape: &[usize]) -> TVec<usize> {
    (0..shape.len()).map(|axis| shape[axis + 1..].iter().product()).collect()
}

/// Writes each number to the offset from `start` given by the steps along its axes.
fn scatter(numbers: &[f32], shape: &[usize], steps: &[usize], start: usize, output: &mut [f32]) {
    match (shape, steps) {
        ([_], [step]) => {
            let positions = output[start..].iter_mut().step_by((*step).max(1));
            positions.zip(numbers).for_each(|(position, number)| *position = *number);
        }
        ([extent, shape @ ..], [step, steps @ ..]) => {
            let length = shape.iter().product::<usize>().max(1);
            let parts = numbers.chunks_exact(length).take(*extent).enumerate();
            parts.for_each(|(i, part)| scatter(part, shape, steps, start + i * step, output));
        }
        _ => output.copy_from_slice(numbers),
    }
}
