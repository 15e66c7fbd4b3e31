//! Independent test for self-intersections: all pairs of triangles, in exact integer arithmetic.

use glam::DVec3;

/// Positions are rounded to this many parts of a metre: 0.1 µm, far below the resolution of prints.
const PARTS: f64 = 1e7;

type Point = [i128; 3];

/// First intersecting pair of triangles without a shared corner.
pub fn meets_itself(triangles: &[[u32; 3]], positions: &[DVec3]) -> Option<[[u32; 3]; 2]> {
    let whole: Vec<Point> = positions.iter().map(|p| (*p * PARTS).round().to_array().map(|c| c as i128)).collect();
    let corners_of: Vec<[Point; 3]> =
        triangles.iter().map(|corners| corners.map(|corner| whole[corner as usize])).collect();
    let mut by_x: Vec<usize> = (0..triangles.len()).collect();
    let ends = |at: usize, axis: usize| {
        let along = corners_of[at].map(|point| point[axis]);
        (along.into_iter().min().unwrap(), along.into_iter().max().unwrap())
    };
    by_x.sort_by_key(|&at| ends(at, 0).0);
    for (order, &one) in by_x.iter().enumerate() {
        for &other in by_x[order + 1..].iter().take_while(|&&other| ends(other, 0).0 <= ends(one, 0).1) {
            let apart = (1..3).any(|axis| {
                let ((low, high), (other_low, other_high)) = (ends(one, axis), ends(other, axis));
                high < other_low || other_high < low
            });
            let joined = triangles[one].iter().any(|corner| triangles[other].contains(corner));
            if !apart
                && !joined
                && (cuts(corners_of[one], corners_of[other]) || cuts(corners_of[other], corners_of[one]))
            {
                return Some([triangles[one], triangles[other]]);
            }
        }
    }
    None
}

/// Whether an edge of one triangle passes through the other.
fn cuts(one: [Point; 3], other: [Point; 3]) -> bool {
    (0..3).any(|at| {
        let (from, to) = (one[at], one[(at + 1) % 3]);
        let ends = [volume(other, from), volume(other, to)].map(i128::signum);
        let around = [0, 1, 2].map(|side| volume([from, to, other[side]], other[(side + 1) % 3]).signum());
        ends[0] * ends[1] < 0 && (around.iter().all(|&side| side > 0) || around.iter().all(|&side| side < 0))
    })
}

/// Six times the signed volume of a tetrahedron.
fn volume([a, b, c]: [Point; 3], d: Point) -> i128 {
    let from = |p: Point| [p[0] - d[0], p[1] - d[1], p[2] - d[2]];
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (from(a), from(b), from(c));
    ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
}
