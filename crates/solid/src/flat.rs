//! A flat back, in a plane behind the front.

use glam::{DVec2, DVec3};

use crate::crossings::crossings_of;
use crate::filling;
use crate::front::Front;

/// How far the outline of the back goes from the rim's own towards a smooth one, one after the other until nothing meets.
const TRIES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// The smooth outline is larger by so much, so that what bulges beyond the rim stays inside.
const WIDER: f64 = 1.15;

/// The back's corners, one behind each vertex of the rim, and its triangles over places of the rim, counter-clockwise as
/// seen from the front.
pub(crate) struct FlatBack {
    pub positions: Vec<DVec3>,
    pub triangles: Vec<[usize; 3]>,
}

/// A back in the plane that lies so far behind the deepest vertex; none if its sides would go through the front.
pub(crate) fn back(front: &Front, behind: f64) -> Option<FlatBack> {
    let plane = front.positions.iter().map(|place| place.z).fold(f64::INFINITY, f64::min) - behind;
    let rim: Vec<DVec2> = front.rim.iter().map(|&vertex| front.positions[vertex as usize].truncate()).collect();
    let smooth = smooth(&rim);
    TRIES.into_iter().find_map(|share| {
        let outline = rim.iter().zip(&smooth).map(|(own, smooth)| own.lerp(*smooth, share).extend(plane));
        let positions: Vec<DVec3> = outline.collect();
        let back = FlatBack { triangles: filling::flat(&positions)?, positions };
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

    /// The triangles of the front, of the sides, and of the back.
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

/// A loop smoothed until it hardly has a dent left, as large as it was and a little more.
fn smooth(rim: &[DVec2]) -> Vec<DVec2> {
    let count = rim.len();
    let middle = rim.iter().sum::<DVec2>() / count as f64;
    let size = |places: &[DVec2]| places.iter().map(|place| place.distance(middle)).sum::<f64>();
    let mut places = rim.to_vec();
    // What is left of a wave as long as the loop after as many sweeps as this is a half.
    for _ in 0..count * count / 16 {
        places = (0..count)
            .map(|at| places[(at + count - 1) % count].midpoint(places[(at + 1) % count]).midpoint(places[at]))
            .collect();
    }
    let grown = WIDER * size(rim) / size(&places).max(f64::MIN_POSITIVE);
    places.into_iter().map(|place| middle + (place - middle) * grown).collect()
}
