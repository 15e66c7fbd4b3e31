use std::sync::Arc;

use tract_onnx::Onnx;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

use crate::{LandmarksError, graph};

/// A network made ready to run: one square RGB picture in, two lists of numbers out.
pub struct Network {
    name: &'static str,
    side: usize,
    plan: Arc<TypedRunnableModel>,
}

impl Network {
    /// Reads an ONNX file whose input is `[1, 3, side, side]`, and asks for two of its outputs by name.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`].
    pub fn new(name: &'static str, onnx: &[u8], side: usize, outputs: [&str; 2]) -> Result<Self, LandmarksError> {
        let plan = runnable(onnx, side, outputs)
            .map_err(|error| LandmarksError::NetworkDamaged { network: name, reason: format!("{error:#}") })?;
        Ok(Self { name, side, plan })
    }

    /// Runs on a picture that `fill` writes as three planes (red, green, blue) of `side × side` values; the outputs
    /// must have the given lengths. Whole networks answer every picture with finite numbers, so that others come from
    /// damaged weights.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkFailed`], [`LandmarksError::NetworkDamaged`].
    pub fn run(&self, fill: impl FnOnce(&mut [f32]), lengths: [usize; 2]) -> Result<[Vec<f32>; 2], LandmarksError> {
        let outputs = self
            .try_run(fill, lengths)
            .map_err(|error| LandmarksError::NetworkFailed { network: self.name, reason: format!("{error:#}") })?;
        self.check_finite(outputs.iter().flatten())?;
        Ok(outputs)
    }

    /// Refuses what the network answered if a number among it is infinite or none.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`].
    pub(crate) fn check_finite<'a>(&self, mut answer: impl Iterator<Item = &'a f32>) -> Result<(), LandmarksError> {
        match answer.find(|number| !number.is_finite()) {
            Some(number) => {
                let reason = format!("it answers a picture with {number}");
                Err(LandmarksError::NetworkDamaged { network: self.name, reason })
            }
            None => Ok(()),
        }
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

fn runnable(onnx: &[u8], side: usize, outputs: [&str; 2]) -> TractResult<Arc<TypedRunnableModel>> {
    let mut bytes = onnx;
    let proto = Onnx::default().proto_model_for_read(&mut bytes)?;
    let model = graph::model(proto.graph.as_ref().context("there is no graph in it")?, &outputs)?;
    let input = &model.input_fact(0)?.shape;
    ensure!(model.inputs.len() == 1 && input.as_concrete() == Some(&[1, 3, side, side]), "it reads {input:?}");
    model.into_runnable()
}
