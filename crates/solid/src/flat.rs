//! A flat back in a plane behind the front.

use glam::{DVec2, DVec3};

use crate::crossings::crossings_of;
use crate::filling;
use crate::front::Front;

/// Blends between the rim's outline and a smoothed one, tried in turn until nothing intersects.
const TRIES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Scale of the smoothed outline, so that parts bulging beyond the rim stay inside.
const OUTLINE_SCALE: f64 = 1.15;

/// The back: one vertex behind each rim vertex, and triangles over rim indices, counter-clockwise as seen from the
/// front.
pub(crate) struct FlatBack {
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[usize; 3]>,
    /// Z of the plane.
    pub plane: f64,
}

/// A back in the plane `behind` the deepest vertex; `None` if its walls would intersect the front.
pub(crate) fn back(front: &Front, behind: f64) -> Option<FlatBack> {
    let plane = front.positions.iter().map(|position| position.z).fold(f64::INFINITY, f64::min) - behind;
    let rim: Vec<DVec2> = front.rim.iter().map(|&vertex| front.positions[vertex as usize].truncate()).collect();
    let smooth = smooth(&rim);
    TRIES.into_iter().find_map(|share| {
        let outline = rim.iter().zip(&smooth).map(|(own, smooth)| own.lerp(*smooth, share).extend(plane));
        let positions: Vec<DVec3> = outline.collect();
        let back = FlatBack { triangles: filling::flat(&positions)?, positions, plane };
        back.is_clear(front).then_some(back)
    })
}

impl FlatBack {
    fn is_clear(&self, front: &Front) -> bool {
        let triangles = self.joined(front);
        let positions = [front.positions.as_slice(), &self.positions].concat();
        let own = front.topology.triangles().len() as u32;
        crossings_of(&triangles, &positions, |triangle| triangle >= own).is_empty()
    }

    /// Triangles of the front, the walls and the back.
    pub(crate) fn joined(&self, front: &Front) -> Vec<[u32; 3]> {
        let behind = |at: usize| (front.positions.len() + at % front.rim.len()) as u32;
        let mut triangles = front.topology.triangles().to_vec();
        for (at, &a) in front.rim.iter().enumerate() {
            let b = front.rim[(at + 1) % front.rim.len()];
            triangles.extend([[b, a, behind(at)], [b, behind(at), behind(at + 1)]]);
        }
        triangles.extend(self.triangles.iter().map(|&[a, b, c]| [c, b, a].map(behind)));
        triangles
    }
}

/// Smooths a loop until it is nearly convex, slightly enlarged.
fn smooth(rim: &[DVec2]) -> Vec<DVec2> {
    let count = rim.len();
    let centre = rim.iter().sum::<DVec2>() / count as f64;
    let size = |points: &[DVec2]| points.iter().map(|point| point.distance(centre)).sum::<f64>();
    let mut points = rim.to_vec();
    // This number of sweeps halves a wave as long as the loop.
    for _ in 0..count * count / 16 {
        points = (0..count)
            .map(|at| points[(at + count - 1) % count].midpoint(points[(at + 1) % count]).midpoint(points[at]))
            .collect();
    }
    let scale = OUTLINE_SCALE * size(rim) / size(&points).max(f64::MIN_POSITIVE);
    points.into_iter().map(|point| centre + (point - centre) * scale).collect()
}
