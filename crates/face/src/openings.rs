//! The eye and mouth openings, and a mesh with separate pieces in them.

use std::ops::Range;

use glam::{DVec2, DVec3};
use rosto_mesh::{LoopSubdivision, Topology};

use crate::irises::LIDS;

rosto_mesh::named! {
    /// An opening that [`Triangulation::Canonical`](crate::Triangulation::Canonical) fills and
    /// [`Triangulation::Tessellation`](crate::Triangulation::Tessellation) leaves open.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Opening {
        /// Between the lids of the right eye.
        RightEye = "right-eye",
        /// Between the lids of the left eye.
        LeftEye = "left-eye",
        /// Between the lips.
        Mouth = "mouth",
    }
}

/// Inner edge of the lips.
const INNER_LIPS: [u16; 20] =
    [78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308, 95, 88, 178, 87, 14, 317, 402, 318, 324];

/// Distance of a piece behind the edges of lids and lips, in metres.
const EYE_BEHIND_M: f64 = 0.0005;
const MOUTH_BEHIND_M: f64 = 0.006;
/// Radius of an eyeball, in metres.
const BALL_M: f64 = 0.012;
/// Extension of an eye behind the lids, so that they can open further.
const EYE_RING: Ring = Ring { outwards_m: 0.0025, below_m: 0.0, behind_m: 0.0015 };
/// Dark extensions around the inside of the mouth, as far down as the jaw opens.
const MOUTH_RINGS: [Ring; 2] = [
    Ring { outwards_m: 0.001, below_m: 0.0, behind_m: 0.002 },
    Ring { outwards_m: 0.012, below_m: 0.016, behind_m: 0.01 },
];
/// Subdivision level of a piece that has only rim vertices.
const SUBDIVISIONS: u32 = 2;

/// Offset of a ring of vertices from the previous ring, in metres.
struct Ring {
    outwards_m: f64,
    /// Additional downward offset below the centre.
    below_m: f64,
    behind_m: f64,
}

impl Opening {
    /// Landmarks around the opening.
    pub fn rim(self) -> Vec<u32> {
        let rim: &[u16] = match self {
            Self::RightEye => &LIDS[0],
            Self::LeftEye => &LIDS[1],
            Self::Mouth => &INNER_LIPS,
        };
        rim.iter().copied().map(u32::from).collect()
    }

    /// The opening that a triangle of landmarks fills, if any.
    pub fn filled_by(corners: &[u32; 3]) -> Option<Self> {
        Self::ALL.into_iter().find(|opening| {
            let rim = opening.rim();
            corners.iter().all(|corner| rim.contains(corner))
        })
    }
}

/// Removes the triangles that fill the eyes and the mouth, which
/// [`Triangulation::Tessellation`](crate::Triangulation::Tessellation) leaves open.
///
/// `mesh` is a subdivision of `face`, with its triangles in the order of their parents.
pub fn without_fillings(face: &[[u32; 3]], mesh: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let parts = mesh.len() / face.len().max(1);
    let retained = mesh.chunks(parts.max(1)).zip(face).filter(|(_, corners)| Opening::filled_by(corners).is_none());
    retained.flat_map(|(parts, _)| parts).copied().collect()
}

/// A face mesh with separate pieces in the eye and mouth openings.
///
/// The pieces do not move with lids and lips: round eyes behind the lids, and the inside of the mouth behind the lips.
/// Mesh vertices keep their indices, followed by those of the pieces. Behind the surrounding skin, a piece continues
/// with a mirrored copy of its texture.
#[derive(Debug, Clone)]
pub struct SplitFace {
    topology: Topology,
    pieces: Vec<Piece>,
}

/// A piece in an opening.
#[derive(Debug, Clone)]
pub struct Piece {
    /// The opening.
    pub opening: Opening,
    /// Vertices of the piece.
    pub vertices: Range<u32>,
    /// Stencil of each vertex over the mesh's vertices; weights sum to 1.
    stencils: Vec<Vec<(u32, f64)>>,
    /// Number of vertices between lids or lips; the others extend behind the skin.
    inside: usize,
    /// For each column of vertices behind the skin, the rim vertex where it starts.
    from: Vec<usize>,
    /// Mesh vertices at both corners of the eye or mouth.
    corners: [u32; 2],
}

