use glam::{DVec2, DVec3};
use rosto_mesh::Topology;

use crate::mirror_of;
use crate::tables::{CANONICAL, LANDMARK_COUNT, POSITIONS, TESSELLATION, UVS};

/// Subdivision level of the finest mesh.
pub const MAX_DENSITY: u32 = 4;

rosto_mesh::named! {
    /// Published triangulations of the landmarks, counter-clockwise for the viewer.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum Triangulation {
        /// `FACEMESH_TESSELATION`, as in the paper: 852 triangles, with open eyes and mouth.
        #[default]
        Tessellation = "tessellation",
        /// Triangulation of the canonical face model: 898 triangles, with filled eyes and mouth; mirror-symmetric.
        Canonical = "canonical",
    }
}

impl Triangulation {
    /// Triangles, counter-clockwise for a viewer in front of the face.
    pub fn triangles(self) -> Vec<[u32; 3]> {
        let table: &[[u16; 3]] = match self {
            Self::Tessellation => &TESSELLATION,
            Self::Canonical => &CANONICAL,
        };
        table.iter().map(|corners| corners.map(u32::from)).collect()
    }

    /// Topology of the mesh of all [`LANDMARK_COUNT`] landmarks.
    pub fn topology(self) -> Topology {
        Topology::new(LANDMARK_COUNT, self.triangles()).expect("invariant: the published tables are meshes")
    }
}

/// Edges around the eyes and the mouth: the boundary of [`Triangulation::Tessellation`] without the outer rim.
pub fn opening_edges() -> Vec<[u32; 2]> {
    let sides = |boundary: &Vec<u32>| {
        boundary.iter().zip(boundary.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect::<Vec<_>>()
    };
    // The longest loop is the rim.
    Triangulation::Tessellation.topology().boundary_loops().iter().skip(1).flat_map(sides).collect()
}

/// Landmarks too close together for a smooth surface to interpolate all of them: three inside each corner of the mouth,
/// within a few millimetres.
pub fn crowded_landmarks() -> Vec<u32> {
    [76, 62, 78].into_iter().flat_map(|right| [right, mirror_of(right)]).collect()
}

/// Positions of the canonical face: 468, in metres, right-handed, +X to the subject's left, +Y up, +Z out of the face.
///
/// It is an average head, and sets the size of models whose size cannot be measured.
pub fn canonical_positions_m() -> Vec<DVec3> {
    const M_PER_UNIT: f64 = 1e-8;
    let position = |landmark: u32| {
        let partner = mirror_of(landmark);
        let [x, y, z] = POSITIONS[landmark.min(partner) as usize];
        DVec3::from([if partner < landmark { -x } else { x }, y, z].map(f64::from)) * M_PER_UNIT
    };
    (0..LANDMARK_COUNT as u32).map(position).collect()
}

/// Texture coordinates of the canonical face: 468 pairs in 0..=1, origin at the top left, without seams.
pub fn canonical_uvs() -> Vec<DVec2> {
    UVS.iter().map(|uv| DVec2::from(uv.map(f64::from)) * 1e-6).collect()
}
