//! Layers of the face networks. Pictures are stored channels last: `[1, height, width, channels]`.
//!
//! Adjacent numbers are then channels, which undergo the same operations at any picture size. A border only omits taps,
//! and a 1 × 1 convolution is a matrix product with one row per pixel. The code is portable: the compiler vectorises
//! loops over arrays of fixed length, for the widest instructions of the machine ([`widest`]).

mod activation;
mod convolution;
mod dense;
mod depthwise;
mod pooling;
mod rearrange;
#[cfg(test)]
mod reference_tests;
mod window;

use std::fmt;
use std::sync::Arc;

use tract_onnx::tract_core::internal::*;
use tract_onnx::tract_core::{as_op, op_as_typed_op, op_out_of_plan};

pub(crate) use convolution::Convolution;
pub(crate) use dense::Dense;
pub(crate) use depthwise::Depthwise;
pub(crate) use pooling::{MaxPool, Sum};
pub(crate) use rearrange::{Concat, Pad, Permute, Reshape};
pub(crate) use rosto_photo::widest;
pub(crate) use window::Window;

/// A layer of a network.
pub(crate) trait Layer: Send + Sync + 'static {
    /// Name of the kind of layer.
    fn name(&self) -> &'static str;

    /// Shape of the output.
    ///
    /// # Errors
    /// If the layer cannot run on inputs of these shapes.
    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>>;

    /// Fills `output`, which contains zeros and has the shape from [`Self::output_shape`].
    fn run(&self, inputs: &[Value<'_>], shape: &[usize], output: &mut [f32]);
}

/// An input of a layer.
pub(crate) struct Value<'a> {
    pub(crate) shape: &'a [usize],
    pub(crate) numbers: &'a [f32],
}

/// A layer as a tract operator.
#[derive(Clone)]
pub(crate) struct Operator(Arc<dyn Layer>);

/// Limit on the elements of a value, far above the face networks', so that damaged files cannot exhaust memory.
const MAX_ELEMENTS: usize = 1 << 24;

impl Operator {
    pub(crate) fn new(layer: impl Layer) -> Self {
        Self(Arc::new(layer))
    }

    fn output_shape(&self, inputs: &[&[usize]]) -> TractResult<TVec<usize>> {
        let shape = self.0.output_shape(inputs)?;
        let numbers = shape.iter().try_fold(1_usize, |numbers, &extent| numbers.checked_mul(extent));
        ensure!(numbers.is_some_and(|numbers| numbers <= MAX_ELEMENTS), "a value of shape {shape:?} is too large");
        Ok(shape)
    }
}

/// Height, width and channels of a picture.
fn picture(shape: &[usize]) -> TractResult<[usize; 3]> {
    match *shape {
        [1, height, width, channels] => Ok([height, width, channels]),
        _ => bail!("a value of shape {shape:?} is not a picture"),
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
        let shapes = inputs.iter().map(|fact| fact.shape.as_concrete().context("the shape is not known"));
        let shape = self.output_shape(&shapes.collect::<TractResult<TVec<_>>>()?)?;
        Ok(tvec![f32::fact(shape)])
    }

    as_op!();
}
