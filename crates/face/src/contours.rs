/// Outline of the face: 36 landmarks, from the top of the forehead down the subject's left side and up the right.
///
/// The boundary of both triangulations, and MediaPipe's `FACEMESH_FACE_OVAL`.
#[rustfmt::skip]
pub const OVAL: [u32; 36] = [
    10, 338, 297, 332, 284, 251, 389, 356, 454, 323, 361, 288, 397, 365, 379, 378, 400, 377,
    152, 148, 176, 149, 150, 136, 172, 58, 132, 93, 234, 127, 162, 21, 54, 103, 67, 109,
];
