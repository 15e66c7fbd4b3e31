//! The subset of the TFLite schema that the face networks use. Field and operator numbers are those of `schema.fbs`.

use std::collections::HashSet;

use crate::ImportError;
use crate::flatbuffer::Table;

/// A network: tensors, and operators in execution order.
pub(crate) struct Network<'a> {
    pub(crate) tensors: Vec<Tensor<'a>>,
    pub(crate) operators: Vec<Operator>,
    pub(crate) inputs: Vec<usize>,
    pub(crate) outputs: Vec<usize>,
}

/// A value, or a constant if `data` is not empty.
pub(crate) struct Tensor<'a> {
    pub(crate) name: String,
    /// NHWC for rank 4.
    pub(crate) shape: Vec<usize>,
    pub(crate) element_type: i8,
    /// Little-endian, row-major.
    pub(crate) data: &'a [u8],
}

/// TFLite's element type of half-precision weights.
pub(crate) const FLOAT16: i8 = 1;
/// TFLite's element type of padding.
pub(crate) const INT32: i8 = 2;

/// An operator; inputs and output are tensor indices.
pub(crate) struct Operator {
    pub(crate) code: i32,
    pub(crate) kind: Kind,
    pub(crate) inputs: Vec<usize>,
    pub(crate) output: usize,
}

/// Kind of operator, with its options.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Add,
    Concatenation {
        axis: i32,
    },
    Convolution(Window),
    DepthwiseConvolution(Window),
    Dequantize,
    MaxPool {
        window: Window,
        kernel: [usize; 2],
    },
    Relu,
    Reshape,
    Pad,
    Prelu,
    /// An unsupported operator; [`Network::part`] removes those of the face networks.
    Other,
}

