use glam::DVec3;

use crate::model::MM_PER_M;
use crate::{ExportError, Model};

/// Exports a binary STL file in millimetres, +Y up, without colours.
///
/// The model is written as it is. For printing, pass a closed body ([`Print::body`](crate::Print::body)).
///
/// # Errors
/// [`ExportError`] if a length does not match, a position is not finite, or the mesh is empty.
pub fn stl(model: &Model<'_>) -> Result<Vec<u8>, ExportError> {
    model.check()?;
    Ok(stl_of(model.topology.triangles(), model.positions_m))
}

pub(super) fn stl_of(triangles: &[[u32; 3]], positions_m: &[DVec3]) -> Vec<u8> {
    let mut file = vec![b' '; 80];
    let title = b"Rosto; millimetres";
    file[..title.len()].copy_from_slice(title);
    file.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        // As they are written, so that the normal depends on nothing else.
        let [a, b, c] = corners.map(|corner| (positions_m[corner as usize] * MM_PER_M).as_vec3().as_dvec3());
        let normal = (b - a).cross(c - a).normalize_or_zero();
        for vector in [normal, a, b, c] {
            push(&mut file, vector);
        }
        file.extend([0, 0]);
    }
    file
}

fn push(file: &mut Vec<u8>, vector: DVec3) {
    file.extend(vector.as_vec3().to_array().into_iter().flat_map(f32::to_le_bytes));
}
