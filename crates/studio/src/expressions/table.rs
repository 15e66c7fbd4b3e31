use rosto_face::{Area, Measure};

use super::Expression;

/// Definition of an expression. Handles and pins are landmarks of the midline and of the subject's right; expressions
/// of the left are mirror images.
pub(super) struct Definition {
    /// Measure that scales lengths from the canonical face to another face.
    pub sized_by: Measure,
    /// Sides on which it acts.
    pub extent: Extent,
    /// Areas that follow the handles; the rest of the face stays.
    pub follow: &'static [Area],
    /// Landmarks that stay although their area follows.
    pub pins: &'static [u32],
    /// The moved landmarks and their motions.
    pub handles: &'static [(&'static [u32], Motion)],
}

/// Sides of the face on which an expression acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Extent {
    /// One side.
    Half,
    /// Both sides, as mirror images.
    Both,
    /// Both sides, in the same sideways direction.
    Sideways,
}

/// Motion of a handle.
#[derive(Debug, Clone, Copy)]
pub(super) enum Motion {
    /// Offset in mm: +X to the subject's left, +Y up, +Z out of the face.
    By([f64; 3]),
    /// Share of the displacement that closes the lids.
    Lid(f64),
    /// Share of the jaw's rotation, plus an offset in mm.
    Jaw(f64, [f64; 3]),
    /// Share of another landmark's displacement by the jaw.
    Seal(u32, f64),
}

/// Columns of the upper and lower lip, from the middle to the corner.
const UP: [&[u32]; 5] =
    [&[0, 11, 12, 13], &[37, 72, 38, 82], &[39, 73, 41, 81], &[40, 74, 42, 80], &[185, 184, 183, 191]];
const LOW: [&[u32]; 5] =
    [&[17, 16, 15, 14], &[84, 85, 86, 87], &[181, 180, 179, 178], &[91, 90, 89, 88], &[146, 77, 96, 95]];
const CORNER: &[u32] = &[61, 76, 62, 78];

const EYE: &[Area] = &[Area::UpperEyelid, Area::LowerEyelid, Area::UnderBrow, Area::UnderEye];
const BROW: &[Area] = &[Area::Brow, Area::UnderBrow, Area::Forehead, Area::Glabella, Area::Temple];
const LOWER_FACE: &[Area] = &[
    Area::LowerLip,
    Area::MouthCorner,
    Area::ChinCrease,
    Area::Chin,
    Area::SmileLine,
    Area::Jaw,
    Area::Cheek,
    Area::SideOfFace,
];
const MOUTH: &[Area] = &[
    Area::UpperLip,
    Area::LowerLip,
    Area::MouthCorner,
    Area::Philtrum,
    Area::ChinCrease,
    Area::SmileLine,
    Area::Cheek,
    Area::Chin,
];
const LOWER_LIP: &[Area] = &[Area::LowerLip, Area::MouthCorner, Area::ChinCrease, Area::Chin, Area::SmileLine];
const UPPER_LIP: &[Area] = &[Area::UpperLip, Area::MouthCorner, Area::Philtrum, Area::SmileLine];
/// Edge of the upper lid.
const UPPER_EDGE: &[u32] = &[246, 161, 160, 159, 158, 157, 173];
/// Edge of the lower lid.
const LOWER_EDGE: &[u32] = &[7, 163, 144, 145, 153, 154, 155];

/// The definition for the right side, and whether to mirror it to the left.
pub(super) fn definition(expression: Expression) -> (Definition, bool) {
    let mirrored = expression.mirrored();
    let is_left = mirrored != expression && expression.id().ends_with("Left");
    (right_side(if is_left { mirrored } else { expression }), is_left)
}

