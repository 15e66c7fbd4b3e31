//! Properties of the published tables.

use rosto_face::*;

fn degree_histogram(triangulation: Triangulation) -> Vec<(usize, usize)> {
    let topology = triangulation.topology();
    let mut counts = std::collections::BTreeMap::new();
    for vertex in 0..LANDMARK_COUNT as u32 {
        *counts.entry(topology.degree(vertex)).or_insert(0) += 1;
    }
    counts.into_iter().collect()
}

fn loop_lengths(triangulation: Triangulation) -> Vec<usize> {
    triangulation.topology().boundary_loops().iter().map(Vec::len).collect()
}

#[test]
fn the_tessellation_matches_the_paper() {
    let topology = Triangulation::Tessellation.topology();
    assert_eq!((topology.vertex_count(), topology.edges().len(), topology.triangles().len()), (468, 1322, 852));
    assert_eq!(loop_lengths(Triangulation::Tessellation), [36, 20, 16, 16]);
    assert_eq!(degree_histogram(Triangulation::Tessellation), [(3, 22), (4, 61), (5, 96), (6, 185), (7, 88), (8, 16)]);
}

#[test]
fn the_canonical_triangulation_fills_eyes_and_mouth() {
    let topology = Triangulation::Canonical.topology();
    assert_eq!((topology.vertex_count(), topology.edges().len(), topology.triangles().len()), (468, 1365, 898));
    assert_eq!(loop_lengths(Triangulation::Canonical), [36]);
    assert_eq!(degree_histogram(Triangulation::Canonical), [(3, 6), (4, 46), (5, 80), (6, 239), (7, 82), (8, 15)]);
}

#[test]
fn without_fillings_has_the_openings_of_the_tessellation() {
    for triangulation in [Triangulation::Canonical, Triangulation::Tessellation] {
        let cage = triangulation.topology();
        for levels in 0..3 {
            let mesh = rosto_mesh::LoopSubdivision::new(&cage, levels);
            let skin = without_fillings(cage.triangles(), mesh.topology().triangles());
            assert_eq!(skin.len(), 852 << (2 * levels));
            let open = rosto_mesh::Topology::new(mesh.topology().vertex_count(), skin).unwrap();
            let rims: Vec<usize> = open.boundary_loops().iter().map(Vec::len).collect();
            assert_eq!(rims, [36, 20, 16, 16].map(|length| length << levels), "{triangulation:?}, {levels}");
        }
    }
}

#[test]
fn canonical_positions_are_exactly_mirrored() {
    let positions = canonical_positions_m();
    for vertex in 0..LANDMARK_COUNT as u32 {
        let partner = mirror_of(vertex);
        assert_eq!(mirror_of(partner), vertex);
        let (here, there) = (positions[vertex as usize], positions[partner as usize]);
        assert_eq!([here.x, here.y, here.z], [-there.x, there.y, there.z], "landmark {vertex}");
    }
    // Published values of the left eye's outer corner and the left mouth corner, in units of 1e-6 cm.
    for (landmark, published) in [(263, [4_445_859, 2_663_991, 3_173_422]), (291, [2_456_206, -4_342_621, 4_283_884])] {
        assert_eq!(positions[landmark].to_array(), published.map(|number| f64::from(number) * 1e-8));
    }
    let rights: Vec<u32> = (0..LANDMARK_COUNT as u32).filter(|&right| right < mirror_of(right)).collect();
    assert_eq!((MIDLINE.len(), rights.len()), (28, 220));
    assert!(rights.iter().all(|&right| positions[right as usize].x < 0.0));
}

#[test]
fn the_canonical_triangulation_is_mirror_symmetric() {
    let lowest_first = |[a, b, c]: [u32; 3]| {
        let low = a.min(b).min(c);
        if low == a {
            [a, b, c]
        } else if low == b {
            [b, c, a]
        } else {
            [c, a, b]
        }
    };
    let triangles: std::collections::BTreeSet<_> =
        Triangulation::Canonical.triangles().into_iter().map(lowest_first).collect();
    let mirrored = triangles.iter().map(|&[a, b, c]| lowest_first([mirror_of(a), mirror_of(c), mirror_of(b)]));
    assert!(mirrored.into_iter().all(|triangle| triangles.contains(&triangle)));
}

#[test]
fn both_triangulations_wind_towards_the_viewer() {
    let positions = canonical_positions_m();
    for triangulation in [Triangulation::Tessellation, Triangulation::Canonical] {
        let area_m2: f64 = triangulation
            .triangles()
            .iter()
            .map(|corners| corners.map(|corner| positions[corner as usize]))
            .map(|[a, b, c]| (b - a).cross(c - a).z / 2.0)
            .sum();
        assert!(area_m2 > 0.01, "{triangulation:?} shows the viewer {area_m2} m²");
    }
}

#[test]
fn the_oval_is_the_boundary_of_the_face() {
    let mut rim = Triangulation::Canonical.topology().boundary_loops()[0].clone();
    let mut oval = OVAL;
    rim.sort_unstable();
    oval.sort_unstable();
    assert_eq!(rim, oval);
}
