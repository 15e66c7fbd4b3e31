//! Conversion from TFLite to ONNX, operator by operator.
//!
//! Rank 4 values are NHWC in TFLite and NCHW in ONNX; values of other ranks have one layout. Convolution weights go
//! from `[out, height, width, in]` to `[out, in, height, width]`, depthwise weights from `[1, height, width, channels]`
//! to `[channels, 1, height, width]`.

use prost::Message;

use crate::ImportError;
use crate::onnx::{ElementType, Graph, Model, Node, Tensor as Constant, ValueInfo};
use crate::tflite::{FLOAT16, INT32, Kind, Network, Operator, Tensor, Window};

/// Converts a TFLite network to an ONNX file (opset 13, NCHW, half-precision weights).
///
/// # Errors
/// If the file is damaged, or the network uses an unsupported operator, type or shape.
pub fn onnx_from_tflite(tflite: &[u8]) -> Result<Vec<u8>, ImportError> {
    onnx_of(&Network::read(tflite)?)
}

/// Converts the part of a TFLite network that computes the tensors `outputs` from the tensors `inputs`.
///
/// # Errors
/// The errors of [`onnx_from_tflite`], and [`ImportError::NoSuchTensor`] for an unknown name.
pub fn onnx_of_part(tflite: &[u8], inputs: &[&str], outputs: &[&str]) -> Result<Vec<u8>, ImportError> {
    onnx_of(&Network::read(tflite)?.part(inputs, outputs)?)
}

fn onnx_of(network: &Network<'_>) -> Result<Vec<u8>, ImportError> {
    let mut converter = Converter { network, graph: Graph { name: "face".to_owned(), ..Graph::default() } };
    for operator in &network.operators {
        converter.convert(operator)?;
    }
    let mut graph = converter.graph;
    graph.inputs = network.inputs.iter().map(|&index| value_info(&network.tensors[index])).collect();
    graph.outputs = network.outputs.iter().map(|&index| value_info(&network.tensors[index])).collect();
    Ok(Model::opset_13(graph).encode_to_vec())
}

/// Permutation of the axes from NHWC to NCHW.
const NCHW_FROM_NHWC: [usize; 4] = [0, 3, 1, 2];
/// Permutation of the axes from TFLite's depthwise weights to ONNX's.
const DEPTHWISE_WEIGHTS: [usize; 4] = [3, 0, 1, 2];

struct Converter<'a> {
    network: &'a Network<'a>,
    graph: Graph,
}

