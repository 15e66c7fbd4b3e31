//! What the face networks are made of, with pictures kept channels last: `[1, height, width, channels]`.
//!
//! Neighbouring numbers are then channels, which all have the same to be done to them, in the smallest picture as in the
//! largest; a border is taps left out, and a pixel of a 1 × 1 convolution is one row of a matrix product. Nothing here is
//! written for one machine: loops over arrays of a fixed length become its vector instructions, the widest that it has
//! (`vectors`).

mod activation;
mod convolution;
mod dense;
mod depthwise;
mod moving;
#[cfg(test)]
mod naive;
mod pooling;
mod vectors;
mod window;

use std::fmt;
use std::sync::Arc;

use tract_onnx::tract_core::internal::*;
use tract_onnx::tract_core::{as_op, op_as_typed_op, op_out_of_plan};

pub(crate) use convolution::Convolution;
pub(crate) use dense::Dense;
pub(crate) use depthwise::Depthwise;
pub(crate) use moving::{Concat, Pad, Permute, Reshape};
pub(crate) use pooling::{MaxPool, Sum};
pub(crate) use vectors::widest;
pub(crate) use window::Window;

/// One step of a network.
pub(crate) trait Layer: Send + Sync + 'static {
    /// What it is.
    fn name(&self) -> &'static str;

    /// The shape of what it answers.
    ///
    /// # Errors
    /// If it cannot be run on inputs of these shapes.
    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>>;

    /// Fills `output`, zeros before, which has the shape that [`Self::output_shape`] gave for these inputs.
    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]);
}

/// What a layer reads.
pub(crate) struct Value<'a> {
    pub(crate) shape: &'a [usize],
    pub(crate) numbers: &'a [f32],
}

/// A layer as tract runs it.
#[derive(Clone)]
pub(crate) struct Operator(Arc<dyn Layer>);

/// No value of a face network comes near; damaged ones might ask for any amount of memory.
const MOST_NUMBERS: usize = 1 << 24;

impl Operator {
    pub(crate) fn new(layer: impl Layer) -> Self {
        Self(Arc::new(layer))
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let shape = self.0.output_shape(inputs)?;
        let numbers = shape.iter().try_fold(1_usize, |numbers, &extent| numbers.checked_mul(extent));
        ensure!(numbers.is_some_and(|numbers| numbers <= MOST_NUMBERS), "a value of shape {shape:?}");
        Ok(shape)
    }
}

/// Height, width and channels of a picture.
fn picture(shape: &[usize]) -> TractResult<[usize; 3]> {
    match *shape {
        [1, height, width, channels] => Ok([height, width, channels]),
        _ => bail!("a value of shape {shape:?} is no picture"),
    }
}

impl fmt::Debug for Operator {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.0.name())
    }
}

impl PartialEq for Operator {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Operator {}

impl Op for Operator {
    fn name(&self) -> StaticName {
        self.0.name().into()
    }

    op_as_typed_op!();
}

impl EvalOp for Operator {
    op_out_of_plan!();

    fn eval(&self, _: &EvalContext<'_>, inputs: TVec<TValue>) -> TractResult<TVec<TValue>> {
        let shape = self.output_shape(&inputs.iter().map(|input| input.shape()).collect::<TVec<_>>())?;
        let mut output = Tensor::zero::<f32>(&shape)?;
        let views = inputs.iter().map(|input| input.try_as_plain_ram()).collect::<TractResult<TVec<_>>>()?;
        let values = inputs.iter().zip(&views);
        let values = values.map(|(input, view)| Ok(Value { shape: input.shape(), numbers: view.as_slice::<f32>()? }));
        let values = values.collect::<TractResult<TVec<_>>>()?;
        self.0.run(&values, &shape, output.try_as_plain_ram_mut()?.as_slice_mut::<f32>()?);
        Ok(tvec![output.into_tvalue()])
    }
}

impl TypedOp for Operator {
    fn output_facts(&self, inputs: &[&TypedFact]) -> TractResult<TVec<TypedFact>> {
        let shapes = inputs.iter().map(|fact| fact.shape.as_concrete().context("a shape that is not known"));
        let shape = self.output_shape(&shapes.collect::<TractResult<TVec<_>>>()?)?;
        Ok(tvec![f32::fact(shape)])
    }

    as_op!();
}