impl SplitFace {
    /// Splits a mesh that is a subdivision of `face`, the triangles of 468 landmarks, with its triangles in the order
    /// of their parents. Unfilled openings get no pieces.
    pub fn new(face: &[[u32; 3]], mesh: &Topology) -> Self {
        let parts = (mesh.triangles().len() / face.len().max(1)).max(1);
        let (mut triangles, mut filling) = (Vec::new(), vec![Vec::new(); Opening::ALL.len()]);
        for (parts, corners) in mesh.triangles().chunks(parts).zip(face) {
            match Opening::filled_by(corners) {
                Some(opening) => filling[opening as usize].extend_from_slice(parts),
                None => triangles.extend_from_slice(parts),
            }
        }
        let mut count = mesh.vertex_count() as u32;
        let mut pieces = Vec::new();
        for (opening, filling) in Opening::ALL.into_iter().zip(filling).filter(|(_, filling)| !filling.is_empty()) {
            let (piece, piece_triangles) = Piece::new(opening, &filling, count, mesh.vertex_count());
            count = piece.vertices.end;
            triangles.extend(piece_triangles);
            pieces.push(piece);
        }
        let topology = Topology::new(count as usize, triangles).expect("invariant: parts of a mesh are meshes");
        Self { topology, pieces }
    }

    /// Paints the extensions inside the mouth in the darkest colour along lids and lips, since no photo shows that
    /// part.
    #[must_use]
    pub fn darkened(mut self, colours_srgb: &[[u8; 3]]) -> Self {
        let light = |colour: &[u8; 3]| colour.iter().map(|&channel| u32::from(channel)).sum::<u32>();
        let rims = Opening::ALL.into_iter().flat_map(Opening::rim);
        let darkest = rims.min_by_key(|&vertex| light(&colours_srgb[vertex as usize])).unwrap_or_default();
        for piece in self.pieces.iter_mut().filter(|piece| piece.opening == Opening::Mouth) {
            piece.stencils[piece.inside..].fill(vec![(darkest, 1.0)]);
        }
        self
    }

    /// The skin's triangles in their original order, then those of the pieces.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Pieces of the openings that the mesh fills.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Texture coordinates of all vertices, from those of the mesh.
    ///
    /// # Panics
    /// If there are fewer coordinates than mesh vertices.
    pub fn uvs(&self, uvs: &[DVec2]) -> Vec<DVec2> {
        let of_vertex =
            |stencil: &Vec<(u32, f64)>| stencil.iter().map(|&(source, weight)| uvs[source as usize] * weight).sum();
        uvs.iter().copied().chain(self.stencils().map(of_vertex)).collect()
    }

    /// Colours of all vertices, from those of the mesh.
    ///
    /// # Panics
    /// If there are fewer colours than mesh vertices.
    pub fn colours(&self, colours: &[[u8; 3]]) -> Vec<[u8; 3]> {
        let of_vertex = |stencil: &Vec<(u32, f64)>| {
            let channel = |at: usize| {
                stencil.iter().map(move |&(source, weight)| f64::from(colours[source as usize][at]) * weight)
            };
            [0, 1, 2].map(|at| channel(at).sum::<f64>().round().clamp(0.0, 255.0) as u8)
        };
        colours.iter().copied().chain(self.stencils().map(of_vertex)).collect()
    }

    /// Positions of all vertices in metres; pieces are placed at rest behind the lids and lips of `positions_m`.
    ///
    /// # Panics
    /// If there are fewer positions than mesh vertices.
    pub fn positions_m(&self, positions_m: &[DVec3]) -> Vec<DVec3> {
        let of_pieces = self.pieces.iter().flat_map(|piece| piece.positions_m(positions_m));
        positions_m.iter().copied().chain(of_pieces).collect()
    }

    /// Displacements of all vertices; those of the pieces are zero.
    pub fn displacements(&self, displacements: &[DVec3]) -> Vec<DVec3> {
        let mut displacements = displacements.to_vec();
        displacements.resize(self.topology.vertex_count(), DVec3::ZERO);
        displacements
    }

    fn stencils(&self) -> impl Iterator<Item = &Vec<(u32, f64)>> {
        self.pieces.iter().flat_map(|piece| &piece.stencils)
    }
}

