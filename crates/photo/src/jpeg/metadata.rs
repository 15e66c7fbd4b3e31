//! Metadata from application segments.

#[derive(Default)]
pub(crate) struct Metadata<'a> {
    pub(crate) jfif: bool,
    /// Colour transform of Adobe's segment.
    pub(crate) adobe: Option<u8>,
    /// The first EXIF block.
    pub(crate) exif: Option<&'a [u8]>,
    /// Parts of the ICC profile with their sequence numbers.
    profile: Vec<(u8, &'a [u8])>,
}

impl<'a> Metadata<'a> {
    pub(crate) fn read(&mut self, marker: u8, segment: &'a [u8]) {
        match (marker, segment) {
            (0xE0, [b'J', b'F', b'I', b'F', 0, ..]) => self.jfif = true,
            (0xE1, [b'E', b'x', b'i', b'f', 0, _, block @ ..]) if self.exif.is_none() => self.exif = Some(block),
            (0xE2, _) => {
                if let Some([number, _, part @ ..]) = segment.strip_prefix(b"ICC_PROFILE\0") {
                    self.profile.push((*number, part));
                }
            }
            (0xEE, [b'A', b'd', b'o', b'b', b'e', _, _, _, _, _, _, transform, ..]) => self.adobe = Some(*transform),
            _ => {}
        }
    }

    pub(crate) fn profile(mut self) -> Vec<u8> {
        self.profile.sort_by_key(|&(number, _)| number);
        self.profile.iter().flat_map(|&(_, part)| part).copied().collect()
    }
}
