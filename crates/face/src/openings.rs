//! The eyes and the mouth: what fills them, and a mesh in which that is in pieces of its own.

use std::ops::Range;

use glam::{DVec2, DVec3};
use rosto_mesh::{LoopSubdivision, Topology};

use crate::irises::LIDS;

rosto_mesh::named! {
    /// An opening of the face, which [`Triangulation::Canonical`](crate::Triangulation::Canonical) fills and
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

/// The edge of the lips inside.
const INNER_LIPS: [u16; 20] =
    [78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308, 95, 88, 178, 87, 14, 317, 402, 318, 324];

/// How far behind the edges of lids and lips a piece lies, in metres.
const EYE_BEHIND_M: f64 = 0.0005;
const MOUTH_BEHIND_M: f64 = 0.006;
/// An eyeball's radius, in metres.
const BALL_M: f64 = 0.012;
/// An eye goes on so far behind the lids, so that they may part further.
const EYE_RING: Ring = Ring { outwards_m: 0.0025, below_m: 0.0, behind_m: 0.0015 };
/// Around what is seen of the mouth it is dark, as far down as a jaw opens.
const MOUTH_RINGS: [Ring; 2] = [
    Ring { outwards_m: 0.001, below_m: 0.0, behind_m: 0.002 },
    Ring { outwards_m: 0.012, below_m: 0.016, behind_m: 0.01 },
];
/// A piece that has no vertices but its rim's is cut so often.
const TIMES_CUT: u32 = 2;

/// How far a ring of vertices lies from the rim that it goes on from, in metres.
struct Ring {
    outwards_m: f64,
    /// Where it is below the middle, as much further down.
    below_m: f64,
    behind_m: f64,
}

impl Opening {
    /// The landmarks around it.
    pub fn rim(self) -> Vec<u32> {
        let rim: &[u16] = match self {
            Self::RightEye => &LIDS[0],
            Self::LeftEye => &LIDS[1],
            Self::Mouth => &INNER_LIPS,
        };
        rim.iter().copied().map(u32::from).collect()
    }

    /// The opening that a triangle of landmarks fills.
    pub fn filled_by(corners: &[u32; 3]) -> Option<Self> {
        Self::ALL.into_iter().find(|opening| {
            let rim = opening.rim();
            corners.iter().all(|corner| rim.contains(corner))
        })
    }
}

/// The triangles of a face's mesh without those that fill its eyes and mouth, which
/// [`Triangulation::Tessellation`](crate::Triangulation::Tessellation) leaves open.
///
/// `mesh` is a subdivision of `face`, its triangles in the order of those that they are parts of.
pub fn without_fillings(face: &[[u32; 3]], mesh: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let parts = mesh.len() / face.len().max(1);
    let kept = mesh.chunks(parts.max(1)).zip(face).filter(|(_, corners)| Opening::filled_by(corners).is_none());
    kept.flat_map(|(parts, _)| parts).copied().collect()
}

/// A face's mesh with the skin cut open at eyes and mouth, and what fills them in pieces of their own that stay where they are
/// when lids and lips move: eyes round as balls behind the lids, what is seen of the mouth behind the lips.
///
/// The mesh's vertices keep their numbers; those of the pieces follow. A piece goes on behind the skin around it, where it
/// shows its own picture in the mirror.
#[derive(Debug, Clone)]
pub struct Parted {
    topology: Topology,
    pieces: Vec<Piece>,
}

/// One piece.
#[derive(Debug, Clone)]
pub struct Piece {
    /// What it fills.
    pub opening: Opening,
    /// Its vertices.
    pub vertices: Range<u32>,
    /// For each of them, which of the mesh's vertices it is made of, with weights that sum to 1.
    stencils: Vec<Vec<(u32, f64)>>,
    /// How many of them lie between lids or lips; those after them go on behind the skin.
    inside: usize,
    /// For each that goes on behind the skin, the one on the rim that it goes on from.
    from: Vec<usize>,
    /// The mesh's vertices at both corners of an eye, or of the mouth.
    corners: [u32; 2],
}

impl Parted {
    /// Parts a mesh that is a subdivision of `face`, the triangles of 468 landmarks, in the order of those that its triangles are
    /// parts of. What has no fillings has no pieces.
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
            let (piece, of_piece) = Piece::new(opening, &filling, count, mesh.vertex_count());
            count = piece.vertices.end;
            triangles.extend(of_piece);
            pieces.push(piece);
        }
        let topology = Topology::new(count as usize, triangles).expect("invariant: parts of a mesh are meshes");
        Self { topology, pieces }
    }

    /// The same with the dark around what is seen of the mouth as dark as the darkest of the mesh's colours along lids and lips:
    /// where it shows, there is nothing that a photo could have seen.
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

    /// The skin's triangles in their order, and then those of the pieces.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The eyes and the mouth, as far as the mesh fills them.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Texture coordinates of all vertices.
    ///
    /// # Panics
    /// If there is not one for each vertex of the mesh.
    pub fn uvs(&self, uvs: &[DVec2]) -> Vec<DVec2> {
        let of_piece = |stencil: &Vec<(u32, f64)>| stencil.iter().map(|&(of, share)| uvs[of as usize] * share).sum();
        uvs.iter().copied().chain(self.stencils().map(of_piece)).collect()
    }

    /// Colours of all vertices.
    ///
    /// # Panics
    /// If there is not one for each vertex of the mesh.
    pub fn colours(&self, colours: &[[u8; 3]]) -> Vec<[u8; 3]> {
        let of_piece = |stencil: &Vec<(u32, f64)>| {
            let channel =
                |at: usize| stencil.iter().map(move |&(of, share)| f64::from(colours[of as usize][at]) * share);
            [0, 1, 2].map(|at| channel(at).sum::<f64>().round().clamp(0.0, 255.0) as u8)
        };
        colours.iter().copied().chain(self.stencils().map(of_piece)).collect()
    }

    /// Positions of all vertices in metres; those of the pieces lie where they are at rest behind lids and lips at these.
    ///
    /// # Panics
    /// If there is not one for each vertex of the mesh.
    pub fn positions_m(&self, positions_m: &[DVec3]) -> Vec<DVec3> {
        let of_pieces = self.pieces.iter().flat_map(|piece| piece.positions_m(positions_m));
        positions_m.iter().copied().chain(of_pieces).collect()
    }

    /// Ways of all vertices: the pieces stay.
    pub fn ways(&self, ways: &[DVec3]) -> Vec<DVec3> {
        let mut ways = ways.to_vec();
        ways.resize(self.topology.vertex_count(), DVec3::ZERO);
        ways
    }

    fn stencils(&self) -> impl Iterator<Item = &Vec<(u32, f64)>> {
        self.pieces.iter().flat_map(|piece| &piece.stencils)
    }
}

