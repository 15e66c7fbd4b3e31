//! Conversion of an ONNX graph with ten kinds of operators to a tract model with few layers.
//!
//! A convolution stays pending, so that a following 1 × 1 convolution (after a depthwise one), addition or activation
//! can be fused into it, if the intermediate value has no other reader. Pictures are stored channels last; ONNX stores
//! them channels first.

mod attributes;
#[cfg(test)]
mod equivalence;
mod pending;
mod wiring;

use std::collections::HashMap;

use tract_onnx::pb::tensor_shape_proto::dimension::Value as Extent;
use tract_onnx::pb::type_proto::Value as TypeValue;
use tract_onnx::pb::{GraphProto, NodeProto, TensorProto, ValueInfoProto};
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, bail, ensure};

use crate::constants;
use crate::layers::{Concat, MaxPool, Pad, Permute, Reshape};
use attributes::Attributes;
use pending::Pending;

/// Converts a graph to a model with the named outputs. Inputs and outputs have the shapes of the file.
///
/// # Errors
/// If the graph has an unsupported operator, or an operator does not fit its inputs.
pub(crate) fn model(graph: &GraphProto, outputs: &[&str]) -> TractResult<TypedModel> {
    let mut reader = Reader::new(graph, outputs);
    for input in graph.input.iter().filter(|input| !reader.values.contains_key(&*input.name)).collect::<Vec<_>>() {
        reader.source(input)?;
    }
    ensure!(!reader.model.inputs.is_empty(), "the graph has no input");
    for node in &graph.node {
        let value = reader.value_of(node).with_context(|| format!("node {} ({})", node.name, node.op_type))?;
        let [output] = &*node.output else { bail!("node {} has {} outputs", node.name, node.output.len()) };
        let known = reader.values.insert(output, value);
        ensure!(known.is_none(), "node {} redefines {output}", node.name);
    }
    let outlets = outputs.iter().map(|name| reader.in_file_order(name)).collect::<TractResult<Vec<_>>>()?;
    reader.model.select_output_outlets(&outlets)?;
    Ok(reader.model)
}

/// Permutation from the file's axes (channels first) to channels last.
const CHANNELS_LAST: [usize; 4] = [0, 2, 3, 1];
/// Permutation from channels last to the file's axes. Also maps an axis of the file to its position in channels last
/// order.
const CHANNELS_FIRST: [usize; 4] = [0, 3, 1, 2];

struct Reader<'a> {
    model: TypedModel,
    values: HashMap<&'a str, Value<'a>>,
    /// Number of nodes and outputs that read each value.
    readers: HashMap<&'a str, usize>,
}

/// A value of the graph.
enum Value<'a> {
    Constant(&'a TensorProto),
    Wired(Wire),
    /// Layers that are not added to the model yet, because following operators may be fused into them.
    Pending(Box<Pending>),
    /// A picture, and the number of zero channels to append to it.
    WithMoreChannels(Wire, usize),
}

/// A value of the model.
#[derive(Debug, Clone, Copy)]
struct Wire {
    outlet: OutletId,
    order: Order,
}

/// Order of a value's axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    /// The file's order.
    FileOrder,
    /// A picture, stored channels last instead of channels first.
    ChannelsLast,
}

