use thiserror::Error;

/// Reason why landmarks could not be modelled as a face.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FaceError {
    /// The number of landmarks or colours is wrong.
    #[error("expected {expected} {what}, found {found}")]
    WrongCount {
        /// "landmarks" or "colours".
        what: &'static str,
        /// Required number.
        expected: usize,
        /// Number passed.
        found: usize,
    },
    /// A coordinate is infinite or NaN.
    #[error("landmark {landmark} has a coordinate that is not a finite number")]
    NotFinite {
        /// Index of the landmark.
        landmark: usize,
    },
    /// A landmark is far outside the picture, or the face is smaller than a pixel.
    #[error("the landmarks do not form a face: they are far outside the picture, or within less than a pixel")]
    Implausible,
    /// The landmarks are too far from those of any face.
    #[error(
        "the landmarks are not a face: they deviate from the average face by {deviation_mm:.0} mm, and the limit is \
        {most_mm} mm"
    )]
    NotAFace {
        /// Root mean square distance from the canonical face, in mm of its size.
        deviation_mm: f64,
        /// Limit of that distance.
        most_mm: f64,
    },
    /// The surface through the landmarks is folded.
    #[error(
        "the landmarks are not a face: {inside_out_per_cent:.0} % of their surface is inside out, and the limit is \
        {most_per_cent} %"
    )]
    Folded {
        /// Share of the surface that faces backwards, in per cent.
        inside_out_per_cent: f64,
        /// Limit of that share.
        most_per_cent: f64,
    },
    /// The bytes of an observation have another version.
    #[error("the stored face has version {found}, but this Rosto reads only version {known}")]
    RecordVersion {
        /// Version of the bytes.
        found: u8,
        /// Supported version.
        known: u8,
    },
    /// The bytes of an observation are incomplete or damaged.
    #[error("the stored face is damaged ({bytes} bytes)")]
    Record {
        /// Number of bytes passed.
        bytes: usize,
    },
    /// The picture in which the landmarks were found has no area.
    #[error("the picture is {width}×{height} px, so it has no area")]
    EmptyPicture {
        /// Width in px.
        width: u32,
        /// Height in px.
        height: u32,
    },
    /// The lens data cannot be parsed or are out of range.
    #[error("{lens:?} is not a lens; use estimated, parallel, exif:MM, given:MM (5 to 2000) or distance:M (0.1 to 20)")]
    Lens {
        /// The lens data as passed.
        lens: String,
    },
    /// Four corners that cannot be those of a bank card.
    #[error(
        "the four corners are not those of a bank card, 85.6 × 54 mm; mark its corners again, or measure without it"
    )]
    NotACard,
    /// All landmarks are collinear or coincide, so the face has no orientation.
    #[error("the landmarks are collinear, so the face has no orientation")]
    Degenerate,
    /// No photos or too many.
    #[error("{found} photos of one face; give 1 to {most}")]
    PhotoCount {
        /// Number of photos passed.
        found: usize,
        /// Largest supported number.
        most: usize,
    },
    /// One of several photos does not show a face that can be modelled.
    #[error("photo {}: {reason}", photo + 1)]
    InPhoto {
        /// Index of the photo, from 0.
        photo: usize,
        /// The error for this photo.
        reason: Box<FaceError>,
    },
    /// One of several photos does not match the others for any camera: it shows another face.
    #[error(
                "photo {} does not match the others: the median reprojection error is {reprojection_px:.1} px, and the limit is \
        {most_px:.1} px; make sure that it shows the same face",
        photo + 1
    )]
    AnotherFace {
        /// Index of the photo, from 0.
        photo: usize,
        /// Median distance in px between the landmarks and the reprojected shape.
        reprojection_px: f64,
        /// Limit of that distance.
        most_px: f64,
    },
}
