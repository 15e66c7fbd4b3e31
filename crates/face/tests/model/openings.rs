//! Separate pieces for eyes and mouth.

use std::collections::BTreeSet;

use glam::DVec3;
use rosto_face::{Opening, SplitFace, Triangulation, canonical_positions_m, canonical_uvs, without_fillings};
use rosto_mesh::LoopSubdivision;

#[test]
fn openings_match_the_holes_of_the_tessellation() {
    let loops = Triangulation::Tessellation.topology().boundary_loops();
    let holes: BTreeSet<BTreeSet<u32>> = loops[1..].iter().map(|hole| hole.iter().copied().collect()).collect();
    let rims: BTreeSet<BTreeSet<u32>> =
        Opening::ALL.iter().map(|opening| opening.rim().into_iter().collect()).collect();
    assert_eq!(rims, holes);
    assert!(Triangulation::Tessellation.triangles().iter().all(|corners| Opening::filled_by(corners).is_none()));
}

#[test]
fn pieces_share_no_vertices_with_the_skin() {
    let face = Triangulation::Canonical.triangles();
    for density in [0, 1, 2] {
        let dense = LoopSubdivision::new(&Triangulation::Canonical.topology(), density);
        let split_face = SplitFace::new(&face, dense.topology());
        let skin = without_fillings(&face, dense.topology().triangles());
        assert_eq!(split_face.topology().triangles()[..skin.len()], skin);
        let first = dense.topology().vertex_count() as u32;
        let of_pieces = &split_face.topology().triangles()[skin.len()..];
        assert!(of_pieces.iter().flatten().all(|&corner| corner >= first));
        assert_eq!(split_face.pieces().iter().map(|piece| piece.opening).collect::<Vec<_>>(), Opening::ALL);
        assert_eq!(split_face.uvs(&dense.apply(&canonical_uvs())).len(), split_face.topology().vertex_count());
    }
    let open = Triangulation::Tessellation;
    assert!(SplitFace::new(&open.triangles(), &open.topology()).pieces().is_empty());
}

#[test]
fn eyes_bulge_behind_the_lids() {
    let positions_m = canonical_positions_m();
    let split_face = SplitFace::new(&Triangulation::Canonical.triangles(), &Triangulation::Canonical.topology());
    let placed_m = split_face.positions_m(&positions_m);
    assert_eq!(placed_m[..positions_m.len()], positions_m);
    let [right, left, _mouth] = split_face.pieces() else { panic!("two eyes and a mouth") };
    for (piece, lids) in [(right, [159, 145]), (left, [386, 374])] {
        let [upper, lower] = lids.map(|lid: usize| positions_m[lid]);
        let of_piece = &placed_m[piece.vertices.start as usize..piece.vertices.end as usize];
        let middle = |at: &&DVec3| at.distance((upper + lower) / 2.0);
        let nearest = of_piece.iter().min_by(|a, b| middle(a).total_cmp(&middle(b))).unwrap();
        let chord_z = (upper.z + lower.z) / 2.0;
        assert!(nearest.z > chord_z - 0.0005 && nearest.z < chord_z + 0.002, "{nearest} bulges over {chord_z}");
        let rim = piece.opening.rim();
        let touches = |at: &DVec3| {
            rim.iter().any(|&lid| {
                at.z >= positions_m[lid as usize].z && at.truncate() == positions_m[lid as usize].truncate()
            })
        };
        assert!(!of_piece.iter().any(touches), "a rim is in front of its lid");
    }
}
