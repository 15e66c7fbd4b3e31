use crate::region_of_interest::RegionOfInterest;

/// One face in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Detector score, 0.5..1.
    pub score: f32,
    /// Face flag of the landmark network, 0.5..1.
    pub presence: f32,
    /// Confidence that this is a face with correct landmarks, 0..1.
    ///
    /// With [`Search::Once`](crate::Search::Once), the presence. With [`Search::Thorough`](crate::Search::Thorough),
    /// above 0.7: the product of weights for the presence, the agreement of the last two passes, the detector's score
    /// on a close-up, the distance between the detector's key points and the mesh, and the score's advantage over an
    /// upside-down face.
    pub confidence: f32,
    /// 468 points in MediaPipe's normalised convention: x/W, y/H, z/W. y points down, smaller z is nearer, and the mean
    /// of z is about 0. [`LandmarkNetwork::Attention`](crate::LandmarkNetwork::Attention) appends ten iris points, the
    /// right iris first, each as its centre and four boundary points.
    pub landmarks: Vec<[f32; 3]>,
    /// The region that the landmark network processed.
    pub region: RegionOfInterest,
}

/// Confidences below which a face is doubtful, and very doubtful. Cloth and photos without people reach 0.88.
const DOUBTFUL_BELOW: [f32; 2] = [0.9, 0.8];

impl Face {
    /// Whether the confidence is below 0.9. Warn the user that the result may not be a face.
    pub fn is_doubtful(&self) -> bool {
        self.doubt() > 0
    }

    /// Rank of the doubt, from 0 (certain) to 2 (very doubtful).
    pub(crate) fn doubt(&self) -> usize {
        DOUBTFUL_BELOW.iter().filter(|&&limit| self.confidence < limit).count()
    }
}
