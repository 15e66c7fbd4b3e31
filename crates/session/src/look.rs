use rosto_studio::Expression;

rosto_mesh::named! {
    /// A ready-made combination of expressions.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Look {
        /// A smile with raised cheeks.
        Smile = "smile",
        /// The left eye closed, with half a smile.
        Wink = "wink",
        /// Brows up, eyes wide, mouth open.
        Surprised = "surprised",
        /// Inner brows up, corners of the mouth down.
        Sad = "sad",
        /// Brows down, nose wrinkled, lips pressed.
        Angry = "angry",
        /// Pursed lips.
        Kiss = "kiss",
        /// Cheeks filled with air.
        Puffed = "puffed",
        /// Both eyes closed.
        Asleep = "asleep",
    }
}

impl Look {
    /// Weights of its expressions, 0..=1; all others are 0.
    pub fn weights(self) -> [f64; Expression::ALL.len()] {
        use Expression::*;
        let some: &[(Expression, f64)] = match self {
            Self::Smile => {
                &[(MouthSmileLeft, 0.8), (MouthSmileRight, 0.8), (CheekSquintLeft, 0.4), (CheekSquintRight, 0.4)]
            }
            Self::Wink => &[(EyeBlinkLeft, 1.0), (CheekSquintLeft, 0.5), (MouthSmileLeft, 0.5), (MouthSmileRight, 0.2)],
            Self::Surprised => &[
                (BrowInnerUp, 0.9),
                (BrowOuterUpLeft, 0.9),
                (BrowOuterUpRight, 0.9),
                (EyeWideLeft, 0.8),
                (EyeWideRight, 0.8),
                (JawOpen, 0.4),
            ],
            Self::Sad => &[(BrowInnerUp, 0.9), (MouthFrownLeft, 0.8), (MouthFrownRight, 0.8), (MouthShrugLower, 0.3)],
            Self::Angry => &[
                (BrowDownLeft, 1.0),
                (BrowDownRight, 1.0),
                (NoseSneerLeft, 0.5),
                (NoseSneerRight, 0.5),
                (MouthPressLeft, 0.6),
                (MouthPressRight, 0.6),
            ],
            Self::Kiss => &[(MouthPucker, 1.0)],
            Self::Puffed => &[(CheekPuff, 1.0), (MouthPucker, 0.3)],
            Self::Asleep => &[(EyeBlinkLeft, 1.0), (EyeBlinkRight, 1.0)],
        };
        let mut weights = [0.0; Expression::ALL.len()];
        some.iter().for_each(|(expression, weight)| weights[*expression as usize] = *weight);
        weights
    }
}
