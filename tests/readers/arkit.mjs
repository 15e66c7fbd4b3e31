// The blend shapes by the names that Apple's ARKit gives them (ARFaceAnchor.BlendShapeLocation), without those of what a face mesh
// has no parts for: the tongue and the gaze.

const OF_EITHER_SIDE = [
  "browDown", "browOuterUp", "cheekSquint", "eyeBlink", "eyeSquint", "eyeWide", "mouthDimple", "mouthFrown", "mouthLowerDown",
  "mouthPress", "mouthSmile", "mouthStretch", "mouthUpperUp", "noseSneer", "jaw", "mouth",
];
const OF_THE_MIDDLE = [
  "browInnerUp", "cheekPuff", "jawForward", "jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthRollLower",
  "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper",
];

/** The names, in no order. */
export const BLEND_SHAPES = [...OF_EITHER_SIDE.flatMap((name) => [`${name}Left`, `${name}Right`]), ...OF_THE_MIDDLE];
