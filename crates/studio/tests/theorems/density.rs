//! Denser meshes: cage edits are interpolated, direct edits stay local, and changing density and back is lossless.

use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Region, Triangulation, crowded_landmarks, opening_edges, without_fillings};
use rosto_mesh::{LoopSubdivision, Topology};
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

#[test]
fn the_canonical_face_has_the_expected_densities() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    for (density, vertices) in [(0, 468), (1, 1_833), (2, 7_257), (3, 28_881)] {
        document.set_density(density).unwrap();
        assert_eq!((document.topology().vertex_count(), document.positions().len()), (vertices, vertices));
    }
}

#[test]
fn a_cage_edit_equals_subdividing_the_edited_cage() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    document.apply("nose", single_move(4, DVec3::new(0.001, 0.002, 0.02))).unwrap();
    document.apply("half", Command::Symmetrise { share: 0.5 }).unwrap();
    let cage = document.positions().to_vec();
    document.set_density(2).unwrap();
    let crowded = crowded_landmarks();
    let once = LoopSubdivision::creased(&Triangulation::Canonical.topology(), &opening_edges(), 1).rounding(&crowded);
    let twice = LoopSubdivision::creased(once.topology(), once.creases(), 1).rounding(&crowded);
    let dense = twice.interpolate(&once.interpolate(&cage));
    assert!(dense.iter().zip(document.positions()).all(|(a, b)| a.distance(*b) < 1e-12));
}

#[test]
fn filled_openings_do_not_change_the_surrounding_skin() {
    let cage = Triangulation::Canonical.triangles();
    let open_cage = Topology::new(LANDMARK_COUNT, without_fillings(&cage, &cage)).unwrap();
    let positions = Document::new(portrait(Triangulation::Canonical)).unwrap().positions().to_vec();
    for density in 1..=3 {
        let [filled, open] = [Triangulation::Canonical.topology(), open_cage.clone()].map(|topology| {
            let rest = Rest::of_landmarks(topology, positions.clone(), CoordinateFrame::Model);
            let mut document = Document::new(rest).unwrap();
            document.set_density(density).unwrap();
            document
        });
        let skin = without_fillings(&cage, filled.topology().triangles());
        let is_same = corner_bits(&filled, &skin) == corner_bits(&open, open.topology().triangles());
        assert!(is_same, "{density} subdivisions");
    }
}

#[test]
fn only_meshes_of_landmarks_are_faces() {
    let (topology, positions) = grid(26, 18);
    let subdivision = LoopSubdivision::new(&topology, 1);
    let is_on_border = |v: u32| [0, 25].contains(&(v % 26)) || !(26..17 * 26).contains(&v);
    let part = |document: &Document| document.part_of(EditTarget::Point { level: 1, vertex: 200 });
    let of_grid = || Rest::of_mesh(topology.clone(), positions.clone());
    let mut document = Document::new(of_grid()).unwrap();
    for _ in 0..2 {
        assert!((0..LANDMARK_COUNT as u32).all(|vertex| document.is_on_oval(0, vertex) == is_on_border(vertex)));
        assert_eq!(document.apply("half", Command::Symmetrise { share: 0.5 }), Err(StudioError::NoMirror));
        document.set_density(1).unwrap();
        assert_eq!(part(&document), None);
        assert_eq!(document.rest(), subdivision.interpolate(&positions));
        document = document.over(of_grid()).unwrap();
    }
    let mut face = Document::new(canonical(Triangulation::Canonical)).unwrap();
    let mut again = face.over(canonical(Triangulation::Tessellation)).unwrap();
    for document in [&mut face, &mut again] {
        document.set_density(1).unwrap();
        assert!(document.is_on_oval(0, 152) && part(document).is_some());
    }
}

/// A plane of squares, each split into two triangles.
fn grid(columns: u32, rows: u32) -> (Topology, Vec<DVec3>) {
    let cells = (0..rows - 1).flat_map(|y| (0..columns - 1).map(move |x| y * columns + x));
    let triangles = cells.flat_map(|at| [[at, at + 1, at + columns + 1], [at, at + columns + 1, at + columns]]);
    let at = |vertex: u32| DVec3::new(f64::from(vertex % columns), f64::from(vertex / columns), 0.0);
    let count = columns * rows;
    (Topology::new(count as usize, triangles.collect()).unwrap(), (0..count).map(at).collect())
}

/// Bits of the triangles' corner positions.
fn corner_bits(document: &Document, triangles: &[[u32; 3]]) -> Vec<[[u64; 3]; 3]> {
    let position = |corner: u32| document.positions()[corner as usize].to_array().map(f64::to_bits);
    triangles.iter().map(|triangle| triangle.map(position)).collect()
}

