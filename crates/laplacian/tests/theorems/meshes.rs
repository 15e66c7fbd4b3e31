//! Test meshes.

use glam::DVec3;
use rosto_mesh::{LoopSubdivision, Topology};

use crate::golden::{face, golden, points};
use crate::seeded::Seeded;

pub struct Mesh {
    pub name: &'static str,
    pub topology: Topology,
    pub positions: Vec<DVec3>,
}

impl Mesh {
    fn new(name: &'static str, triangles: Vec<[u32; 3]>, positions: Vec<DVec3>) -> Self {
        Self { name, topology: Topology::new(positions.len(), triangles).unwrap(), positions }
    }

    pub fn vertex_count(&self) -> usize {
        self.topology.vertex_count()
    }
}

/// The canonical face: symmetric, with holes for eyes and mouth; in centimetres.
pub fn canonical_face() -> Mesh {
    let tables = golden(include_str!("../../../../tests/golden/topology.json"));
    Mesh { name: "face", topology: face("canonical"), positions: points(&tables["vertices"]) }
}

/// A plane of unevenly spaced points with random diagonals; not a Delaunay triangulation.
pub fn plane(columns: u32, rows: u32, random: &mut Seeded) -> Mesh {
    let at = |column: u32, row: u32| row * (columns + 1) + column;
    let mut triangles = Vec::new();
    for (column, row) in (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))) {
        let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
        triangles.extend(if random.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
    }
    let count = (columns + 1) * (rows + 1);
    let position = |v: u32| {
        let (column, row) = (v % (columns + 1), v / (columns + 1));
        let jitter = 0.3 * random.vector();
        DVec3::new(f64::from(column) + jitter.x, f64::from(row) + jitter.y, 0.0)
    };
    Mesh::new("plane", triangles, (0..count).map(position).collect())
}

/// A torus of `around` by `across` quads, each split into two triangles.
pub fn torus(around: u32, across: u32) -> Mesh {
    let at = |i: u32, j: u32| (i % around) * across + j % across;
    let cut = |(i, j): (u32, u32)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let squares = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let position = |v: u32| {
        let turn = |k: u32, of: u32| std::f64::consts::TAU * f64::from(k) / f64::from(of);
        let (long, short) = (turn(v / across, around), turn(v % across, across));
        let radius = 2.0 + 0.7 * short.cos();
        DVec3::new(radius * long.cos(), radius * long.sin(), 0.7 * short.sin())
    };
    Mesh::new("torus", squares.flat_map(cut).collect(), (0..around * across).map(position).collect())
}

/// Two distant planes, and a vertex without triangles.
pub fn apart(random: &mut Seeded) -> Mesh {
    let (near, far) = (plane(3, 3, random), plane(2, 4, random));
    let shift = near.vertex_count() as u32;
    let shifted = far.topology.triangles().iter().map(|corners| corners.map(|corner| corner + shift));
    let triangles = near.topology.triangles().iter().copied().chain(shifted).collect();
    let moved = far.positions.iter().map(|&position| position + 50.0 * DVec3::Z);
    let positions = near.positions.iter().copied().chain(moved).chain([DVec3::ONE]).collect();
    Mesh::new("apart", triangles, positions)
}

/// Small closed, open and disconnected meshes.
pub fn small() -> Vec<Mesh> {
    let random = &mut Seeded::new(7);
    let tetrahedron = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let sides = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    let solid = Mesh::new("tetrahedron", sides, tetrahedron.map(DVec3::from).to_vec());
    let dense = LoopSubdivision::new(&solid.topology, 2);
    let egg = dense.apply(&solid.positions).iter().map(|&p| p * DVec3::new(1.0, 1.3, 0.8)).collect();
    let egg = Mesh { name: "egg", topology: dense.topology().clone(), positions: egg };
    vec![solid, egg, plane(5, 4, random), torus(9, 6), apart(random)]
}

/// Returns the first vertex of the first component as handle, and its last two vertices, which are far away, as
/// anchors.
pub fn handle_and_anchors(mesh: &Mesh) -> (u32, [u32; 2]) {
    let component = mesh.topology.components();
    let own: Vec<u32> = (0..mesh.vertex_count() as u32).filter(|&vertex| component[vertex as usize] == 0).collect();
    (own[0], [own[own.len() - 1], own[own.len() - 2]])
}