/// The table of expressions; each arm contains the full definition.
#[rustfmt::skip]
fn right_side(expression: Expression) -> Definition {
    use Expression::*;
    use Extent::{Both, Half, Sideways};
    use Measure::{EyeDistance, FaceHeight, FaceWidth, MouthWidth};
    use Motion::{By, Jaw, Lid, Seal};
    match expression {
        EyeBlinkRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: EYE, pins: &[130, 243, 33, 133, 225, 224, 223, 222, 221, 113, 189, 35, 226, 31, 228, 229, 230, 231, 232, 233, 244],
            handles: &[
                (UPPER_EDGE, Lid(1.0)), (LOWER_EDGE, Lid(1.0)),
            ],
        },
        EyeSquintRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: &[Area::UpperEyelid, Area::LowerEyelid, Area::UnderEye, Area::Cheekbone, Area::UnderBrow], pins: &[33, 133, 130, 243, 225, 224, 223, 222, 221],
            handles: &[
                (UPPER_EDGE, Lid(0.25)), (&[7, 163, 144, 145, 153, 154, 155], Lid(1.6)),
                (&[228, 229, 230, 231], By([0.0, 1.6, 0.6])), (&[117, 118], By([0.0, 1.2, 0.4])),
            ],
        },
        EyeWideRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: EYE, pins: &[33, 133, 130, 243, 225, 224, 223, 222, 221, 113, 189, 229, 230, 231],
            handles: &[
                (&[246, 173], By([0.0, 0.8, 0.0])), (&[161, 157], By([0.0, 1.6, -0.2])), (&[160, 159, 158], By([0.0, 2.2, -0.3])),
                (&[163, 154], By([0.0, -0.5, 0.0])), (&[144, 145, 153], By([0.0, -0.7, 0.0])),
            ],
        },
        JawForward => Definition {
            sized_by: FaceHeight, extent: Both, follow: LOWER_FACE, pins: &[234, 93, 132, 101, 36, 142, 100, 120, 121],
            handles: &[
                (&[152, 148, 176, 175, 171, 199, 208, 200, 201], By([0.0, -0.5, 7.0])), (&[149], By([0.0, -0.5, 6.5])), (&[150], By([0.0, 0.0, 5.5])), (&[136], By([0.0, 0.0, 4.0])),
                (&[18, 83, 182], By([0.0, -0.5, 6.8])), (LOW[0], By([0.0, -0.5, 6.2])), (LOW[1], By([0.0, -0.5, 6.0])), (LOW[2], By([0.0, -0.5, 5.2])),
                (LOW[3], By([0.0, -0.3, 4.0])), (LOW[4], By([0.0, 0.0, 2.4])), (CORNER, By([0.0, 0.0, 1.2])),
            ],
        },
        JawRight => Definition {
            sized_by: FaceHeight, extent: Sideways, follow: LOWER_FACE, pins: &[234, 93, 101, 36, 142, 100, 120, 121],
            handles: &[
                (&[152, 148, 176, 175, 171, 199, 208, 200, 201], By([-8.0, 0.0, 0.0])), (&[149, 150], By([-7.0, 0.0, 0.0])), (&[136], By([-5.0, 0.0, 0.0])), (&[172], By([-3.0, 0.0, 0.0])),
                (&[18, 83, 182], By([-7.6, 0.0, 0.0])), (LOW[0], By([-6.6, 0.0, 0.0])), (LOW[1], By([-6.4, 0.0, 0.0])), (LOW[2], By([-5.6, 0.0, 0.0])),
                (LOW[3], By([-4.6, 0.0, 0.0])), (LOW[4], By([-3.4, 0.0, 0.0])), (CORNER, By([-2.4, 0.0, 0.0])),
            ],
        },
        JawOpen => Definition {
            sized_by: FaceHeight, extent: Both, follow: LOWER_FACE, pins: &[234, 93, 101, 36, 142, 100, 120, 121],
            handles: &[
                (&[152, 148, 176, 175, 171, 140, 199, 208, 32, 200, 201], Jaw(1.0, [0.0, 0.0, 0.0])),
                (&[149], Jaw(0.97, [0.0, 0.0, 0.0])), (&[150], Jaw(0.88, [0.0, 0.0, 0.0])), (&[136], Jaw(0.68, [0.0, 0.0, 0.0])), (&[172], Jaw(0.42, [0.0, 0.0, 0.0])), (&[58], Jaw(0.2, [0.0, 0.0, 0.0])), (&[132], Jaw(0.06, [0.0, 0.0, 0.0])),
                (&[18, 83], Jaw(1.0, [0.0, 0.0, 0.0])), (&[182], Jaw(0.96, [0.0, 0.0, 0.0])),
                (LOW[0], Jaw(1.0, [0.0, 0.0, 0.0])), (LOW[1], Jaw(0.98, [0.5, 0.0, 0.0])), (LOW[2], Jaw(0.91, [1.2, 0.0, 0.0])), (LOW[3], Jaw(0.77, [2.0, 0.0, 0.0])),
                (LOW[4], Jaw(0.59, [2.6, 0.0, 0.0])), (CORNER, Jaw(0.4, [3.0, 0.0, -1.0])),
            ],
        },
        MouthClose => Definition {
            sized_by: FaceHeight, extent: Both, follow: &[Area::UpperLip, Area::LowerLip, Area::MouthCorner, Area::Philtrum, Area::ChinCrease, Area::SmileLine, Area::Chin], pins: &[152, 148, 176],
            handles: &[
                (&[14], Seal(14, -0.72)), (&[87], Seal(87, -0.72)), (&[178], Seal(178, -0.66)), (&[88], Seal(88, -0.54)), (&[95], Seal(95, -0.32)),
                (&[13], Seal(14, 0.28)), (&[82], Seal(87, 0.26)), (&[81], Seal(178, 0.25)), (&[80], Seal(88, 0.23)), (&[191], Seal(95, 0.16)),
                (&[17, 16, 15], Seal(14, -0.66)), (&[84, 85, 86], Seal(87, -0.65)), (&[181, 180, 179], Seal(178, -0.6)), (&[91, 90, 89], Seal(88, -0.48)), (&[146, 77, 96], Seal(95, -0.28)),
                (&[0, 11, 12], Seal(14, 0.2)), (&[37, 72, 38], Seal(87, 0.19)), (&[39, 73, 41], Seal(178, 0.18)), (&[40, 74, 42], Seal(88, 0.15)), (&[185], Seal(95, 0.0)),
                (&[184, 183], Seal(95, 0.06)),
                (CORNER, Seal(78, -0.08)),
            ],
        },
        MouthFunnel => Definition {
            sized_by: MouthWidth, extent: Both, follow: MOUTH, pins: &[152, 101, 142, 100, 120, 121, 147],
            handles: &[
                (&[0], By([0.0, 3.0, 6.5])), (&[11], By([0.0, 3.5, 8.0])), (&[12, 13], By([0.0, 3.8, 8.0])),
                (&[37], By([1.0, 3.0, 6.3])), (&[72], By([1.0, 3.5, 7.8])), (&[38, 82], By([1.0, 3.6, 7.8])),
                (&[39], By([2.6, 2.6, 5.8])), (&[73], By([2.6, 3.0, 7.0])), (&[41, 81], By([2.6, 3.2, 7.0])),
                (&[40], By([4.6, 1.6, 5.2])), (&[74], By([4.6, 2.0, 6.2])), (&[42, 80], By([4.6, 2.2, 6.2])),
                (&[185], By([6.2, 0.6, 4.6])), (&[184], By([6.4, 0.8, 5.4])), (&[183, 191], By([6.4, 1.0, 5.4])),
                (CORNER, By([7.2, -0.6, 4.2])),
                (&[17], By([0.0, -4.0, 6.0])), (&[16], By([0.0, -5.0, 7.5])), (&[15, 14], By([0.0, -5.6, 7.5])),
                (&[84], By([1.0, -4.0, 5.8])), (&[85], By([1.0, -4.8, 7.3])), (&[86, 87], By([1.0, -5.2, 7.3])),
                (&[181], By([2.6, -3.6, 5.4])), (&[180], By([2.6, -4.2, 6.6])), (&[179, 178], By([2.6, -4.6, 6.6])),
                (&[91], By([4.6, -2.6, 4.8])), (&[90], By([4.6, -3.0, 5.8])), (&[89, 88], By([4.6, -3.2, 5.8])),
                (&[146], By([6.2, -1.4, 4.4])), (&[77], By([6.4, -1.7, 5.2])), (&[96, 95], By([6.4, -1.9, 5.2])),
            ],
        },
        MouthPucker => Definition {
            sized_by: MouthWidth, extent: Both, follow: MOUTH, pins: &[152, 101, 142, 100, 120, 121, 147],
            handles: &[
                (UP[0], By([0.0, 0.6, 7.0])), (UP[1], By([2.6, 0.6, 7.0])), (UP[2], By([5.0, 0.2, 7.0])), (UP[3], By([7.2, -0.4, 7.0])), (UP[4], By([8.8, -0.6, 6.6])),
                (CORNER, By([9.8, -0.6, 6.0])),
                (LOW[0], By([0.0, -0.6, 7.0])), (LOW[1], By([2.6, -0.6, 7.0])), (LOW[2], By([5.0, -0.6, 7.0])), (LOW[3], By([7.2, -0.6, 7.0])), (LOW[4], By([8.8, -0.6, 6.6])),
            ],
        },
        MouthRight => Definition {
            sized_by: EyeDistance, extent: Sideways, follow: MOUTH, pins: &[152, 101, 142, 100, 120, 121, 147],
            handles: &[
                (UP[0], By([-7.0, 0.0, -0.5])), (UP[1], By([-7.0, 0.0, -0.5])), (UP[2], By([-6.8, 0.0, -0.5])), (UP[3], By([-6.4, 0.0, -0.6])), (UP[4], By([-6.0, 0.0, -0.8])),
                (CORNER, By([-5.6, 0.0, -1.0])),
                (LOW[0], By([-6.8, 0.0, -0.5])), (LOW[1], By([-6.8, 0.0, -0.5])), (LOW[2], By([-6.6, 0.0, -0.5])), (LOW[3], By([-6.2, 0.0, -0.6])), (LOW[4], By([-5.8, 0.0, -0.8])),
            ],
        },
        MouthSmileRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: &[Area::UpperLip, Area::LowerLip, Area::MouthCorner, Area::Philtrum, Area::ChinCrease, Area::SmileLine, Area::Cheek, Area::Cheekbone, Area::UnderEye, Area::LowerEyelid, Area::Jaw], pins: &[0, 11, 12, 13, 14, 15, 16, 17, 18, 33, 133, 130, 243, 226, 35, 244, 233, 227, 116],
            handles: &[
                (CORNER, By([-6.5, 8.5, -4.0])), (&[57], By([-5.5, 7.5, -2.0])), (&[186], By([-4.5, 7.0, 0.0])),
                (UP[4], By([-5.2, 6.4, -3.4])), (UP[3], By([-3.6, 3.8, -2.2])), (UP[2], By([-2.0, 1.6, -1.2])), (UP[1], By([-0.8, 0.4, -0.5])),
                (LOW[4], By([-5.4, 6.6, -3.6])), (LOW[3], By([-3.8, 4.0, -2.6])), (LOW[2], By([-2.2, 1.8, -1.6])), (LOW[1], By([-0.8, 0.5, -0.6])),
                (&[216], By([-3.5, 6.0, 2.0])), (&[206], By([-2.2, 5.0, 2.6])), (&[205], By([-1.2, 5.2, 3.4])), (&[207], By([-3.2, 5.5, 2.2])),
                (&[50], By([-0.8, 3.6, 2.6])), (&[36], By([-0.6, 3.8, 1.8])), (&[101], By([0.0, 2.6, 1.6])), (&[118], By([0.0, 1.8, 1.0])), (&[117], By([-0.3, 1.6, 0.8])),
                (&[144, 145, 153], By([0.0, 0.7, 0.2])), (&[229, 230], By([0.0, 1.2, 0.6])),
            ],
        },
        MouthFrownRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: MOUTH, pins: &[0, 11, 12, 13, 14, 15, 16, 17, 18, 152, 101, 142, 100, 120, 121, 147, 36],
            handles: &[
                (CORNER, By([-1.0, -7.0, -0.8])), (&[57], By([-1.0, -6.0, -0.4])), (&[43], By([-0.8, -4.6, 0.6])),
                (UP[4], By([-0.8, -5.2, -0.7])), (UP[3], By([-0.5, -2.9, -0.5])), (UP[2], By([-0.2, -1.1, -0.2])),
                (LOW[4], By([-0.8, -5.0, -0.3])), (LOW[3], By([-0.5, -2.6, 0.2])), (LOW[2], By([-0.2, -0.8, 0.3])),
            ],
        },
        MouthDimpleRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: MOUTH, pins: &[0, 11, 12, 13, 14, 15, 16, 17, 18, 152, 101, 142, 100, 120, 121, 147, 36],
            handles: &[
                (CORNER, By([-4.5, 1.2, -4.5])), (&[57], By([-2.4, 0.8, -3.6])), (&[186, 212], By([-1.0, 0.4, 0.6])), (&[43], By([-2.0, 0.6, -1.4])),
                (UP[4], By([-3.4, 1.0, -3.4])), (UP[3], By([-2.2, 0.5, -2.0])), (UP[2], By([-1.0, 0.2, -0.9])),
                (LOW[4], By([-3.4, 1.0, -3.4])), (LOW[3], By([-2.2, 0.5, -2.0])), (LOW[2], By([-1.0, 0.2, -0.9])),
                (&[216, 207, 214], By([-0.6, 0.4, 0.8])),
            ],
        },
        MouthStretchRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: &[Area::UpperLip, Area::LowerLip, Area::MouthCorner, Area::Philtrum, Area::ChinCrease, Area::SmileLine, Area::Cheek, Area::Chin, Area::Jaw], pins: &[0, 11, 12, 13, 14, 15, 16, 17, 18, 152, 101, 142, 100, 120, 121, 147, 36],
            handles: &[
                (CORNER, By([-8.0, -2.2, -4.0])), (&[57], By([-7.0, -2.2, -2.4])), (&[43], By([-5.0, -2.4, -1.6])), (&[212], By([-4.6, -1.6, -0.6])),
                (UP[4], By([-6.6, -1.6, -3.4])), (UP[3], By([-4.6, -0.8, -2.2])), (UP[2], By([-2.6, -0.3, -1.2])), (UP[1], By([-1.0, 0.0, -0.5])),
                (LOW[4], By([-6.6, -2.0, -3.4])), (LOW[3], By([-4.6, -1.8, -2.2])), (LOW[2], By([-2.6, -1.2, -1.2])), (LOW[1], By([-1.0, -0.5, -0.5])),
                (&[202], By([-3.2, -2.0, -0.4])),
            ],
        },
        MouthRollLower => Definition {
            sized_by: EyeDistance, extent: Both, follow: LOWER_LIP, pins: &[152, 61, 76, 62, 78, 148, 176],
            handles: &[
                (&[17], By([0.0, 6.0, -3.0])), (&[16], By([0.0, 4.0, -5.0])), (&[15], By([0.0, 1.8, -6.2])), (&[14], By([0.0, 0.2, -6.4])),
                (&[84], By([0.0, 5.6, -2.8])), (&[85], By([0.0, 3.8, -4.8])), (&[86], By([0.0, 1.7, -6.0])), (&[87], By([0.0, 0.2, -6.2])),
                (&[181], By([0.0, 4.4, -2.4])), (&[180], By([0.0, 3.0, -4.2])), (&[179], By([0.0, 1.3, -5.2])), (&[178], By([0.0, 0.2, -5.4])),
                (&[91], By([0.0, 2.6, -1.8])), (&[90], By([0.0, 1.8, -3.0])), (&[89], By([0.0, 0.8, -3.6])), (&[88], By([0.0, 0.1, -3.8])),
                (&[146], By([0.0, 0.9, -0.8])), (&[77], By([0.0, 0.6, -1.2])), (&[96], By([0.0, 0.3, -1.4])), (&[95], By([0.0, 0.0, -1.5])),
                (&[18], By([0.0, 2.4, -0.6])), (&[83], By([0.0, 2.2, -0.6])),
            ],
        },
        MouthRollUpper => Definition {
            sized_by: EyeDistance, extent: Both, follow: UPPER_LIP, pins: &[61, 76, 62, 78],
            handles: &[
                (&[0], By([0.0, -4.4, -3.0])), (&[11], By([0.0, -2.6, -4.8])), (&[12], By([0.0, -1.2, -5.6])), (&[13], By([0.0, -0.1, -5.8])),
                (&[37], By([0.0, -4.4, -2.9])), (&[72], By([0.0, -2.6, -4.6])), (&[38], By([0.0, -1.1, -5.4])), (&[82], By([0.0, -0.1, -5.6])),
                (&[39], By([0.0, -3.4, -2.4])), (&[73], By([0.0, -2.0, -3.8])), (&[41], By([0.0, -0.8, -4.6])), (&[81], By([0.0, -0.1, -4.8])),
                (&[40], By([0.0, -1.9, -1.6])), (&[74], By([0.0, -1.1, -2.6])), (&[42], By([0.0, -0.5, -3.1])), (&[80], By([0.0, 0.0, -3.3])),
                (&[185], By([0.0, -0.7, -0.7])), (&[184], By([0.0, -0.4, -1.1])), (&[183], By([0.0, -0.2, -1.3])), (&[191], By([0.0, 0.0, -1.4])),
                (&[164], By([0.0, -1.6, -0.8])), (&[167], By([0.0, -1.5, -0.8])),
            ],
        },
        MouthShrugLower => Definition {
            sized_by: EyeDistance, extent: Both, follow: LOWER_FACE, pins: &[234, 93, 132, 58, 172, 101, 36, 142, 100, 120, 121, 187, 147, 205, 50],
            handles: &[
                (&[17], By([0.0, 3.8, 2.6])), (&[16], By([0.0, 3.2, 3.6])), (&[15], By([0.0, 2.4, 3.6])), (&[14], By([0.0, 1.6, 3.2])),
                (&[84], By([0.0, 3.7, 2.5])), (&[85], By([0.0, 3.1, 3.4])), (&[86], By([0.0, 2.3, 3.4])), (&[87], By([0.0, 1.6, 3.0])),
                (&[181], By([0.0, 3.0, 2.0])), (&[180], By([0.0, 2.5, 2.7])), (&[179], By([0.0, 1.9, 2.7])), (&[178], By([0.0, 1.3, 2.4])),
                (&[91], By([0.0, 1.8, 1.3])), (&[90], By([0.0, 1.5, 1.6])), (&[89], By([0.0, 1.1, 1.6])), (&[88], By([0.0, 0.8, 1.4])),
                (&[146], By([0.0, 0.4, 0.5])), (CORNER, By([0.0, -0.8, 0.0])),
                (&[18, 83], By([0.0, 4.2, 0.6])), (&[200, 201], By([0.0, 4.0, 0.4])), (&[199, 208], By([0.0, 3.2, 0.8])), (&[175, 171], By([0.0, 2.2, 0.8])), (&[152, 148], By([0.0, 1.4, 0.3])),
            ],
        },
        MouthShrugUpper => Definition {
            sized_by: EyeDistance, extent: Both, follow: UPPER_LIP, pins: &[61, 76, 62, 78],
            handles: &[
                (&[0, 37], By([0.0, 3.0, 1.6])), (&[11, 72], By([0.0, 2.8, 2.6])), (&[12, 38], By([0.0, 2.2, 3.2])), (&[13, 82], By([0.0, 1.6, 3.2])),
                (&[39], By([0.0, 2.4, 1.3])), (&[73], By([0.0, 2.2, 2.0])), (&[41], By([0.0, 1.7, 2.4])), (&[81], By([0.0, 1.2, 2.4])),
                (&[40], By([0.0, 1.3, 0.8])), (&[74], By([0.0, 1.2, 1.2])), (&[42], By([0.0, 0.9, 1.4])), (&[80], By([0.0, 0.7, 1.4])),
                (&[185, 184, 183, 191], By([0.0, 0.4, 0.4])),
            ],
        },
        MouthPressRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: MOUTH, pins: &[152, 101, 142, 100, 120, 121, 147, 36, 18],
            handles: &[
                (&[0], By([0.0, -0.6, -0.3])), (&[17], By([0.0, 0.6, -0.3])), (&[13, 14, 12, 15, 11, 16], By([0.0, 0.0, -0.5])),
                (&[37], By([0.0, -1.6, -0.8])), (&[72], By([0.0, -1.0, -1.2])), (&[38, 82], By([0.0, -0.2, -1.4])),
                (&[39], By([-0.2, -2.0, -1.0])), (&[73], By([-0.2, -1.2, -1.5])), (&[41, 81], By([-0.2, -0.2, -1.8])),
                (&[40], By([-0.6, -1.6, -1.0])), (&[74], By([-0.6, -0.9, -1.5])), (&[42, 80], By([-0.6, -0.1, -1.8])),
                (&[185], By([-1.2, -0.4, -1.2])), (&[184, 183, 191], By([-1.2, 0.2, -1.4])),
                (CORNER, By([-1.8, 0.6, -1.6])), (&[57], By([-1.4, 0.6, -0.8])),
                (&[84], By([0.0, 1.8, -0.8])), (&[85], By([0.0, 1.2, -1.2])), (&[86, 87], By([0.0, 0.2, -1.4])),
                (&[181], By([-0.2, 2.2, -1.0])), (&[180], By([-0.2, 1.4, -1.5])), (&[179, 178], By([-0.2, 0.3, -1.8])),
                (&[91], By([-0.6, 1.8, -1.0])), (&[90], By([-0.6, 1.2, -1.5])), (&[89, 88], By([-0.6, 0.3, -1.8])),
                (&[146], By([-1.2, 1.2, -1.2])), (&[77, 96, 95], By([-1.2, 0.6, -1.4])),
            ],
        },
        MouthLowerDownRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: LOWER_LIP, pins: &[152, 148, 176, 216, 206, 203, 186],
            handles: &[
                (LOW[0], By([0.0, -2.6, 0.4])), (LOW[1], By([-0.5, -4.8, 0.6])), (LOW[2], By([-1.0, -6.0, 0.6])), (LOW[3], By([-1.3, -5.2, 0.2])), (LOW[4], By([-1.2, -3.0, -0.4])),
                (CORNER, By([-1.0, -0.9, -0.6])), (&[83], By([-0.3, -3.4, 0.6])), (&[182], By([-0.8, -4.2, 0.8])), (&[18], By([0.0, -1.8, 0.5])), (&[106], By([-1.0, -4.0, 0.6])),
            ],
        },
        MouthUpperUpRight => Definition {
            sized_by: EyeDistance, extent: Half, follow: &[Area::UpperLip, Area::MouthCorner, Area::Philtrum, Area::SmileLine, Area::Cheek, Area::NoseWing], pins: &[4, 44, 125, 131, 48, 115, 219, 235, 220, 218, 57, 43, 202, 212, 187, 147, 120, 121, 100],
            handles: &[
                (UP[0], By([0.0, 2.2, 0.3])), (UP[1], By([-0.3, 4.4, 0.4])), (UP[2], By([-0.6, 5.4, 0.4])), (UP[3], By([-0.8, 4.6, 0.2])), (UP[4], By([-0.8, 2.6, -0.2])),
                (CORNER, By([-0.6, 0.8, -0.4])), (&[167], By([-0.2, 3.4, 0.4])), (&[165], By([-0.5, 4.0, 0.8])), (&[92], By([-0.8, 4.0, 1.0])), (&[164], By([0.0, 1.6, 0.2])),
                (&[203], By([-0.6, 3.0, 1.0])), (&[206], By([-0.8, 3.2, 1.2])), (&[129, 102, 64], By([-0.4, 1.2, 0.2])), (&[36], By([-0.2, 2.2, 1.0])),
            ],
        },
        BrowDownRight => Definition {
            sized_by: FaceWidth, extent: Half, follow: BROW, pins: &[10, 109, 67, 103, 54, 21, 162, 127, 34, 139],
            handles: &[
                (&[55, 107], By([2.2, -5.2, 1.4])), (&[65, 66], By([1.6, -5.0, 1.2])), (&[52, 105], By([0.8, -3.8, 0.8])), (&[53, 63], By([0.2, -2.2, 0.3])), (&[46, 70], By([0.0, -0.9, 0.0])),
                (&[9], By([0.0, -1.8, 0.6])), (&[8], By([0.0, -1.5, 0.6])), (&[189], By([0.5, -1.6, 0.4])), (&[221], By([0.5, -2.6, 0.8])), (&[222], By([0.4, -2.8, 0.6])), (&[223], By([0.2, -2.2, 0.4])),
            ],
        },
        BrowInnerUp => Definition {
            sized_by: FaceWidth, extent: Both, follow: BROW, pins: &[10, 109, 67, 103, 54, 21, 162, 127, 34, 139, 113, 124, 156, 143],
            handles: &[
                (&[55, 107], By([0.6, 6.8, -0.4])), (&[65, 66], By([0.3, 5.0, -0.6])), (&[52, 105], By([0.0, 2.2, -0.4])), (&[53, 63], By([0.0, 0.4, 0.0])), (&[46, 70], By([0.0, 0.0, 0.0])),
                (&[9], By([0.0, 4.8, 0.2])), (&[8], By([0.0, 3.0, 0.2])), (&[108], By([0.0, 4.2, 0.0])), (&[151], By([0.0, 3.6, 0.0])), (&[221], By([0.2, 2.2, 0.0])), (&[189], By([0.0, 1.0, 0.0])),
            ],
        },
        BrowOuterUpRight => Definition {
            sized_by: FaceWidth, extent: Half, follow: BROW, pins: &[10, 109, 151, 9, 8, 162, 127, 34, 189],
            handles: &[
                (&[46, 70], By([0.0, 4.2, -0.8])), (&[53, 63], By([0.0, 6.6, -1.2])), (&[52, 105], By([0.0, 5.8, -1.0])), (&[65, 66], By([0.0, 2.6, -0.5])), (&[55, 107], By([0.0, 0.5, 0.0])),
                (&[104, 68], By([0.0, 3.8, -0.8])), (&[69], By([0.0, 2.4, -0.4])), (&[224, 223], By([0.0, 2.2, -0.2])), (&[225], By([0.0, 1.8, -0.2])), (&[222], By([0.0, 1.2, 0.0])),
            ],
        },
        CheekPuff => Definition {
            sized_by: FaceWidth, extent: Both, follow: &[Area::Cheek, Area::SmileLine, Area::Cheekbone, Area::Jaw, Area::ChinCrease, Area::MouthCorner, Area::UpperLip, Area::LowerLip, Area::Philtrum, Area::SideOfFace], pins: &[234, 93, 132, 58, 172, 136, 150, 149, 120, 121, 100, 142, 116, 111, 117, 118, 119, 227, 123],
            handles: &[
                (&[207], By([-6.0, 0.0, 6.0])), (&[187], By([-7.0, 0.0, 6.0])), (&[205], By([-3.5, 0.0, 5.0])), (&[216], By([-5.0, 0.0, 6.0])), (&[212], By([-5.0, 0.0, 5.6])), (&[214], By([-7.0, 0.0, 6.0])), (&[192], By([-7.0, 0.0, 4.6])),
                (&[210], By([-4.6, -1.0, 4.4])), (&[202], By([-3.4, -0.6, 4.2])), (&[206], By([-3.4, 0.4, 4.6])),
                (&[61, 76, 62, 78], By([0.6, 0.0, 1.2])), (&[17, 16, 15, 14, 0, 11, 12, 13], By([0.0, 0.0, 0.8])), (&[164], By([0.0, 0.6, 1.6])), (&[92], By([-1.0, 0.6, 3.4])), (&[18], By([0.0, -0.4, 1.4])), (&[204, 106], By([-1.6, -0.6, 3.0])),
            ],
        },
        CheekSquintRight => Definition {
            sized_by: FaceWidth, extent: Half, follow: &[Area::Cheek, Area::SmileLine, Area::Cheekbone, Area::UnderEye, Area::LowerEyelid], pins: &[33, 133, 130, 243, 7, 155, 57, 43, 202, 212, 186, 226, 35, 244, 233, 147, 187, 227, 116],
            handles: &[
                (&[50], By([-0.2, 5.5, 2.5])), (&[101, 36], By([0.0, 5.2, 2.2])), (&[205], By([-0.5, 4.2, 2.2])), (&[117], By([-0.2, 4.2, 1.8])), (&[118], By([0.0, 4.8, 2.0])), (&[119], By([0.0, 4.0, 1.5])),
                (&[228, 229, 230, 231], By([0.0, 3.2, 1.5])), (&[110, 24, 23, 22], By([0.0, 2.2, 0.6])), (&[163, 144, 145, 153, 154], By([0.0, 1.8, 0.2])),
            ],
        },
        NoseSneerRight => Definition {
            sized_by: FaceWidth, extent: Half, follow: &[Area::NoseWing, Area::Nostril, Area::NoseSide, Area::NoseBridge, Area::Cheek, Area::SmileLine, Area::Philtrum, Area::UpperLip, Area::UnderEye], pins: &[4, 1, 19, 2, 94, 168, 6, 197, 195, 0, 11, 12, 13, 57, 43, 202, 212, 187, 147, 207, 228, 229, 230, 226, 35, 31, 186, 191, 183, 184, 185],
            handles: &[
                (&[129, 102, 64], By([-1.4, 5.9, 0.3])), (&[98, 49], By([-1.1, 4.9, 0.3])), (&[48, 131], By([-0.7, 4.1, 0.3])), (&[209, 126], By([-0.5, 4.6, 1.4])), (&[142], By([-0.4, 4.9, 1.9])), (&[36], By([-0.5, 3.8, 1.6])),
                (&[203], By([-1.4, 5.7, 1.6])), (&[206], By([-1.1, 3.8, 1.4])), (&[165], By([-0.4, 3.2, 0.8])), (&[92], By([-0.8, 3.2, 1.1])), (&[39, 40], By([-0.4, 2.2, 0.4])), (&[37], By([-0.1, 1.2, 0.1])), (&[121, 114], By([0.3, 2.2, 1.2])),
            ],
        },
        EyeBlinkLeft | EyeSquintLeft | EyeWideLeft | JawLeft | MouthLeft | MouthSmileLeft | MouthFrownLeft | MouthDimpleLeft | MouthStretchLeft | MouthPressLeft
        | MouthLowerDownLeft | MouthUpperUpLeft | BrowDownLeft | BrowOuterUpLeft | CheekSquintLeft | NoseSneerLeft => {
            unreachable!("invariant: expressions of the left use the definition of the right")
        }
    }
}
