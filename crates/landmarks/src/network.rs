use std::sync::Arc;

use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::ensure;

use crate::{LandmarksError, operators};

/// A network made ready to run: one square RGB picture in, two lists of numbers out.
pub(crate) struct Network {
    name: &'static str,
    side: usize,
    plan: Arc<TypedRunnableModel>,
}

impl Network {
    /// Reads an ONNX file whose input is `[1, 3, side, side]`, and asks for two of its outputs by name.
    pub(crate) fn new(
        name: &'static str,
        onnx: &[u8],
        side: usize,
        outputs: [&str; 2],
    ) -> Result<Self, LandmarksError> {
        let plan = optimised(onnx, side, outputs)
            .map_err(|error| LandmarksError::NetworkDamaged { network: name, reason: format!("{error:#}") })?;
        Ok(Self { name, side, plan })
    }

    /// Runs on a picture that `fill` writes as three planes (red, green, blue) of `side × side` values; the outputs
    /// must have the given lengths.
    pub(crate) fn run(
        &self,
        fill: impl FnOnce(&mut [f32]),
        lengths: [usize; 2],
    ) -> Result<[Vec<f32>; 2], LandmarksError> {
        self.try_run(fill, lengths)
            .map_err(|error| LandmarksError::NetworkFailed { network: self.name, reason: format!("{error:#}") })
    }

    fn try_run(&self, fill: impl FnOnce(&mut [f32]), lengths: [usize; 2]) -> TractResult<[Vec<f32>; 2]> {
        let mut input = Tensor::zero::<f32>(&[1, 3, self.side, self.side])?;
        fill(input.try_as_plain_ram_mut()?.as_slice_mut::<f32>()?);
        let outputs = self.plan.run(tvec![input.into()])?;
        let values = |index: usize| -> TractResult<Vec<f32>> {
            let values = outputs[index].try_as_plain_ram()?.as_slice::<f32>()?;
            ensure!(values.len() == lengths[index], "{} values, expected {}", values.len(), lengths[index]);
            Ok(values.to_vec())
        };
        Ok([values(0)?, values(1)?])
    }
}

fn optimised(onnx: &[u8], side: usize, outputs: [&str; 2]) -> TractResult<Arc<TypedRunnableModel>> {
    let mut bytes = onnx;
    operators::onnx()
        .model_for_read(&mut bytes)?
        .with_input_fact(0, f32::fact([1, 3, side, side]).into())?
        .with_outputs_by_name(outputs)?
        .into_optimized()?
        .into_runnable()
}
