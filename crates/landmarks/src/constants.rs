//! Decoding of the constants of an ONNX file.

use tract_onnx::pb::TensorProto;
use tract_onnx::pb::tensor_proto::DataType;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, bail, ensure};

/// The shape of a constant.
pub(crate) fn shape(tensor: &TensorProto) -> TractResult<TVec<usize>> {
    let extents = tensor.dims.iter().map(|&extent| usize::try_from(extent).ok());
    extents.collect::<Option<_>>().with_context(|| format!("{} has the shape {:?}", tensor.name, tensor.dims))
}

/// Decodes half or single precision numbers, in the order of the file.
///
/// # Errors
/// If their number does not match the shape, or one is not finite.
pub(crate) fn floats(tensor: &TensorProto) -> TractResult<Vec<f32>> {
    let numbers: Vec<f32> = match DataType::try_from(tensor.data_type) {
        Ok(DataType::Float16) => elements(tensor)?.iter().map(|&bytes| f16::from_le_bytes(bytes).to_f32()).collect(),
        Ok(DataType::Float) => elements(tensor)?.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect(),
        _ => bail!("{} has the element type {}", tensor.name, tensor.data_type),
    };
    let wrong = numbers.iter().find(|number| !number.is_finite());
    ensure!(wrong.is_none(), "{} contains the weight {}", tensor.name, wrong.unwrap_or(&f32::NAN));
    Ok(numbers)
}

/// Decodes i64 numbers.
///
/// # Errors
/// If their number does not match the shape.
pub(crate) fn integers(tensor: &TensorProto) -> TractResult<Vec<i64>> {
    let is_whole = tensor.data_type == DataType::Int64 as i32;
    ensure!(is_whole, "{} has the element type {}", tensor.name, tensor.data_type);
    Ok(elements(tensor)?.iter().map(|&bytes| i64::from_le_bytes(bytes)).collect())
}

fn elements<const SIZE: usize>(tensor: &TensorProto) -> TractResult<&[[u8; SIZE]]> {
    let expected = shape(tensor)?.iter().try_fold(SIZE, |bytes, &extent| bytes.checked_mul(extent));
    let bytes = tensor.raw_data.len();
    ensure!(expected == Some(bytes), "{} has {bytes} bytes for a shape of {:?}", tensor.name, tensor.dims);
    Ok(tensor.raw_data.as_chunks().0)
}
