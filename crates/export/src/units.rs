/// Millimetres in a metre.
pub const MM_PER_M: f64 = 1000.0;

rosto_mesh::named! {
    /// The coordinates that edits are made in, and that JSON is written in.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Units {
        /// MediaPipe's normalised coordinates.
        Image = "image",
        /// Millimetres of the model.
        Mm = "mm",
    }
}

impl Units {
    /// How many of these make one unit of the document: normalised coordinates stay, millimetres become metres.
    pub fn per_document_unit(self) -> f64 {
        match self {
            Self::Image => 1.0,
            Self::Mm => MM_PER_M,
        }
    }
}
