/// A part of the face that a head refines. "Left" and "right" are the subject's.
pub(crate) struct Part {
    /// The landmarks at the part's ends, on the picture's left and right. The crop is rotated so that they are level.
    pub(crate) ends: [u16; 2],
    /// The landmarks that the head refines, in the order of its output. The crop encloses them.
    pub(crate) points: &'static [u16],
}

/// Points of an iris: the centre and four on its boundary.
pub(crate) const IRIS_POINTS: usize = 5;

/// Number of lid points, which come first among an eye's points.
const LID_POINTS: usize = 16;

impl Part {
    /// Sets x and y of the part's landmarks; z stays.
    pub(crate) fn move_points(&self, points: &mut [[f32; 3]], to: impl Iterator<Item = [f32; 2]>) {
        for (&index, [x, y]) in self.points.iter().zip(to) {
            let point = &mut points[usize::from(index)];
            (point[0], point[1]) = (x, y);
        }
    }

    /// The mean z of an eye's lids, used as z of its iris.
    pub(crate) fn mean_lid_z(&self, points: &[[f32; 3]]) -> f32 {
        let lids = &self.points[..LID_POINTS];
        lids.iter().map(|&index| points[usize::from(index)][2]).sum::<f32>() / LID_POINTS as f32
    }
}

pub(crate) const LIPS: Part = Part {
    ends: [61, 291],
    points: &[
        61, 146, 91, 181, 84, 17, 314, 405, 321, 375, 291, 185, 40, 39, 37, 0, 267, 269, 270, 409, 78, 95, 88, 178, 87,
        14, 317, 402, 318, 324, 308, 191, 80, 81, 82, 13, 312, 311, 310, 415, 76, 77, 90, 180, 85, 16, 315, 404, 320,
        307, 306, 184, 74, 73, 72, 11, 302, 303, 304, 408, 62, 96, 89, 179, 86, 15, 316, 403, 319, 325, 292, 183, 42,
        41, 38, 12, 268, 271, 272, 407,
    ],
};

pub(crate) const RIGHT_EYE: Part = Part {
    ends: [33, 133],
    points: &[
        33, 7, 163, 144, 145, 153, 154, 155, 133, 246, 161, 160, 159, 158, 157, 173, 130, 25, 110, 24, 23, 22, 26, 112,
        243, 247, 30, 29, 27, 28, 56, 190, 226, 31, 228, 229, 230, 231, 232, 233, 244, 113, 225, 224, 223, 222, 221,
        189, 35, 124, 46, 53, 52, 65, 143, 111, 117, 118, 119, 120, 121, 128, 245, 156, 70, 63, 105, 66, 107, 55, 193,
    ],
};

pub(crate) const LEFT_EYE: Part = Part {
    ends: [362, 263],
    points: &[
        263, 249, 390, 373, 374, 380, 381, 382, 362, 466, 388, 387, 386, 385, 384, 398, 359, 255, 339, 254, 253, 252,
        256, 341, 463, 467, 260, 259, 257, 258, 286, 414, 446, 261, 448, 449, 450, 451, 452, 453, 464, 342, 445, 444,
        443, 442, 441, 413, 265, 353, 276, 283, 282, 295, 372, 340, 346, 347, 348, 349, 350, 357, 465, 383, 300, 293,
        334, 296, 336, 285, 417,
    ],
};