impl Converter<'_> {
    fn convert(&mut self, operator: &Operator) -> Result<(), ImportError> {
        match operator.kind {
            Kind::Dequantize => self.dequantize(operator),
            Kind::Convolution(window) => self.convolution(operator, window, Depth::Full),
            Kind::DepthwiseConvolution(window) => self.convolution(operator, window, Depth::PerChannel),
            Kind::MaxPool { window, kernel } => self.max_pool(operator, window, kernel),
            Kind::Pad => self.pad(operator),
            Kind::Reshape => self.reshape(operator),
            Kind::Concatenation { axis } => self.concatenation(operator, axis),
            Kind::Add => self.elementwise("Add", operator),
            Kind::Relu => self.elementwise("Relu", operator),
            Kind::Prelu => self.elementwise("PRelu", operator),
            Kind::Other => Err(self.unsupported(operator, "this operator")),
        }
    }

    fn tensor(&self, index: usize) -> &Tensor<'_> {
        &self.network.tensors[index]
    }

    fn push(&mut self, node: Node) {
        self.graph.nodes.push(node);
    }

    /// Stores half-precision weights, with a `Cast`, in the layout that their reader needs.
    fn dequantize(&mut self, operator: &Operator) -> Result<(), ImportError> {
        let (weights, output) = (self.tensor(operator.inputs[0]), self.tensor(operator.output));
        let bytes = weights.shape.iter().try_fold(2_usize, |bytes, &extent| bytes.checked_mul(extent));
        if weights.element_type != FLOAT16 || bytes != Some(weights.data.len()) {
            return Err(self.unsupported(operator, "dequantisation of anything but half-precision constants"));
        }
        let axes = self.weight_axes(operator.output, weights.shape.len());
        let shape: Vec<_> = axes.iter().map(|&axis| weights.shape[axis]).collect();
        let data = transposed_halves(weights.data, &weights.shape, &axes);
        let constant = Constant::new(&weights.name, ElementType::F16, &shape, data);
        let cast = Node::new("Cast", &[&weights.name], &output.name).int("to", ElementType::F32 as i64);
        self.graph.initialisers.push(constant);
        self.push(cast);
        Ok(())
    }

    /// Permutation of the axes of a constant for the operator that reads it.
    fn weight_axes(&self, constant: usize, rank: usize) -> Vec<usize> {
        let reader = self.network.operators.iter().find(|operator| operator.inputs.contains(&constant));
        match (reader.map(|reader| reader.kind), rank) {
            (Some(Kind::DepthwiseConvolution(_)), 4) => DEPTHWISE_WEIGHTS.to_vec(),
            (Some(Kind::Prelu), 3) => vec![2, 0, 1],
            (_, 4) => NCHW_FROM_NHWC.to_vec(),
            _ => (0..rank).collect(),
        }
    }

    fn convolution(&mut self, operator: &Operator, window: Window, depth: Depth) -> Result<(), ImportError> {
        let [picture, weights, bias] = [0, 1, 2].map(|i| self.tensor(operator.inputs[i]));
        let (&[_, height, width, channels], &[_, kernel_height, kernel_width, _]) =
            (picture.shape.as_slice(), weights.shape.as_slice())
        else {
            return Err(self.unsupported(operator, "a rank other than 4"));
        };
        let groups = match depth {
            Depth::Full => 1,
            Depth::PerChannel if weights.shape[3] == channels => channels,
            Depth::PerChannel => return Err(self.unsupported(operator, "a depth multiplier")),
        };
        let node = Node::new("Conv", &[&picture.name, &weights.name, &bias.name], &self.tensor(operator.output).name);
        let node = sliding(node, window, [height, width], [kernel_height, kernel_width]);
        self.push(node.ints("dilations", &window.dilations.map(|d| d as i64)).int("group", groups as i64));
        Ok(())
    }

    fn max_pool(&mut self, operator: &Operator, window: Window, kernel: [usize; 2]) -> Result<(), ImportError> {
        let picture = self.tensor(operator.inputs[0]);
        let &[_, height, width, _] = picture.shape.as_slice() else {
            return Err(self.unsupported(operator, "a rank other than 4"));
        };
        let node = Node::new("MaxPool", &[&picture.name], &self.tensor(operator.output).name);
        self.push(sliding(node, window, [height, width], kernel));
        Ok(())
    }

    /// Zero padding. TFLite lists (before, after) per NHWC axis; ONNX lists the values before, then after, in NCHW.
    fn pad(&mut self, operator: &Operator) -> Result<(), ImportError> {
        let [picture, pads] = [0, 1].map(|i| self.tensor(operator.inputs[i]));
        if pads.element_type != INT32 || pads.data.len() != 4 * 8 || picture.shape.len() != 4 {
            return Err(self.unsupported(operator, "padding other than constant padding of a rank 4 value"));
        }
        let values: Vec<i64> =
            pads.data.chunks_exact(4).map(|b| i64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]]))).collect();
        let onnx_pads: Vec<i64> =
            [0, 1].iter().flat_map(|end| NCHW_FROM_NHWC.map(|axis| values[2 * axis + end])).collect();
        let constant = Constant::i64s(&pads.name, &onnx_pads);
        let node = Node::new("Pad", &[&picture.name, &pads.name], &self.tensor(operator.output).name);
        self.graph.initialisers.push(constant);
        self.push(node);
        Ok(())
    }

    /// Transposes to NHWC first, because TFLite's reshape keeps the values in that order.
    fn reshape(&mut self, operator: &Operator) -> Result<(), ImportError> {
        let (input, output) = (self.tensor(operator.inputs[0]), self.tensor(operator.output));
        if input.shape.len() != 4 || output.shape.len() == 4 {
            return Err(self.unsupported(operator, "a reshape other than from rank 4 to another rank"));
        }
        let (nhwc, shape) = (format!("{}/nhwc", output.name), format!("{}/shape", output.name));
        let transpose = Node::new("Transpose", &[&input.name], &nhwc).ints("perm", &[0, 2, 3, 1]);
        let reshape = Node::new("Reshape", &[&nhwc, &shape], &output.name);
        let extents: Vec<i64> = output.shape.iter().map(|&extent| extent as i64).collect();
        self.graph.initialisers.push(Constant::i64s(&shape, &extents));
        self.push(transpose);
        self.push(reshape);
        Ok(())
    }

    fn concatenation(&mut self, operator: &Operator, axis: i32) -> Result<(), ImportError> {
        if self.tensor(operator.output).shape.len() == 4 {
            return Err(self.unsupported(operator, "rank 4"));
        }
        let node = self.node_of_all_inputs("Concat", operator);
        self.push(node.int("axis", i64::from(axis)));
        Ok(())
    }

    fn elementwise(&mut self, op_type: &str, operator: &Operator) -> Result<(), ImportError> {
        let node = self.node_of_all_inputs(op_type, operator);
        self.push(node);
        Ok(())
    }

    fn node_of_all_inputs(&self, op_type: &str, operator: &Operator) -> Node {
        let names: Vec<&str> = operator.inputs.iter().map(|&index| self.tensor(index).name.as_str()).collect();
        Node::new(op_type, &names, &self.tensor(operator.output).name)
    }

    fn unsupported(&self, operator: &Operator, what: &str) -> ImportError {
        let output = self.tensor(operator.output).name.clone();
        ImportError::Unsupported { operator: operator.code, output, what: what.to_owned() }
    }
}

