//! The ONNX messages that the face networks need. Field numbers are those of `onnx.proto`.

use prost::Message;

const INT_ATTRIBUTE: i32 = 2;
const INTS_ATTRIBUTE: i32 = 7;

/// Element type of a tensor, `TensorProto.DataType`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum ElementType {
    F32 = 1,
    I64 = 7,
    F16 = 10,
}

/// The root message of a file.
#[derive(Clone, PartialEq, Message)]
pub(crate) struct Model {
    #[prost(int64, tag = "1")]
    pub(crate) ir_version: i64,
    #[prost(string, tag = "2")]
    pub(crate) producer_name: String,
    #[prost(message, optional, tag = "7")]
    pub(crate) graph: Option<Graph>,
    #[prost(message, repeated, tag = "8")]
    pub(crate) opset_import: Vec<OperatorSet>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct OperatorSet {
    #[prost(string, tag = "1")]
    pub(crate) domain: String,
    #[prost(int64, tag = "2")]
    pub(crate) version: i64,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Graph {
    #[prost(message, repeated, tag = "1")]
    pub(crate) nodes: Vec<Node>,
    #[prost(string, tag = "2")]
    pub(crate) name: String,
    #[prost(message, repeated, tag = "5")]
    pub(crate) initialisers: Vec<Tensor>,
    #[prost(message, repeated, tag = "11")]
    pub(crate) inputs: Vec<ValueInfo>,
    #[prost(message, repeated, tag = "12")]
    pub(crate) outputs: Vec<ValueInfo>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Node {
    #[prost(string, repeated, tag = "1")]
    pub(crate) inputs: Vec<String>,
    #[prost(string, repeated, tag = "2")]
    pub(crate) outputs: Vec<String>,
    #[prost(string, tag = "3")]
    pub(crate) name: String,
    #[prost(string, tag = "4")]
    pub(crate) op_type: String,
    #[prost(message, repeated, tag = "5")]
    pub(crate) attributes: Vec<Attribute>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Attribute {
    #[prost(string, tag = "1")]
    pub(crate) name: String,
    #[prost(int64, optional, tag = "3")]
    pub(crate) int: Option<i64>,
    #[prost(int64, repeated, tag = "8")]
    pub(crate) ints: Vec<i64>,
    #[prost(int32, tag = "20")]
    pub(crate) kind: i32,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Tensor {
    #[prost(int64, repeated, tag = "1")]
    pub(crate) shape: Vec<i64>,
    #[prost(int32, tag = "2")]
    pub(crate) element_type: i32,
    #[prost(string, tag = "8")]
    pub(crate) name: String,
    #[prost(bytes = "vec", tag = "9")]
    pub(crate) raw_data: Vec<u8>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct ValueInfo {
    #[prost(string, tag = "1")]
    pub(crate) name: String,
    #[prost(message, optional, tag = "2")]
    pub(crate) value_type: Option<ValueType>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct ValueType {
    #[prost(message, optional, tag = "1")]
    pub(crate) tensor: Option<TensorType>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct TensorType {
    #[prost(int32, tag = "1")]
    pub(crate) element_type: i32,
    #[prost(message, optional, tag = "2")]
    pub(crate) shape: Option<Shape>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Shape {
    #[prost(message, repeated, tag = "1")]
    pub(crate) dimensions: Vec<Dimension>,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct Dimension {
    // A member of a oneof, so 0 is also written.
    #[prost(int64, optional, tag = "1")]
    pub(crate) value: Option<i64>,
}

impl Model {
    /// A file of opset 13, which requires IR version 7.
    pub(crate) fn opset_13(graph: Graph) -> Self {
        Self {
            ir_version: 7,
            producer_name: env!("CARGO_PKG_NAME").to_owned(),
            graph: Some(graph),
            opset_import: vec![OperatorSet { domain: String::new(), version: 13 }],
        }
    }
}

impl Node {
    /// A node named after its only output.
    pub(crate) fn new(op_type: &str, inputs: &[&str], output: &str) -> Self {
        Self {
            inputs: inputs.iter().map(|&name| name.to_owned()).collect(),
            outputs: vec![output.to_owned()],
            name: output.to_owned(),
            op_type: op_type.to_owned(),
            attributes: Vec::new(),
        }
    }

    /// Adds an integer attribute.
    pub(crate) fn int(mut self, name: &str, value: i64) -> Self {
        let name = name.to_owned();
        self.attributes.push(Attribute { name, int: Some(value), ints: Vec::new(), kind: INT_ATTRIBUTE });
        self
    }

    /// Adds an attribute with a list of integers.
    pub(crate) fn ints(mut self, name: &str, values: &[i64]) -> Self {
        let name = name.to_owned();
        self.attributes.push(Attribute { name, int: None, ints: values.to_vec(), kind: INTS_ATTRIBUTE });
        self
    }
}

impl Tensor {
    /// Creates a constant from little-endian bytes in row-major order.
    pub(crate) fn new(name: &str, element_type: ElementType, shape: &[usize], raw_data: Vec<u8>) -> Self {
        let shape = shape.iter().map(|&extent| extent as i64).collect();
        Self { shape, element_type: element_type as i32, name: name.to_owned(), raw_data }
    }

    /// Creates a one-dimensional i64 constant.
    pub(crate) fn i64s(name: &str, values: &[i64]) -> Self {
        let bytes = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        Self::new(name, ElementType::I64, &[values.len()], bytes)
    }
}

impl ValueInfo {
    /// Creates an f32 input or output of the graph.
    pub(crate) fn f32(name: &str, shape: &[usize]) -> Self {
        let dimensions = shape.iter().map(|&extent| Dimension { value: Some(extent as i64) }).collect();
        let tensor = TensorType { element_type: ElementType::F32 as i32, shape: Some(Shape { dimensions }) };
        Self { name: name.to_owned(), value_type: Some(ValueType { tensor: Some(tensor) }) }
    }
}