#[test]
fn denser_meshes_interpolate_the_points_of_coarser_ones() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    document.apply("nose", single_move(4, DVec3::new(0.001, 0.002, 0.02))).unwrap();
    let mut coarser = document.positions().to_vec();
    for density in 1..=3 {
        document.set_density(density).unwrap();
        let apart = |vertex: usize| coarser[vertex].distance(document.positions()[vertex]);
        let (crowded, others): (Vec<usize>, _) =
            (0..coarser.len()).partition(|vertex| crowded_landmarks().contains(&(*vertex as u32)));
        assert!(others.into_iter().all(|vertex| apart(vertex) < 1e-15), "{density}");
        assert!(crowded.into_iter().all(|vertex| apart(vertex) < 2e-3), "the corners of the mouth are rounded off");
        coarser = document.positions().to_vec();
    }
}

#[test]
fn changing_density_and_back_is_the_identity() {
    let mut document = Document::new(portrait(Triangulation::Tessellation)).unwrap();
    document.apply("nose", single_move(4, DVec3::Z * 0.02)).unwrap();
    let cage = bits(document.positions());
    document.set_density(1).unwrap();
    let dense = bits(document.positions());
    document.apply("chin", single_move(152, DVec3::Y * 0.01)).unwrap();
    document.undo().unwrap();
    assert_eq!(bits(document.positions()), dense);
    document.set_density(0).unwrap();
    assert_eq!(bits(document.positions()), cage);
}

#[test]
fn dense_edits_leave_the_cage_unchanged_and_wait_while_it_is_displayed() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    let cage = bits(document.positions());
    document.set_density(1).unwrap();
    let settings = Settings { constraint: ConstraintKind::Hard, ..Settings::default() };
    let spec = EditSpec { level: 1, handles: vec![1_000], settings };
    document.apply("detail", Command::Move { spec: spec.clone(), offsets: vec![DVec3::Z * 0.003] }).unwrap();
    let moved = document.positions()[1_000] - document.rest()[1_000];
    assert!((moved - DVec3::Z * 0.003).length() < 1e-12);
    let dense = bits(document.positions());
    document.set_density(0).unwrap();
    assert_eq!(bits(document.positions()), cage);
    assert_eq!(document.prepare(spec), Err(StudioError::TooCoarse { level: 1, density: 0 }));
    document.set_density(1).unwrap();
    assert_eq!(bits(document.positions()), dense);
}

#[test]
fn a_mirrored_edit_of_the_dense_mesh_is_symmetric() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.set_density(1).unwrap();
    let settings = Settings { mirror: Mirror::On, constraint: ConstraintKind::Hard, ..Settings::default() };
    document.prepare(EditSpec { level: 1, handles: vec![1_000], settings }).unwrap();
    let offset = DVec3::new(0.002, 0.001, 0.003);
    document.preview(&[offset]).unwrap();
    let [handle, partner] = document.handles() else { panic!("two handles") };
    let (here, there) = (document.rest()[*handle as usize], document.rest()[*partner as usize]);
    assert!((here - there * MIRROR).length() < 1e-12);
    let moved = document.positions()[*partner as usize] - there;
    assert!((moved - offset * MIRROR).length() < 1e-12);
}

#[test]
fn cage_values_are_interpolated_like_positions() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.set_density(2).unwrap();
    let carried = document.from_cage(&rosto_face::canonical_positions_m());
    assert!(carried.iter().zip(document.rest()).all(|(a, b)| a.distance(*b) < 1e-14));
}

#[test]
fn on_a_dense_mesh_a_commit_matches_its_preview() {
    for (triangulation, mirror, handles) in [
        (Triangulation::Canonical, Mirror::Off, vec![61]),
        (Triangulation::Canonical, Mirror::On, vec![61]),
        (Triangulation::Tessellation, Mirror::On, vec![1]),
        (Triangulation::Canonical, Mirror::On, Region::Nose.vertices()),
    ] {
        let mut document = Document::new(canonical(triangulation)).unwrap();
        document.set_density(2).unwrap();
        let settings =
            Settings { mirror, constraint: ConstraintKind::Hard, operator: Operator::Cotangent, ..Settings::default() };
        let offsets = vec![DVec3::new(0.004, -0.003, 0.007); handles.len()];
        document.prepare(EditSpec { handles, settings, ..EditSpec::default() }).unwrap();
        document.preview(&offsets).unwrap();
        let shown = document.positions().to_vec();
        document.commit("a tick");
        assert!(shown.iter().zip(document.positions()).all(|(a, b)| a.distance(*b) < 1e-12), "{triangulation:?}");
    }
}

