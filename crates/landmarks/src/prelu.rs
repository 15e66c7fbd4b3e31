use tract_onnx::tract_core::internal::*;
use tract_onnx::tract_core::{as_op, op_as_typed_op, op_out_of_plan};

/// `x` where it is positive, `slope · x` elsewhere, with one slope for each channel of an NCHW value.
///
/// One pass in place; tract's own takes three passes through memory and a mask.
#[derive(Debug, Clone, Hash, PartialEq, Eq)]
pub(crate) struct Prelu {
    /// f32, as many as there are channels.
    pub(crate) slopes: Arc<Tensor>,
}

impl Op for Prelu {
    fn name(&self) -> StaticName {
        "Prelu".into()
    }

    op_as_typed_op!();
}

impl EvalOp for Prelu {
    op_out_of_plan!();

    fn eval(&self, _: &EvalContext<'_>, mut inputs: TVec<TValue>) -> TractResult<TVec<TValue>> {
        let mut value = inputs.remove(0).into_tensor();
        let slopes = self.slopes.try_as_plain_ram()?.as_slice::<f32>()?;
        let &[1, channels, height, width] = value.shape() else { bail!("a value of shape {:?}", value.shape()) };
        ensure!(slopes.len() == channels, "{} slopes for {channels} channels", slopes.len());
        let mut values = value.try_as_plain_ram_mut()?;
        let planes = values.as_slice_mut::<f32>()?.chunks_exact_mut(height * width);
        for (plane, &slope) in planes.zip(slopes) {
            for x in plane {
                *x = if *x < 0.0 { *x * slope } else { *x };
            }
        }
        Ok(tvec![value.into_tvalue()])
    }
}

impl TypedOp for Prelu {
    fn output_facts(&self, inputs: &[&TypedFact]) -> TractResult<TVec<TypedFact>> {
        Ok(tvec![inputs[0].without_value()])
    }

    as_op!();
}
