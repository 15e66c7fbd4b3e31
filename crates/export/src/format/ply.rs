use rosto_mesh::vertex_normals;

use crate::{ExportError, Model};

/// Exports a binary little-endian PLY file: positions in metres, normals, and sRGB vertex colours, a common extension.
///
/// # Errors
/// [`ExportError`] if a length does not match, a position is not finite, or the mesh is empty.
pub fn ply(model: &Model<'_>) -> Result<Vec<u8>, ExportError> {
    model.check()?;
    let (vertices, faces) = (model.positions_m.len().to_string(), model.topology.triangles().len().to_string());
    let header = [
        "ply\nformat binary_little_endian 1.0\ncomment Rosto; metres, +Y up, +Z out of the face\nelement vertex ",
        &vertices,
        "\nproperty float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nelement face ",
        &faces,
        "\nproperty list uchar int vertex_indices\nend_header\n",
    ];
    let mut file = header.concat().into_bytes();
    let normals = vertex_normals(model.topology, model.positions_m);
    for ((position, normal), colour) in model.positions_m.iter().zip(normals).zip(model.colours_srgb) {
        let numbers = [position.as_vec3().to_array(), normal.as_vec3().to_array()].concat();
        file.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
        file.extend(colour);
    }
    for corners in model.topology.triangles() {
        file.push(3);
        file.extend(corners.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    Ok(file)
}
