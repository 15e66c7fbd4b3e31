//! The ten ONNX operators of the face networks, and no others.
//!
//! tract-onnx knows some two hundred; naming all of them would carry all of them into the browser.

use tract_onnx::Onnx;
use tract_onnx::model::{OnnxOpRegister, ParsingContext};
use tract_onnx::pb::NodeProto;
use tract_onnx::tract_core::ops::array::{Pad, PadMode};
use tract_onnx::tract_core::ops::cast::cast;
use tract_onnx::tract_hir::internal::*;
use tract_onnx::tract_hir::ops::activations::Clip;
use tract_onnx::tract_hir::ops::array::{Concat, PermuteAxes, Reshape};
use tract_onnx::tract_hir::ops::cnn::{Conv, HirMaxPool, PaddingSpec, PoolSpec};
use tract_onnx::tract_hir::ops::math::Add;
use tract_onnx::tract_hir::ops::nn::DataFormat;

use crate::prelu::Prelu;

/// A reader of ONNX files for networks of these operators.
pub(crate) fn onnx() -> Onnx {
    let mut op_register = OnnxOpRegister::default();
    op_register.insert("Add", |_, _| Ok((Add.into_hir(), vec![])));
    op_register.insert("Cast", |_, node| Ok((expand(HirCast { to: node.get_attr("to")? }), vec![])));
    op_register.insert("Concat", |_, node| Ok((expand(Concat::new(node.get_attr("axis")?)), vec![])));
    op_register.insert("Conv", convolution);
    op_register.insert("MaxPool", max_pool);
    op_register.insert("Pad", |_, _| Ok((expand(HirPad), vec![])));
    op_register.insert("PRelu", |_, _| Ok((expand(HirPrelu), vec![])));
    op_register.insert("Relu", |_, _| Ok((expand(Clip::new(Some(0.0), None)), vec![])));
    op_register.insert("Reshape", |_, _| Ok((expand(Reshape::new(false)), vec![])));
    op_register
        .insert("Transpose", |_, node| Ok((expand(PermuteAxes::new(Some(node.get_attr_tvec("perm")?))), vec![])));
    Onnx { op_register, ..Onnx::default() }
}

/// What tract calls an operator that is still to be given its types.
type Built = TractResult<(Box<dyn InferenceOp>, Vec<String>)>;

fn convolution(_: &ParsingContext, node: &NodeProto) -> Built {
    let [before, after] = pads(node)?;
    let convolution = Conv::default()
        .padding(PaddingSpec::Explicit(before, after))
        .kernel_shape(node.get_attr_tvec("kernel_shape")?)
        .strides(node.get_attr_tvec("strides")?)
        .dilations(node.get_attr_tvec("dilations")?)
        .group(node.get_attr("group")?)
        .bias_input(2);
    Ok((expand(convolution), vec![]))
}

fn max_pool(_: &ParsingContext, node: &NodeProto) -> Built {
    let [before, after] = pads(node)?;
    let window = PoolSpec::new(
        DataFormat::NCHW,
        node.get_attr_tvec("kernel_shape")?,
        PaddingSpec::ExplicitOnnxPool(before, after, false),
        None,
        Some(node.get_attr_tvec("strides")?),
        0,
        0,
    );
    Ok((expand(HirMaxPool::new(window, None)), vec![]))
}

/// Pads before and after, by axis.
fn pads(node: &NodeProto) -> TractResult<[TVec<usize>; 2]> {
    let pads = node.get_attr_tvec::<usize>("pads")?;
    let (before, after) = pads.split_at(pads.len() / 2);
    Ok([before.into(), after.into()])
}

/// Weights from half to single precision.
#[derive(Debug, Clone, Hash, PartialEq, Eq)]
struct HirCast {
    to: DatumType,
}

impl Expansion for HirCast {
    fn name(&self) -> StaticName {
        "Cast".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        solver: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 1)?;
        check_output_arity(outputs, 1)?;
        solver.equals(&outputs[0].datum_type, self.to)?;
        solver.equals(&outputs[0].shape, &inputs[0].shape)
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        model.wire_node(name, cast(self.to), inputs)
    }
}

/// Zeros around a value, as many as the constant second input says: all befores, then all afters.
#[derive(Debug, Clone, Hash, PartialEq, Eq)]
struct HirPad;

impl HirPad {
    fn by_axis(pads: &Tensor) -> TractResult<Vec<(usize, usize)>> {
        let pads = pads.cast_to::<i64>()?;
        let pads = pads.try_as_plain_ram()?.as_slice::<i64>()?;
        let (before, after) = pads.split_at(pads.len() / 2);
        Ok(before.iter().zip(after).map(|(&before, &after)| (before as usize, after as usize)).collect())
    }
}

impl Expansion for HirPad {
    fn name(&self) -> StaticName {
        "Pad".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        solver: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 2)?;
        check_output_arity(outputs, 1)?;
        solver.equals(&outputs[0].datum_type, &inputs[0].datum_type)?;
        solver.equals(&outputs[0].rank, &inputs[0].rank)?;
        solver.given(&inputs[1].value, move |solver, pads| {
            for (axis, (before, after)) in Self::by_axis(&pads)?.into_iter().enumerate() {
                solver.equals(&outputs[0].shape[axis], inputs[0].shape[axis].bex() + (before + after).to_dim())?;
            }
            Ok(())
        })
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let pads = constant(model, inputs[1])?;
        let pads = Self::by_axis(&pads)?;
        let mode = PadMode::Constant(rctensor0(0_f32));
        model.wire_node(name, Pad { pads, mode }, &inputs[..1])
    }
}

/// PReLU whose slopes, one for each channel, are constant.
#[derive(Debug, Clone, Hash, PartialEq, Eq)]
struct HirPrelu;

impl Expansion for HirPrelu {
    fn name(&self) -> StaticName {
        "PRelu".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        solver: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 2)?;
        check_output_arity(outputs, 1)?;
        solver.equals(&outputs[0].datum_type, &inputs[0].datum_type)?;
        solver.equals(&outputs[0].shape, &inputs[0].shape)
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let slopes = constant(model, inputs[1])?;
        model.wire_node(name, Prelu { slopes }, &inputs[..1])
    }
}

fn constant(model: &TypedModel, outlet: OutletId) -> TractResult<Arc<Tensor>> {
    model.outlet_fact(outlet)?.konst.clone().context("an input that should be constant is not")
}