/// Number of input channels per output channel of a convolution.
enum Depth {
    Full,
    PerChannel,
}

fn sliding(node: Node, window: Window, extents: [usize; 2], kernel: [usize; 2]) -> Node {
    let [[top, bottom], [left, right]] = [0, 1].map(|axis| window.pads(axis, extents[axis], kernel[axis]));
    node.ints("kernel_shape", &kernel.map(|k| k as i64))
        .ints("strides", &window.strides.map(|s| s as i64))
        .ints("pads", &[top, left, bottom, right].map(|pad| pad as i64))
}

fn value_info(tensor: &Tensor<'_>) -> ValueInfo {
    match *tensor.shape.as_slice() {
        [n, height, width, channels] => ValueInfo::f32(&tensor.name, &[n, channels, height, width]),
        ref other => ValueInfo::f32(&tensor.name, other),
    }
}

/// Permutes the axes of an array of 2-byte elements: axis `i` of the result is axis `axes[i]` of the source.
fn transposed_halves(data: &[u8], shape: &[usize], axes: &[usize]) -> Vec<u8> {
    let stride = |axis: usize| shape[axis + 1..].iter().product::<usize>();
    let mut offsets = vec![0];
    for &axis in axes {
        let steps = 0..shape[axis];
        offsets = offsets.iter().flat_map(|at| steps.clone().map(move |i| at + i * stride(axis))).collect();
    }
    offsets.iter().flat_map(|at| [data[2 * at], data[2 * at + 1]]).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::support;

    fn models() -> [Model; 3] {
        let (loader_js, packed) = support::package();
        let networks = crate::import(&loader_js, &packed).unwrap();
        [networks.detector_onnx, networks.landmarks_onnx, networks.attention_onnx]
            .map(|onnx| Model::decode(onnx.as_slice()).unwrap())
    }

    fn parameters(graph: &Graph) -> i64 {
        let halves = graph.initialisers.iter().filter(|tensor| tensor.element_type == ElementType::F16 as i32);
        halves.map(|tensor| tensor.shape.iter().product::<i64>()).sum()
    }

    #[test]
    fn all_weights_keep_half_precision() {
        let counts = models().map(|model| parameters(&model.graph.unwrap()));
        assert_eq!(counts, [101_390, 604_685, 1_189_277]);
    }

    #[test]
    fn nodes_are_topologically_sorted_with_unique_outputs() {
        for model in models() {
            let graph = model.graph.unwrap();
            let given = graph.inputs.iter().map(|input| input.name.clone());
            let mut known: HashSet<String> = given.chain(graph.initialisers.iter().map(|t| t.name.clone())).collect();
            for node in &graph.nodes {
                assert!(node.inputs.iter().all(|input| known.contains(input)), "{}", node.name);
                assert!(node.outputs.iter().all(|output| known.insert(output.clone())), "{}", node.name);
            }
            assert!(graph.outputs.iter().all(|output| known.contains(&output.name)));
        }
    }

    #[test]
    fn permuting_axes_transposes_the_elements() {
        let data: Vec<u8> = (0..6_u16).flat_map(u16::to_le_bytes).collect();
        let moved = transposed_halves(&data, &[2, 3], &[1, 0]);
        let numbers: Vec<u16> = moved.chunks(2).map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]])).collect();
        assert_eq!(numbers, [0, 3, 1, 4, 2, 5]);
    }
}