/// Movement of a kernel over a picture. Pairs are (height, width).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Window {
    pub(crate) padding: Padding,
    pub(crate) strides: [usize; 2],
    pub(crate) dilations: [usize; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Padding {
    /// Output extent is `ceil(n / stride)`; odd padding adds one more after than before.
    Same,
    /// No padding.
    Valid,
}

impl Window {
    /// Padding before and after along an axis (0 = height, 1 = width) of extent `n` for a kernel of extent `k`:
    /// `total = max((ceil(n/s) − 1)·s + k − n, 0)`, before = total/2, after = the rest.
    pub(crate) fn pads(&self, axis: usize, n: usize, kernel: usize) -> [usize; 2] {
        if self.padding == Padding::Valid {
            return [0, 0];
        }
        let stride = self.strides[axis];
        let k = (kernel - 1) * self.dilations[axis] + 1;
        let total = ((n.div_ceil(stride) - 1) * stride + k).saturating_sub(n);
        [total / 2, total - total / 2]
    }
}

impl<'a> Network<'a> {
    /// Parses the first subgraph of a TFLite file.
    pub(crate) fn read(file: &'a [u8]) -> Result<Self, ImportError> {
        let model = Table::root(file, *b"TFL3")?;
        let codes = model.tables(1)?.iter().map(operator_code).collect::<Result<Vec<_>, _>>()?;
        let buffers = model.tables(4)?;
        let graph = model.tables(2)?.first().copied().ok_or(damaged("list of subgraphs"))?;
        let tensors = graph.tables(0)?.iter().map(|table| tensor(table, &buffers)).collect::<Result<Vec<_>, _>>()?;
        let operators =
            graph.tables(3)?.iter().map(|table| operator(table, &codes, &tensors)).collect::<Result<Vec<_>, _>>()?;
        let inputs = tensor_indices(&graph, 1, tensors.len())?;
        let outputs = tensor_indices(&graph, 2, tensors.len())?;
        Ok(Self { tensors, operators, inputs, outputs })
    }

    /// The part of the network that computes the tensors `outputs` from the tensors `inputs` and constants.
    pub(crate) fn part(mut self, inputs: &[&str], outputs: &[&str]) -> Result<Self, ImportError> {
        self.inputs = self.named(inputs)?;
        self.outputs = self.named(outputs)?;
        let mut needed: HashSet<usize> = self.outputs.iter().copied().collect();
        let mut selected = Vec::new();
        for operator in self.operators.into_iter().rev() {
            if needed.contains(&operator.output) && !self.inputs.contains(&operator.output) {
                needed.extend(&operator.inputs);
                selected.push(operator);
            }
        }
        selected.reverse();
        self.operators = selected;
        Ok(self)
    }

    fn named(&self, names: &[&str]) -> Result<Vec<usize>, ImportError> {
        let index = |name: &str| self.tensors.iter().position(|tensor| tensor.name == name);
        let missing = |name: &str| ImportError::NoSuchTensor { name: name.to_owned() };
        names.iter().map(|&name| index(name).ok_or_else(|| missing(name))).collect()
    }
}

fn damaged(what: &'static str) -> ImportError {
    ImportError::Damaged { what, offset: 0 }
}

/// Small codes are in the deprecated i8 field, larger ones in the i32 field; the other field is lower.
fn operator_code(table: &Table<'_>) -> Result<i32, ImportError> {
    Ok(i32::from(table.i8(0, 0)?).max(table.i32(3, 0)?))
}

fn tensor<'a>(table: &Table<'a>, buffers: &[Table<'a>]) -> Result<Tensor<'a>, ImportError> {
    let extents = table.i32s(0)?.into_iter().map(|extent| usize::try_from(extent).ok().filter(|&extent| extent > 0));
    let buffer = buffers.get(table.index(2)?).ok_or(damaged("buffer index"))?;
    Ok(Tensor {
        name: String::from_utf8_lossy(table.bytes(3)?).into_owned(),
        shape: extents.collect::<Option<_>>().ok_or(damaged("tensor shape"))?,
        element_type: table.i8(1, 0)?,
        data: buffer.bytes(0)?,
    })
}

fn operator(table: &Table<'_>, codes: &[i32], tensors: &[Tensor<'_>]) -> Result<Operator, ImportError> {
    let code = *codes.get(table.index(0)?).ok_or(damaged("operator code index"))?;
    let inputs = tensor_indices(table, 1, tensors.len())?;
    let output = *tensor_indices(table, 2, tensors.len())?.first().ok_or(damaged("operator output"))?;
    let unsupported =
        |what: String| ImportError::Unsupported { operator: code, output: tensors[output].name.clone(), what };
    let options = table.table(4)?;
    let kind = kind(code, options.as_ref())?;
    let activation = fused_activation(kind, options.as_ref())?;
    if activation != 0 {
        return Err(unsupported(format!("fused activation {activation}")));
    }
    if inputs.len() < kind.input_count() {
        return Err(unsupported(format!("{} inputs", inputs.len())));
    }
    Ok(Operator { code, kind, inputs, output })
}

impl Kind {
    fn input_count(self) -> usize {
        match self {
            Self::Convolution(_) | Self::DepthwiseConvolution(_) => 3,
            Self::Add | Self::Pad | Self::Prelu => 2,
            Self::Concatenation { .. } | Self::Dequantize | Self::MaxPool { .. } | Self::Relu | Self::Reshape => 1,
            Self::Other => 0,
        }
    }
}

fn kind(code: i32, options: Option<&Table<'_>>) -> Result<Kind, ImportError> {
    let need = || options.ok_or(damaged("operator options"));
    Ok(match code {
        0 => Kind::Add,
        2 => Kind::Concatenation { axis: need()?.i32(0, 0)? },
        3 => Kind::Convolution(window(need()?, Some([5, 4]))?),
        4 => Kind::DepthwiseConvolution(window(need()?, Some([6, 5]))?),
        6 => Kind::Dequantize,
        17 => Kind::MaxPool { window: window(need()?, None)?, kernel: [extent(need()?, 4)?, extent(need()?, 3)?] },
        19 => Kind::Relu,
        22 => Kind::Reshape,
        34 => Kind::Pad,
        54 => Kind::Prelu,
        _ => Kind::Other,
    })
}

fn window(options: &Table<'_>, dilation_fields: Option<[usize; 2]>) -> Result<Window, ImportError> {
    let padding = if options.i8(0, 0)? == 0 { Padding::Same } else { Padding::Valid };
    let dilations = match dilation_fields {
        Some([height, width]) => [extent(options, height)?, extent(options, width)?],
        None => [1, 1],
    };
    Ok(Window { padding, strides: [extent(options, 2)?, extent(options, 1)?], dilations })
}

/// A stride, dilation or kernel size: a positive i32, 1 if absent.
fn extent(options: &Table<'_>, field: usize) -> Result<usize, ImportError> {
    let value = usize::try_from(options.i32(field, 1)?).ok();
    value.filter(|&extent| extent > 0).ok_or(damaged("stride, dilation or kernel size"))
}

fn fused_activation(kind: Kind, options: Option<&Table<'_>>) -> Result<i8, ImportError> {
    let field = match kind {
        Kind::Add => 0,
        Kind::Concatenation { .. } => 1,
        Kind::Convolution(_) => 3,
        Kind::DepthwiseConvolution(_) => 4,
        Kind::MaxPool { .. } => 5,
        Kind::Dequantize | Kind::Relu | Kind::Reshape | Kind::Pad | Kind::Prelu | Kind::Other => return Ok(0),
    };
    options.map_or(Ok(0), |options| options.i8(field, 0))
}

fn tensor_indices(table: &Table<'_>, field: usize, count: usize) -> Result<Vec<usize>, ImportError> {
    let indices = table.i32s(field)?.into_iter();
    let checked = indices.map(|index| usize::try_from(index).ok().filter(|&index| index < count));
    checked.collect::<Option<_>>().ok_or(damaged("tensor index"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window(padding: Padding, stride: usize, dilation: usize) -> Window {
        Window { padding, strides: [stride; 2], dilations: [dilation; 2] }
    }

    #[test]
    fn same_padding_gives_the_extent_over_the_stride_rounded_up() {
        for (n, stride, kernel, dilation) in cases() {
            let [before, after] = window(Padding::Same, stride, dilation).pads(0, n, kernel);
            let extent = (kernel - 1) * dilation + 1;
            let padded = n + before + after;
            assert!(padded >= extent, "{n} {stride} {kernel} {dilation}");
            assert_eq!((padded - extent) / stride + 1, n.div_ceil(stride), "{n} {stride} {kernel} {dilation}");
            assert!(after == before || after == before + 1);
        }
    }

    #[test]
    fn valid_padding_is_zero() {
        assert!(cases().all(|(n, stride, kernel, d)| window(Padding::Valid, stride, d).pads(1, n, kernel) == [0, 0]));
    }

    fn cases() -> impl Iterator<Item = (usize, usize, usize, usize)> {
        let strides = |n| (1..4).map(move |stride| (n, stride));
        let kernels = |(n, stride)| (1..6).map(move |kernel| (n, stride, kernel));
        (1..40).flat_map(strides).flat_map(kernels).flat_map(|(n, s, k)| (1..3).map(move |d| (n, s, k, d)))
    }
}