#[test]
fn influence_predicts_the_displacement_of_handles_with_one_offset() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    for (density, mirror, handles) in [
        (0, Mirror::Off, vec![61]),
        (0, Mirror::On, vec![61]),
        (1, Mirror::On, vec![61]),
        (0, Mirror::On, Region::Lips.vertices()),
        (1, Mirror::On, Region::LeftBrow.vertices()),
    ] {
        document.set_density(density).unwrap();
        let settings = Settings { mirror, ..Settings::default() };
        let offset = DVec3::new(0.004, -0.003, 0.007);
        let offsets = vec![offset; handles.len()];
        document.prepare(EditSpec { handles, settings, ..EditSpec::default() }).unwrap();
        let influence = document.influence().unwrap().clone();
        document.preview(&offsets).unwrap();
        for (vertex, (now, before)) in document.positions().iter().zip(document.committed()).enumerate() {
            let mirrored = influence.mirrored.get(vertex).copied().unwrap_or(0.0);
            let predicted = *before + offset * influence.direct[vertex] + offset * MIRROR * mirrored;
            assert!(now.distance(predicted) < 1e-12, "vertex {vertex} at density {density}, {mirror:?}");
        }
    }
    document.prepare(EditSpec { handles: vec![61], ..EditSpec::default() }).unwrap();
    let rigid_guess = document.influence().cloned();
    let turned = Settings { details: Details::AsRigidAsPossible, ..Settings::default() };
    document.prepare(EditSpec { handles: vec![61], settings: turned, ..EditSpec::default() }).unwrap();
    assert_eq!(document.influence(), rigid_guess.as_ref());
}

fn detail(level: u32, handle: u32, mirror: Mirror) -> Command {
    let settings = Settings { mirror, constraint: ConstraintKind::Hard, ..Settings::default() };
    let offsets = vec![DVec3::new(0.001, 0.0, 0.003)];
    Command::Move { spec: EditSpec { level, handles: vec![handle], settings }, offsets }
}

/// Rest position of the vertex that the last entry moved farthest, and the distance.
fn peak(document: &mut Document) -> (DVec3, f64) {
    let last = document.displacements().pop().unwrap();
    let displacements = document.rest().iter().copied().zip(last.iter().map(|displacement| displacement.length()));
    displacements.max_by(|one, other| one.1.total_cmp(&other.1)).unwrap()
}

#[test]
fn dense_edits_keep_their_position_in_another_triangulation() {
    for mirror in [Mirror::Off, Mirror::On] {
        let mut canonical_document = Document::new(portrait(Triangulation::Canonical)).unwrap();
        canonical_document.apply("cage", single_move(152, DVec3::Y * 0.001)).unwrap();
        canonical_document.set_density(2).unwrap();
        canonical_document.apply("undone", detail(2, 4_001, mirror)).unwrap();
        canonical_document.undo().unwrap();
        canonical_document.apply("detail", detail(2, 5_000, mirror)).unwrap();
        let mut other = canonical_document.over(portrait(Triangulation::Tessellation)).unwrap();
        other.set_density(2).unwrap();
        let ((before, far), (after, as_far)) = (peak(&mut canonical_document), peak(&mut other));
        // Both mirror images are peaks; compare on the right side.
        let right = |peak: DVec3| if mirror == Mirror::On { DVec3::new(-peak.x.abs(), peak.y, peak.z) } else { peak };
        assert!(right(before).distance(right(after)) < 0.002 && (far - as_far).abs() < 1e-4, "{before} and {after}");
        assert_eq!(other.history().entries()[0], canonical_document.history().entries()[0]);
        other.undo().unwrap();
        other.undo().unwrap();
        assert_eq!(other.positions(), other.rest());
    }
}

#[test]
fn points_of_the_symmetric_mesh_have_partners_and_those_of_the_tessellation_do_not() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.set_density(3).unwrap();
    for (vertex, position) in document.rest().iter().enumerate() {
        let partner = document.partner(3, vertex as u32).unwrap();
        assert!(document.rest()[partner as usize].distance(*position * MIRROR) < 1e-12);
    }
    assert_eq!(document.partner(3, 28_881), None);
    let mut open = Document::new(canonical(Triangulation::Tessellation)).unwrap();
    open.set_density(1).unwrap();
    assert_eq!((open.partner(0, 61), open.partner(1, 61)), (Some(291), None));
}
