use crate::region_of_interest::RegionOfInterest;

/// One face in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The detector's, 0.5..1.
    pub score: f32,
    /// The landmark network's, 0.5..1.
    pub presence: f32,
    /// How sure it is that this is a face and that the landmarks lie on it: of [`Search::Once`](crate::Search::Once), the
    /// presence alone; of [`Search::Thorough`](crate::Search::Thorough), above 0.7, a product of weights for the presence, for
    /// how well the last two passes agree, for how sure the detector is from near, for how well its eyes, nose and mouth agree
    /// with those of the mesh, and for how much more a face the right way up it is to the detector than one on its head.
    pub confidence: f32,
    /// 468 points in MediaPipe's normalised convention: x/W, y/H, z/W; y points down, smaller z is nearer, z is about 0
    /// in the mean. With [`LandmarkNetwork::Attention`](crate::LandmarkNetwork::Attention) 478: ten of the irises follow, the
    /// right one first, each its middle and four points of its border.
    pub landmarks: Vec<[f32; 3]>,
    /// Where the landmark network looked.
    pub region: RegionOfInterest,
}

/// Faces below 0.8 come after those above, and those below 0.9 after the rest, however prominent. Cloth and photos without
/// people reach 0.88.
const DOUBTFUL_BELOW: [f32; 2] = [0.9, 0.8];

impl Face {
    /// Whether its confidence is so low (below 0.9) that people should be told that it may not be a face.
    pub fn is_doubtful(&self) -> bool {
        self.doubt() > 0
    }

    /// From 0, certain, to 2, most doubtful.
    pub(crate) fn doubt(&self) -> usize {
        DOUBTFUL_BELOW.iter().filter(|&&limit| self.confidence < limit).count()
    }
}
