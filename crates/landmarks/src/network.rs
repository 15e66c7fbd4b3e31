use std::sync::Arc;

use tract_onnx::Onnx;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

use crate::{LandmarksError, graph, part};

/// A network or a part of one, ready to run.
pub struct Network {
    name: &'static str,
    inputs: Vec<Input>,
    plan: Arc<TypedRunnableModel>,
}

/// An input of a network; its shape is `[1, channels, side, side]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Input {
    pub(crate) name: &'static str,
    pub(crate) channels: usize,
    pub(crate) side: usize,
}

impl Network {
    /// Loads an ONNX file with a picture `[1, 3, side, side]` as its only input, and the named outputs.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`] if the file is not such a network.
    pub fn of_picture(name: &'static str, onnx: &[u8], side: usize, outputs: &[&str]) -> Result<Self, LandmarksError> {
        Self::part(name, onnx, &[Input { name: "", channels: 3, side }], outputs)
    }

    /// Loads the part of an ONNX file that computes the named outputs from the named inputs. A single input with an
    /// empty name is the file's only input.
    pub(crate) fn part(
        name: &'static str,
        onnx: &[u8],
        inputs: &[Input],
        outputs: &[&str],
    ) -> Result<Self, LandmarksError> {
        let plan = runnable(onnx, inputs, outputs)
            .map_err(|error| LandmarksError::NetworkDamaged { network: name, reason: format!("{error:#}") })?;
        Ok(Self { name, inputs: inputs.to_vec(), plan })
    }

    /// Runs on the inputs that `fill(index, planes)` writes, each `channels` planes of `side × side` values. Returns
    /// the outputs, which must have the given lengths. Intact networks produce finite outputs for any picture.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkFailed`] if it cannot be run, [`LandmarksError::NetworkDamaged`] if an output is not
    /// finite.
    pub fn run<const N: usize>(
        &self,
        fill: impl FnMut(usize, &mut [f32]),
        lengths: [usize; N],
    ) -> Result<[Vec<f32>; N], LandmarksError> {
        let outputs = self
            .try_run(fill, lengths)
            .map_err(|error| LandmarksError::NetworkFailed { network: self.name, reason: format!("{error:#}") })?;
        Self::check_finite(self.name, outputs.iter().flatten())?;
        Ok(outputs)
    }

    /// Rejects a network's output if a number is not finite.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`] for a number that is not finite.
    pub(crate) fn check_finite<'a>(
        network: &'static str,
        mut answer: impl Iterator<Item = &'a f32>,
    ) -> Result<(), LandmarksError> {
        match answer.find(|number| !number.is_finite()) {
            Some(number) => {
                let reason = format!("its output contains {number}");
                Err(LandmarksError::NetworkDamaged { network, reason })
            }
            None => Ok(()),
        }
    }

    fn try_run<const N: usize>(
        &self,
        mut fill: impl FnMut(usize, &mut [f32]),
        lengths: [usize; N],
    ) -> TractResult<[Vec<f32>; N]> {
        let mut inputs = tvec![];
        for (index, &Input { channels, side, .. }) in self.inputs.iter().enumerate() {
            let mut input = Tensor::zero::<f32>(&[1, channels, side, side])?;
            fill(index, input.try_as_plain_ram_mut()?.as_slice_mut::<f32>()?);
            inputs.push(input.into());
        }
        let outputs = self.plan.run(inputs)?;
        let mut answers = [const { Vec::new() }; N];
        for ((answer, output), length) in answers.iter_mut().zip(outputs).zip(lengths) {
            let values = output.try_as_plain_ram()?.as_slice::<f32>()?;
            ensure!(values.len() == length, "{} values, expected {length}", values.len());
            *answer = values.to_vec();
        }
        Ok(answers)
    }
}

fn runnable(onnx: &[u8], inputs: &[Input], outputs: &[&str]) -> TractResult<Arc<TypedRunnableModel>> {
    let mut bytes = onnx;
    let proto = Onnx::default().proto_model_for_read(&mut bytes)?;
    let mut graph = proto.graph.context("the file has no graph")?;
    if inputs.iter().all(|input| !input.name.is_empty()) {
        let names: Vec<&str> = inputs.iter().map(|input| input.name).collect();
        part::reduce(&mut graph, &names, outputs)?;
    }
    let model = graph::model(&graph, outputs)?;
    ensure!(model.inputs.len() == inputs.len(), "{} inputs, expected {}", model.inputs.len(), inputs.len());
    for (index, &Input { channels, side, .. }) in inputs.iter().enumerate() {
        let shape = &model.input_fact(index)?.shape;
        ensure!(shape.as_concrete() == Some(&[1, channels, side, side]), "its input has the shape {shape:?}");
    }
    model.into_runnable()
}
