use glam::{DVec2, DVec3};
use rosto_mesh::Topology;

use crate::mirror_of;
use crate::tables::{CANONICAL, LANDMARK_COUNT, POSITIONS, TESSELLATION, UVS};

/// Subdivision level of the finest mesh.
pub const MAX_DENSITY: u32 = 4;

rosto_mesh::named! {
    /// The two published ways to join the landmarks by triangles. Both wind counter-clockwise for the viewer.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
    pub enum Triangulation {
        /// `FACEMESH_TESSELATION`, the edges of the paper: 852 triangles, with the eyes and the mouth cut out.
        #[default]
        Tessellation = "tessellation",
        /// The canonical face model's own: 898 triangles, with the eyes and the mouth filled; its own mirror image.
        Canonical = "canonical",
    }
}

impl Triangulation {
    /// The triangles, corners counter-clockwise for the viewer in front of the face.
    pub fn triangles(self) -> Vec<[u32; 3]> {
        let table: &[[u16; 3]] = match self {
            Self::Tessellation => &TESSELLATION,
            Self::Canonical => &CANONICAL,
        };
        table.iter().map(|corners| corners.map(u32::from)).collect()
    }

    /// The mesh of all [`LANDMARK_COUNT`] landmarks joined this way.
    pub fn topology(self) -> Topology {
        Topology::new(LANDMARK_COUNT, self.triangles()).expect("invariant: the published tables are meshes")
    }
}

/// The edges around the eyes and the mouth, where lids and lips end: the boundary of [`Triangulation::Tessellation`] but for
/// its rim.
pub fn opening_edges() -> Vec<[u32; 2]> {
    let sides =
        |ring: &Vec<u32>| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect::<Vec<_>>();
    // The longest is the rim.
    Triangulation::Tessellation.topology().boundary_loops().iter().skip(1).flat_map(sides).collect()
}

/// The landmarks that lie too near each other for a smooth surface to pass through them all: those inside of the corners of the
/// mouth, three within some millimetres on either side.
pub fn crowded_landmarks() -> Vec<u32> {
    [76, 62, 78].into_iter().flat_map(|right| [right, mirror_of(right)]).collect()
}

/// The canonical face: 468 positions in metres, right-handed, +X to the subject's left, +Y up, +Z out of the face.
///
/// It is an average head, and sets the size of every model whose own cannot be measured.
pub fn canonical_positions_m() -> Vec<DVec3> {
    const M_PER_UNIT: f64 = 1e-8;
    let place = |landmark: u32| {
        let partner = mirror_of(landmark);
        let [x, y, z] = POSITIONS[landmark.min(partner) as usize];
        DVec3::from([if partner < landmark { -x } else { x }, y, z].map(f64::from)) * M_PER_UNIT
    };
    (0..LANDMARK_COUNT as u32).map(place).collect()
}

/// The canonical face's texture coordinates: 468 pairs in 0..=1, origin at the top left, without seams.
pub fn canonical_uvs() -> Vec<DVec2> {
    UVS.iter().map(|uv| DVec2::from(uv.map(f64::from)) * 1e-6).collect()
}
