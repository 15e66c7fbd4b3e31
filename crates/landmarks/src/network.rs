use std::sync::Arc;

use tract_onnx::Onnx;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

use crate::{LandmarksError, graph, part};

/// A network, or a part of one, made ready to run: lists of numbers in, lists of numbers out.
pub struct Network {
    name: &'static str,
    inputs: Vec<Input>,
    plan: Arc<TypedRunnableModel>,
}

/// An input of a network by its name, and its shape `[channels, side, side]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Input {
    pub(crate) name: &'static str,
    pub(crate) channels: usize,
    pub(crate) side: usize,
}

impl Network {
    /// Reads an ONNX file whose only input is a picture `[1, 3, side, side]`, and asks for the outputs named.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`].
    pub fn of_picture(name: &'static str, onnx: &[u8], side: usize, outputs: &[&str]) -> Result<Self, LandmarksError> {
        Self::part(name, onnx, &[Input { name: "", channels: 3, side }], outputs)
    }

    /// Reads the part of an ONNX file that computes the outputs named out of the inputs named, in their order. A single
    /// input without a name is the file's only one.
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

    /// Runs on what `fill` writes for each input (by its number), `channels` planes of `side × side` values; the outputs
    /// must have the given lengths. Whole networks answer every picture with finite numbers, so that others come from
    /// damaged weights.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkFailed`], [`LandmarksError::NetworkDamaged`].
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

    /// Refuses what the network of that name answered if a number among it is infinite or none.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`].
    pub(crate) fn check_finite<'a>(
        network: &'static str,
        mut answer: impl Iterator<Item = &'a f32>,
    ) -> Result<(), LandmarksError> {
        match answer.find(|number| !number.is_finite()) {
            Some(number) => {
                let reason = format!("it answers a picture with {number}");
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
    let mut graph = proto.graph.context("there is no graph in it")?;
    if inputs.iter().all(|input| !input.name.is_empty()) {
        let names: Vec<&str> = inputs.iter().map(|input| input.name).collect();
        part::keep(&mut graph, &names, outputs)?;
    }
    let model = graph::model(&graph, outputs)?;
    ensure!(model.inputs.len() == inputs.len(), "{} inputs, expected {}", model.inputs.len(), inputs.len());
    for (index, &Input { channels, side, .. }) in inputs.iter().enumerate() {
        let shape = &model.input_fact(index)?.shape;
        ensure!(shape.as_concrete() == Some(&[1, channels, side, side]), "it reads {shape:?}");
    }
    model.into_runnable()
}
