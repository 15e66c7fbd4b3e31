//! Iterator over a file's markers and their segments (ITU-T T.81, B.1.1).

pub(crate) const END: u8 = 0xD9;
pub(crate) const SCAN: u8 = 0xDA;

pub(crate) struct Segments<'a> {
    pub(crate) bytes: &'a [u8],
    /// Position from which the next marker is searched.
    pub(crate) position: usize,
}

impl<'a> Iterator for Segments<'a> {
    type Item = (u8, &'a [u8]);

    /// Returns the next marker's code, and its segment without the length. Ends at the end of the file, even within a
    /// segment.
    fn next(&mut self) -> Option<Self::Item> {
        loop {
            self.position += self.bytes.get(self.position..)?.iter().position(|&byte| byte == 0xFF)? + 1;
            match *self.bytes.get(self.position)? {
                0xFF => {}
                // Not a marker, or one without a segment.
                0 | 1 | 0xD0..=0xD8 => self.position += 1,
                END => return Some((END, &[])),
                code => {
                    let start = self.position + 1;
                    let length = u16::from_be_bytes(*self.bytes.get(start..)?.first_chunk()?);
                    self.position = start + usize::from(length.max(2));
                    return Some((code, self.bytes.get(start + 2..self.position)?));
                }
            }
        }
    }
}