impl Piece {
    /// Creates a piece and its triangles; vertices are numbered from `first`.
    fn new(opening: Opening, filling: &[[u32; 3]], first: u32, mesh_count: usize) -> (Self, Vec<[u32; 3]>) {
        let mut mesh_vertices: Vec<u32> = filling.iter().flatten().copied().collect();
        mesh_vertices.sort_unstable();
        mesh_vertices.dedup();
        let local = |vertex: &u32| mesh_vertices.partition_point(|known| known < vertex) as u32;
        let triangles = filling.iter().map(|corners| corners.each_ref().map(local)).collect();
        let whole = Topology::new(mesh_vertices.len(), triangles).expect("invariant: a part of a mesh is a mesh");
        let is_landmark = mesh_count == crate::LANDMARK_COUNT;
        // With all edges creased, added vertices lie at the edges' midpoints.
        let dense = LoopSubdivision::creased(&whole, whole.edges(), if is_landmark { SUBDIVISIONS } else { 0 });
        let inside = dense.topology().vertex_count();
        let made_of =
            |vertex| dense.stencil(vertex).map(|(source, weight)| (mesh_vertices[source as usize], weight)).collect();
        let mut stencils: Vec<Vec<(u32, f64)>> = (0..inside as u32).map(made_of).collect();
        let mut triangles = dense.topology().triangles().to_vec();
        let rim = dense.topology().boundary_loops().into_iter().next().unwrap_or_default();
        let rings = if opening == Opening::Mouth { 2 } else { 1 };
        for ring in 0..rings {
            let inner = |at: usize| if ring == 0 { rim[at] } else { (inside + (ring - 1) * rim.len() + at) as u32 };
            let outer = |at: usize| (inside + ring * rim.len() + at) as u32;
            for at in 0..rim.len() {
                let next = (at + 1) % rim.len();
                triangles.extend([[inner(next), inner(at), outer(at)], [inner(next), outer(at), outer(next)]]);
            }
            stencils.extend(
                rim.iter().map(|&on_rim| behind(&stencils[on_rim as usize], &mesh_vertices)).collect::<Vec<_>>(),
            );
        }
        let vertices = first..first + stencils.len() as u32;
        let triangles = triangles.into_iter().map(|corners| corners.map(|corner| corner + first)).collect();
        let from = rim.iter().map(|&vertex| vertex as usize).collect();
        (Self { opening, vertices, stencils, inside, from, corners: corners(opening) }, triangles)
    }

    fn positions_m(&self, mesh_m: &[DVec3]) -> Vec<DVec3> {
        let flat =
            |stencil: &Vec<(u32, f64)>| stencil.iter().map(|&(source, weight)| mesh_m[source as usize] * weight).sum();
        let flat_m: Vec<DVec3> = self.stencils[..self.inside].iter().map(flat).collect();
        let mut positions_m: Vec<DVec3> = match self.opening {
            Opening::Mouth => flat_m.iter().map(|at| *at - DVec3::Z * MOUTH_BEHIND_M).collect(),
            _ => self.rounded(&flat_m, mesh_m),
        };
        let middle = flat_m.iter().sum::<DVec3>() / flat_m.len() as f64;
        let rings: &[Ring] = if self.opening == Opening::Mouth { &MOUTH_RINGS } else { &[EYE_RING] };
        for ring in rings {
            let placed = |&on_rim: &usize| {
                let outwards = (positions_m[on_rim] - middle).with_z(0.0).normalize_or_zero();
                let below_m = DVec3::NEG_Y * (ring.below_m * (-outwards.y).max(0.0));
                positions_m[on_rim] + outwards * ring.outwards_m + below_m - DVec3::Z * ring.behind_m
            };
            let placed: Vec<DVec3> = self.from.iter().map(placed).collect();
            positions_m.extend(placed);
        }
        positions_m
    }

    /// Bulges an eye between its lids: a parabola with the eyeball's curvature that ends at the lid edges.
    fn rounded(&self, flat_m: &[DVec3], mesh_m: &[DVec3]) -> Vec<DVec3> {
        let [outer, inner] = self.corners.map(|corner| mesh_m[corner as usize]);
        let across = inner - outer;
        let placed = |at: DVec3| {
            let along = ((at - outer).dot(across) / across.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            (along, (at - outer - across * along).y)
        };
        let high = flat_m.iter().map(|at| placed(*at).1).fold(0.0, f64::max);
        let low = flat_m.iter().map(|at| placed(*at).1).fold(0.0, f64::min);
        let bulged = |at: &DVec3| {
            let (along, up) = placed(*at);
            let open = 4.0 * along * (1.0 - along);
            let rise = ((high * open - up) * (up - low * open)).max(0.0) / (2.0 * BALL_M);
            *at + DVec3::Z * (rise - EYE_BEHIND_M)
        };
        flat_m.iter().map(bulged).collect()
    }
}

/// Stencil of a vertex behind the skin: it samples the texture inside the rim, as a mirror image of the surroundings.
fn behind(on_rim: &[(u32, f64)], mesh_vertices: &[u32]) -> Vec<(u32, f64)> {
    const INSIDE: f64 = 0.3;
    let middle = INSIDE / mesh_vertices.len() as f64;
    let own = on_rim.iter().map(|&(source, weight)| (source, weight * (1.0 - INSIDE)));
    own.chain(mesh_vertices.iter().map(|&source| (source, middle))).collect()
}

/// Landmarks at the corners of an eye, outer first, or of the mouth.
pub(crate) fn corners(opening: Opening) -> [u32; 2] {
    match opening {
        Opening::RightEye => [33, 133],
        Opening::LeftEye => [263, 362],
        Opening::Mouth => [78, 308],
    }
}