impl<'a> Reader<'a> {
    fn new(graph: &'a GraphProto, outputs: &[&'a str]) -> Self {
        let mut readers = HashMap::new();
        let inputs = graph.node.iter().flat_map(|node| &node.input).map(String::as_str);
        inputs.chain(outputs.iter().copied()).for_each(|name| *readers.entry(name).or_default() += 1);
        let constants = graph.initializer.iter().map(|tensor| (&*tensor.name, Value::Constant(tensor)));
        Self { model: TypedModel::default(), values: constants.collect(), readers }
    }

    fn source(&mut self, input: &'a ValueInfoProto) -> TractResult<()> {
        let shape = declared_shape(input).with_context(|| format!("input {} has no shape", input.name))?;
        let outlet = self.model.add_source(&input.name, f32::fact(shape))?;
        self.values.insert(&input.name, Value::Wired(Wire { outlet, order: Order::FileOrder }));
        Ok(())
    }

    fn value_of(&mut self, node: &'a NodeProto) -> TractResult<Value<'a>> {
        let name = || node.output.first().map(String::as_str).context("no output");
        let inputs: Vec<&str> = node.input.iter().map(String::as_str).collect();
        match (&*node.op_type, &*inputs) {
            ("Cast", [input]) => self.cast(node, input),
            ("Conv", [input, weights]) => self.convolution(node, input, weights, None),
            ("Conv", [input, weights, biases]) => self.convolution(node, input, weights, Some(*biases)),
            ("Add", [a, b]) => self.add(name()?, a, b),
            ("Relu", [input]) => self.activate(name()?, input, None),
            ("PRelu", [input, slopes]) => self.activate(name()?, input, Some(slopes)),
            ("MaxPool", [input]) => {
                let picture = self.picture(input)?;
                let window = node.window(node.extents("kernel_shape")?, [1; 2])?;
                self.wire(name()?, MaxPool { window }, &[picture], Order::ChannelsLast).map(Value::Wired)
            }
            ("Pad", [input, pads]) => self.pad(name()?, input, pads),
            ("Concat", inputs) => self.concat(name()?, inputs, node.get_attr("axis")?),
            ("Reshape", [input, shape]) => {
                let outlet = self.in_file_order(input)?;
                let shape = self.integers(shape)?.into_iter().map(usize::try_from).collect::<Result<_, _>>()?;
                self.wire(name()?, Reshape { shape }, &[outlet], Order::FileOrder).map(Value::Wired)
            }
            ("Transpose", [input]) => self.transpose(name()?, input, node.get_attr_vec("perm")?),
            _ => bail!("unsupported operator with {} inputs", node.input.len()),
        }
    }

    /// Weights are converted to single precision when they are read.
    fn cast(&mut self, node: &NodeProto, input: &str) -> TractResult<Value<'a>> {
        ensure!(node.get_attr::<DatumType>("to")? == DatumType::F32, "the target type is not single precision");
        Ok(Value::Constant(self.constant(input)?))
    }

    fn pad(&mut self, name: &str, input: &str, pads: &str) -> TractResult<Value<'a>> {
        let pads = self.integers(pads)?.into_iter().map(usize::try_from).collect::<Result<Vec<_>, _>>()?;
        let picture = self.picture(input)?;
        ensure!(pads.len() == 8, "{} pads for a picture", pads.len());
        let by_axis = CHANNELS_LAST.map(|axis| [pads[axis], pads[axis + 4]]);
        match by_axis {
            [[0, 0], [0, 0], [0, 0], [0, more]] => {
                Ok(Value::WithMoreChannels(Wire { outlet: picture, order: Order::ChannelsLast }, more))
            }
            _ => {
                let layer = Pad { by_axis: by_axis.to_vec() };
                self.wire(name, layer, &[picture], Order::ChannelsLast).map(Value::Wired)
            }
        }
    }

    fn concat(&mut self, name: &str, inputs: &[&str], axis: i64) -> TractResult<Value<'a>> {
        let wires = inputs.iter().map(|input| self.wired(input)).collect::<TractResult<Vec<_>>>()?;
        let rank = wires.first().map_or(Ok(0), |wire| self.rank(wire.outlet))?;
        let axis = usize::try_from(if axis < 0 { axis + rank as i64 } else { axis })?;
        ensure!(axis < rank, "axis {axis} of values of rank {rank}");
        if wires.iter().any(|wire| wire.order == Order::ChannelsLast) {
            let pictures = inputs.iter().map(|input| self.picture(input)).collect::<TractResult<Vec<_>>>()?;
            let layer = Concat { axis: CHANNELS_FIRST[axis] };
            return self.wire(name, layer, &pictures, Order::ChannelsLast).map(Value::Wired);
        }
        let outlets: Vec<OutletId> = wires.iter().map(|wire| wire.outlet).collect();
        self.wire(name, Concat { axis }, &outlets, Order::FileOrder).map(Value::Wired)
    }

    /// A transpose to channels last only relabels a value that is stored so.
    fn transpose(&mut self, name: &str, input: &str, axes: Vec<usize>) -> TractResult<Value<'a>> {
        let wire = self.wired(input)?;
        let order = Order::FileOrder;
        match (wire.order, &*axes) {
            (Order::ChannelsLast, [0, 2, 3, 1]) => Ok(Value::Wired(Wire { order, ..wire })),
            _ => {
                let outlet = self.in_file_order(input)?;
                self.wire(name, Permute { axes }, &[outlet], order).map(Value::Wired)
            }
        }
    }

    fn value(&self, name: &str) -> TractResult<&Value<'a>> {
        self.values.get(name).with_context(|| format!("{name} is not defined"))
    }

    fn constant(&self, name: &str) -> TractResult<&'a TensorProto> {
        match self.value(name)? {
            Value::Constant(tensor) => Ok(tensor),
            _ => bail!("{name} is not a constant"),
        }
    }

    fn integers(&self, name: &str) -> TractResult<Vec<i64>> {
        constants::integers(self.constant(name)?)
    }
}

/// The declared shape of an input.
fn declared_shape(input: &ValueInfoProto) -> Option<TVec<usize>> {
    let TypeValue::TensorType(tensor) = input.r#type.as_ref()?.value.as_ref()?;
    let extents = tensor.shape.as_ref()?.dim.iter().map(|dimension| match dimension.value {
        Some(Extent::DimValue(extent)) => usize::try_from(extent).ok(),
        _ => None,
    });
    extents.collect()
}
