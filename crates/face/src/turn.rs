use crate::Pose;

rosto_mesh::named! {
    /// Head orientations that a set of photos should cover.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Turn {
        /// Facing the camera, to within 15°.
        Front = "front",
        /// Turned to the subject's left by 20 to 60°, which shows the right cheek.
        Left = "left",
        /// Turned to the subject's right by 20 to 60°, which shows the left cheek.
        Right = "right",
    }
}

/// Largest yaw of a frontal head, in degrees.
const FRONT_DEG: f64 = 15.0;
/// Range of the yaw of a turned head, in degrees.
const SIDE_DEG: std::ops::RangeInclusive<f64> = 20.0..=60.0;

impl Turn {
    /// Classifies an orientation; `None` between and beyond the ranges.
    pub fn of(pose: Pose) -> Option<Self> {
        let turned_deg = pose.yaw_deg.abs();
        match SIDE_DEG.contains(&turned_deg) {
            true if pose.yaw_deg > 0.0 => Some(Self::Left),
            true => Some(Self::Right),
            false => (turned_deg < FRONT_DEG).then_some(Self::Front),
        }
    }

    /// Orientations that none of the poses covers, in the order of [`Self::ALL`].
    pub fn missing(poses: impl IntoIterator<Item = Pose>) -> Vec<Self> {
        let shown: Vec<Self> = poses.into_iter().filter_map(Self::of).collect();
        Self::ALL.into_iter().filter(|turn| !shown.contains(turn)).collect()
    }
}