impl Piece {
    /// The piece and its triangles; its vertices are numbered from `first`.
    fn new(opening: Opening, filling: &[[u32; 3]], first: u32, mesh_count: usize) -> (Self, Vec<[u32; 3]>) {
        let mut of_mesh: Vec<u32> = filling.iter().flatten().copied().collect();
        of_mesh.sort_unstable();
        of_mesh.dedup();
        let local = |vertex: &u32| of_mesh.partition_point(|known| known < vertex) as u32;
        let triangles = filling.iter().map(|corners| corners.each_ref().map(local)).collect();
        let whole = Topology::new(of_mesh.len(), triangles).expect("invariant: a part of a mesh is one");
        let is_landmark = mesh_count == crate::LANDMARK_COUNT;
        // Every edge a crease: what is added lies half way along it.
        let dense = LoopSubdivision::creased(&whole, whole.edges(), if is_landmark { TIMES_CUT } else { 0 });
        let inside = dense.topology().vertex_count();
        let made_of = |vertex| dense.stencil(vertex).map(|(of, share)| (of_mesh[of as usize], share)).collect();
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
            stencils.extend(rim.iter().map(|&on_rim| behind(&stencils[on_rim as usize], &of_mesh)).collect::<Vec<_>>());
        }
        let vertices = first..first + stencils.len() as u32;
        let triangles = triangles.into_iter().map(|corners| corners.map(|corner| corner + first)).collect();
        let from = rim.iter().map(|&vertex| vertex as usize).collect();
        (Self { opening, vertices, stencils, inside, from, corners: corners(opening) }, triangles)
    }

    fn positions_m(&self, mesh_m: &[DVec3]) -> Vec<DVec3> {
        let flat = |stencil: &Vec<(u32, f64)>| stencil.iter().map(|&(of, share)| mesh_m[of as usize] * share).sum();
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

    /// As round as a ball, from lid to lid: a parabola with the ball's curvature, which ends at the lids' edges.
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

/// What goes on behind the skin shows what lies as much inside as it lies outside: the mirror's picture.
fn behind(on_rim: &[(u32, f64)], of_mesh: &[u32]) -> Vec<(u32, f64)> {
    const INSIDE: f64 = 0.3;
    let middle = INSIDE / of_mesh.len() as f64;
    let own = on_rim.iter().map(|&(of, share)| (of, share * (1.0 - INSIDE)));
    own.chain(of_mesh.iter().map(|&of| (of, middle))).collect()
}

fn corners(opening: Opening) -> [u32; 2] {
    match opening {
        Opening::RightEye => [33, 133],
        Opening::LeftEye => [263, 362],
        Opening::Mouth => [78, 308],
    }
}
