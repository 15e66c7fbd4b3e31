use glam::DVec3;

use crate::Surface;

/// A half-line. `direction` need not be normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Start point.
    pub origin: DVec3,
    /// Direction; its length is the unit of distance along the ray.
    pub direction: DVec3,
}

impl Ray {
    /// The point `origin + distance · direction`.
    pub fn at(&self, distance: f64) -> DVec3 {
        self.origin + distance * self.direction
    }
}

/// The first intersection of a ray with a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: usize,
    /// Vertices of the triangle.
    pub corners: [u32; 3],
    /// Barycentric coordinates of the point, each in `0..=1`, with sum 1.
    pub barycentric: [f64; 3],
    /// Distance along the ray, in multiples of its direction.
    pub distance: f64,
}

impl Hit {
    /// The vertex with the greatest barycentric coordinate.
    pub fn nearest_corner(&self) -> u32 {
        let [a, b, c] = self.barycentric;
        let corner = if a >= b && a >= c { 0 } else { 1 + usize::from(c > b) };
        self.corners[corner]
    }
}

/// Returns the nearest triangle that `ray` meets at or after its origin, from either side, or `None`.
///
/// Tests all triangles by Möller and Trumbore's method. Misses triangles seen exactly edge-on and triangles with a
/// non-finite corner.
pub fn pick(surface: Surface<'_>, ray: &Ray) -> Option<Hit> {
    let triangles = surface.topology().triangles().iter().zip(surface.triangles()).enumerate();
    let hits = triangles.filter_map(|(triangle, (&corners, corner_positions))| {
        let (barycentric, distance) = meet(ray, corner_positions)?;
        Some(Hit { triangle, corners, barycentric, distance })
    });
    hits.min_by(|one, other| one.distance.total_cmp(&other.distance))
}

/// Tolerance on barycentric coordinates, so that a ray aimed at a corner or an edge does not pass between its
/// triangles.
const TOLERANCE: f64 = 1e-9;

fn meet(ray: &Ray, [a, b, c]: [DVec3; 3]) -> Option<([f64; 3], f64)> {
    let (ab, ac) = (b - a, c - a);
    let across = ray.direction.cross(ac);
    let determinant = ab.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let from_a = ray.origin - a;
    let v = from_a.dot(across) / determinant;
    let around = from_a.cross(ab);
    let w = ray.direction.dot(around) / determinant;
    let distance = ac.dot(around) / determinant;
    let u = 1.0 - v - w;
    let inside = u >= -TOLERANCE && v >= -TOLERANCE && w >= -TOLERANCE && distance >= 0.0 && distance.is_finite();
    inside.then(|| ([u, v, w].map(|weight| weight.clamp(0.0, 1.0)), distance))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Topology;
    use crate::shapes::icosahedron;

    fn pick(topology: &Topology, positions: &[DVec3], ray: &Ray) -> Option<Hit> {
        super::pick(Surface::new(topology, positions).unwrap(), ray)
    }

    proptest! {
        #[test]
        fn a_ray_at_a_surface_point_hits_it_first(
            triangle in 0..20usize, (u, v) in (0.01..0.98f64, 0.01..0.98f64), far in 0.5..50.0f64,
        ) {
            let weights = [u * (1.0 - v), u * v, 1.0 - u];
            let (topology, positions) = icosahedron();
            let corners = topology.triangles()[triangle].map(|corner| positions[corner as usize]);
            let target: DVec3 = weights.iter().zip(corners).map(|(&weight, corner)| weight * corner).sum();
            let ray = Ray { origin: target * (1.0 + far), direction: -target };
            let hit = pick(&topology, &positions, &ray).unwrap();
            prop_assert_eq!(hit.triangle, triangle);
            prop_assert!((ray.at(hit.distance) - target).length() < 1e-12);
            for (found, weight) in hit.barycentric.iter().zip(weights) {
                prop_assert!((found - weight).abs() < 1e-9);
            }
        }

        #[test]
        fn a_ray_away_from_the_mesh_misses(direction in prop::array::uniform3(-1.0..1.0f64)) {
            let direction = DVec3::from(direction);
            prop_assume!(direction.length() > 0.1);
            let (topology, positions) = icosahedron();
            let ray = Ray { origin: 2.0 * direction.normalize(), direction };
            prop_assert_eq!(pick(&topology, &positions, &ray), None);
        }
    }

    #[test]
    fn nearest_corner_has_the_greatest_weight() {
        let (topology, positions) = icosahedron();
        for &[a, b, c] in topology.triangles() {
            let [at, b, c] = [a, b, c].map(|corner| positions[corner as usize]);
            let target = 0.9 * at + 0.06 * b + 0.04 * c;
            let hit = pick(&topology, &positions, &Ray { origin: 3.0 * target, direction: -target }).unwrap();
            assert_eq!(hit.nearest_corner(), a);
        }
    }

    #[test]
    fn rays_at_shared_corners_and_edges_hit() {
        let (topology, positions) = icosahedron();
        let eye = DVec3::new(0.3, -1.7, 4.1);
        let middle = |[a, b]: &[u32; 2]| 0.5 * (positions[*a as usize] + positions[*b as usize]);
        let edges = topology.edges().iter().map(middle);
        for target in positions.iter().copied().chain(edges) {
            let hit = pick(&topology, &positions, &Ray { origin: eye, direction: target - eye });
            assert!(hit.is_some_and(|hit| hit.distance < 1.0 + 1e-9), "{target}");
        }
    }

    #[test]
    fn non_finite_rays_and_positions_miss() {
        let (topology, mut positions) = icosahedron();
        let towards = |origin: DVec3| Ray { origin, direction: -origin };
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
            assert_eq!(pick(&topology, &positions, &towards(DVec3::splat(broken))), None, "{broken}");
            assert_eq!(pick(&topology, &positions, &Ray { origin: DVec3::X, direction: DVec3::splat(broken) }), None);
        }
        positions.fill(DVec3::NAN);
        assert_eq!(pick(&topology, &positions, &towards(DVec3::X)), None);
    }

    #[test]
    fn triangles_without_area_are_missed() {
        let flat = Topology::new(3, vec![[0, 1, 2]]).unwrap();
        let line = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X];
        assert_eq!(pick(&flat, &line, &Ray { origin: DVec3::Z, direction: -DVec3::Z }), None);
    }
}
