use crate::Pose;

rosto_mesh::named! {
    /// The ways to turn the head that photos of a face are to show, one each.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Turn {
        /// Looking at the camera, but for 15°.
        Front = "front",
        /// To the subject's own left by 20 to 60°: its right cheek is seen.
        Left = "left",
        /// To the subject's own right by 20 to 60°: its left cheek is seen.
        Right = "right",
    }
}

/// Looks at the camera if it is turned by less than this, in degrees.
const FRONT_DEG: f64 = 15.0;
/// Shows a side if it is turned by this much.
const SIDE_DEG: std::ops::RangeInclusive<f64> = 20.0..=60.0;

impl Turn {
    /// Which of them a head shows that is turned so; none in between and beyond.
    pub fn of(pose: Pose) -> Option<Self> {
        let turned_deg = pose.yaw_deg.abs();
        match SIDE_DEG.contains(&turned_deg) {
            true if pose.yaw_deg > 0.0 => Some(Self::Left),
            true => Some(Self::Right),
            false => (turned_deg < FRONT_DEG).then_some(Self::Front),
        }
    }

    /// Those that none of the heads shows, in the order of [`Self::ALL`].
    pub fn missing(poses: impl IntoIterator<Item = Pose>) -> Vec<Self> {
        let shown: Vec<Self> = poses.into_iter().filter_map(Self::of).collect();
        Self::ALL.into_iter().filter(|turn| !shown.contains(turn)).collect()
    }
}
