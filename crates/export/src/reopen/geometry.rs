//! Geometry in the binary chunk, which other programs may have moved.

use serde_json::Value;

const FLOAT: u64 = 5126;

/// Bytes of a position: three little-endian floats.
const POSITION_BYTES: usize = 3 * 4;

/// Positions of the first mesh as contiguous little-endian bytes.
pub(super) fn positions(root: &Value, binary: &[u8]) -> Option<Vec<u8>> {
    let accessor = &root["accessors"][index(&root["meshes"][0]["primitives"][0]["attributes"]["POSITION"])?];
    if accessor["componentType"] != FLOAT || accessor["type"] != "VEC3" || !accessor["sparse"].is_null() {
        return None;
    }
    let view = &root["bufferViews"][index(&accessor["bufferView"])?];
    let stride = index(view.get("byteStride").unwrap_or(&Value::from(POSITION_BYTES)))?.max(POSITION_BYTES);
    let start = offset(view)?.checked_add(offset(accessor)?)?;
    let count = index(&accessor["count"])?;
    let values = binary.get(start..)?;
    // The claimed count is not trusted: it has to fit in the file.
    if count == 0 || (count - 1).checked_mul(stride)?.checked_add(POSITION_BYTES)? > values.len() {
        return None;
    }
    Some(values.chunks(stride).take(count).flat_map(|value| &value[..POSITION_BYTES]).copied().collect())
}

/// Content of the buffer view with this index.
pub(super) fn view<'a>(root: &Value, binary: &'a [u8], view: &Value) -> Option<&'a [u8]> {
    let view = &root["bufferViews"][index(view)?];
    let start = offset(view)?;
    binary.get(start..start.checked_add(index(&view["byteLength"])?)?)
}

fn offset(value: &Value) -> Option<usize> {
    value.get("byteOffset").map_or(Some(0), index)
}

fn index(value: &Value) -> Option<usize> {
    value.as_u64()?.try_into().ok()
}
