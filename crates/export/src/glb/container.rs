use base64::prelude::{BASE64_STANDARD, Engine};
use glam::{Vec2, Vec3};
use rosto_mesh::Topology;
use serde_json::{Map, Value, json};

/// Component types and buffer targets, as OpenGL constants.
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The largest 16-bit index; 65535 is reserved for primitive restart.
const MAX_SHORT_INDEX: usize = 65534;

/// Builds the binary chunk, with its buffer views and accessors.
#[derive(Default)]
pub(super) struct Builder {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Builder {
    /// Adds positions or displacements, for which glTF requires bounds. Returns the accessor.
    pub(super) fn bounded_vectors3(&mut self, values: &[Vec3]) -> usize {
        let low = values.iter().copied().reduce(Vec3::min).unwrap_or_default();
        let high = values.iter().copied().reduce(Vec3::max).unwrap_or_default();
        let accessor = self.vectors3(values);
        self.accessors[accessor]["min"] = exact(low.to_array());
        self.accessors[accessor]["max"] = exact(high.to_array());
        accessor
    }

    pub(super) fn vectors3(&mut self, values: &[Vec3]) -> usize {
        let bytes = values.iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes);
        self.attribute(bytes, FLOAT, "VEC3", values.len())
    }

    /// Adds displacements as a sparse accessor if that is smaller. Returns the accessor.
    pub(super) fn displacements3(&mut self, values: &[Vec3]) -> usize {
        const DENSE_BYTES: usize = 12;
        let moved: Vec<usize> = (0..values.len()).filter(|&at| values[at] != Vec3::ZERO).collect();
        let is_short = values.len() <= MAX_SHORT_INDEX + 1;
        let sparse_bytes = DENSE_BYTES + if is_short { 2 } else { 4 };
        // Some readers reject sparse accessors without values.
        if moved.is_empty() || moved.len() * sparse_bytes >= values.len() * DENSE_BYTES {
            return self.bounded_vectors3(values);
        }
        let short = |&at: &usize| (at as u16).to_le_bytes();
        let (indices, component) = match is_short {
            true => (self.view(moved.iter().flat_map(short), None), UNSIGNED_SHORT),
            false => (self.view(moved.iter().flat_map(|&at| (at as u32).to_le_bytes()), None), UNSIGNED_INT),
        };
        let bytes = moved.iter().flat_map(|&at| values[at].to_array()).flat_map(f32::to_le_bytes);
        let view = self.view(bytes, None);
        let bound = |combine: fn(Vec3, Vec3) -> Vec3| {
            exact(values.iter().copied().reduce(combine).unwrap_or_default().to_array())
        };
        self.accessors.push(json!({
            "componentType": FLOAT, "type": "VEC3", "count": values.len(), "min": bound(Vec3::min), "max": bound(Vec3::max),
            "sparse": {
                "count": moved.len(),
                "indices": {"bufferView": indices, "componentType": component},
                "values": {"bufferView": view},
            },
        }));
        self.accessors.len() - 1
    }

    pub(super) fn vectors2(&mut self, values: &[Vec2]) -> usize {
        let bytes = values.iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes);
        self.attribute(bytes, FLOAT, "VEC2", values.len())
    }

    pub(super) fn scalars(&mut self, values: &[f32]) -> usize {
        self.attribute(values.iter().flat_map(|v| v.to_le_bytes()), FLOAT, "SCALAR", values.len())
    }

    /// Adds linear RGBA colours, normalised 16-bit. Four channels satisfy glTF's 4-byte alignment.
    pub(super) fn colours(&mut self, values: &[[u16; 4]]) -> usize {
        let bytes = values.iter().flatten().flat_map(|channel| channel.to_le_bytes());
        let accessor = self.attribute(bytes, UNSIGNED_SHORT, "VEC4", values.len());
        self.accessors[accessor]["normalized"] = true.into();
        accessor
    }

    pub(super) fn indices(&mut self, topology: &Topology) -> usize {
        let corners = topology.triangles().iter().flatten();
        let count = topology.triangles().len() * 3;
        let short = topology.vertex_count() <= MAX_SHORT_INDEX + 1;
        let (view, component) = if short {
            let bytes = corners.flat_map(|&corner| (corner as u16).to_le_bytes());
            (self.view(bytes, Some(ELEMENT_ARRAY_BUFFER)), UNSIGNED_SHORT)
        } else {
            let bytes = corners.flat_map(|&corner| corner.to_le_bytes());
            (self.view(bytes, Some(ELEMENT_ARRAY_BUFFER)), UNSIGNED_INT)
        };
        self.accessor(view, component, "SCALAR", count)
    }

    /// Adds an encoded image. Returns the buffer view.
    pub(super) fn image(&mut self, encoded: &[u8]) -> usize {
        self.view(encoded.iter().copied(), None)
    }

    /// Returns the binary file: header, JSON chunk, binary chunk.
    pub(super) fn finish_binary(mut self, root: Map<String, Value>) -> Vec<u8> {
        self.pad();
        let bytes = std::mem::take(&mut self.bytes);
        let mut text = self.finish(root, json!({"byteLength": bytes.len()})).into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = 12 + 8 + text.len() + 8 + bytes.len();
        let mut file = Vec::with_capacity(length);
        file.extend_from_slice(b"glTF");
        file.extend(2u32.to_le_bytes());
        file.extend((length as u32).to_le_bytes());
        push_chunk(&mut file, b"JSON", &text);
        push_chunk(&mut file, b"BIN\0", &bytes);
        file
    }

    /// Returns the file as text.
    pub(super) fn finish_text(mut self, root: Map<String, Value>) -> String {
        let bytes = std::mem::take(&mut self.bytes);
        let uri = ["data:application/octet-stream;base64,", &BASE64_STANDARD.encode(&bytes)].concat();
        self.finish(root, json!({"byteLength": bytes.len(), "uri": uri}))
    }

    fn finish(self, mut root: Map<String, Value>, buffer: Value) -> String {
        root.insert("buffers".into(), json!([buffer]));
        root.insert("bufferViews".into(), self.views.into());
        root.insert("accessors".into(), self.accessors.into());
        Value::from(root).to_string()
    }

    fn attribute(&mut self, bytes: impl Iterator<Item = u8>, component: u32, shape: &str, count: usize) -> usize {
        let view = self.view(bytes, Some(ARRAY_BUFFER));
        self.accessor(view, component, shape, count)
    }

    fn accessor(&mut self, view: usize, component: u32, shape: &str, count: usize) -> usize {
        self.accessors.push(json!({"bufferView": view, "componentType": component, "type": shape, "count": count}));
        self.accessors.len() - 1
    }

    fn view(&mut self, bytes: impl Iterator<Item = u8>, target: Option<u32>) -> usize {
        self.pad();
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let mut view = json!({"buffer": 0, "byteOffset": start, "byteLength": self.bytes.len() - start});
        if let Some(target) = target {
            view["target"] = target.into();
        }
        self.views.push(view);
        self.views.len() - 1
    }

    fn pad(&mut self) {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
    }
}

fn push_chunk(file: &mut Vec<u8>, kind: &[u8; 4], bytes: &[u8]) {
    file.extend((bytes.len() as u32).to_le_bytes());
    file.extend_from_slice(kind);
    file.extend_from_slice(bytes);
}

/// Converts exactly, so that the bounds equal the data.
fn exact(values: [f32; 3]) -> Value {
    values.map(f64::from).to_vec().into()
}
