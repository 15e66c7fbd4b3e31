//! Bit reader for entropy-coded data (ITU-T T.81, F.2.2.5).

/// Reads bits up to the next marker, then zeros.
#[derive(Clone)]
pub(crate) struct Bits<'a> {
    bytes: &'a [u8],
    /// Position of the next byte to buffer.
    position: usize,
    /// Unread bits, most significant first.
    buffer: u64,
    /// Number of buffered bits.
    count: u32,
    /// Number of buffered zeros that are not in the file.
    padding: u32,
}

/// Kind of data between an interval's last block and the next marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rest {
    /// Ones up to the end of the byte, as encoders pad it.
    Ones,
    /// Too few bits or bytes for a block, or one repeated byte.
    Filler,
    /// Enough bytes for more blocks.
    Data,
}

impl<'a> Bits<'a> {
    pub(crate) fn new(bytes: &'a [u8], position: usize) -> Self {
        Self { bytes, position, buffer: 0, count: 0, padding: 0 }
    }

    /// Whether bits beyond the data were read.
    pub(crate) fn overrun(&self) -> bool {
        self.count < self.padding
    }

    /// Buffers at least 32 bits.
    #[inline(always)]
    pub(crate) fn refill(&mut self) {
        if self.count < 32 {
            self.buffer_word();
        }
    }

    fn buffer_word(&mut self) {
        if let Some(&chunk) = self.bytes.get(self.position..).and_then(<[u8]>::first_chunk::<8>)
            && !has_ff(u64::from_be_bytes(chunk))
            && self.padding == 0
        {
            self.buffer |= u64::from_be_bytes(chunk) >> self.count;
            let bytes = (63 - self.count) / 8;
            self.position += bytes as usize;
            self.count += 8 * bytes;
        } else {
            while self.count <= 56 {
                self.buffer_byte();
            }
        }
    }

    fn buffer_byte(&mut self) {
        let next = |ahead: usize| self.bytes.get(self.position + ahead).copied();
        match (next(0), next(1)) {
            (Some(0xFF), Some(0)) => self.push(0xFF, 2),
            (Some(0xFF), _) | (None, _) => {
                self.padding += 8;
                self.count += 8;
            }
            (Some(byte), _) => self.push(byte, 1),
        }
    }

    fn push(&mut self, byte: u8, length: usize) {
        self.buffer |= u64::from(byte) << (56 - self.count);
        self.count += 8;
        self.position += length;
    }

    /// Peeks at the next 16 bits, which have to be buffered.
    #[inline(always)]
    pub(crate) fn peek(&self) -> u32 {
        (self.buffer >> 48) as u32
    }

    #[inline(always)]
    pub(crate) fn skip(&mut self, count: u32) {
        self.buffer <<= count;
        self.count -= count;
    }

    /// Reads `count` bits, at most 16, which have to be buffered.
    #[inline(always)]
    pub(crate) fn take(&mut self, count: u32) -> u32 {
        let value = (self.buffer >> 1 >> (63 - count)) as u32;
        self.skip(count);
        value
    }

    #[inline(always)]
    pub(crate) fn bit(&mut self) -> bool {
        if self.count == 0 {
            self.refill();
        }
        self.take(1) == 1
    }

    /// Reads and classifies the data before the next marker.
    pub(crate) fn rest(&mut self) -> Rest {
        /// Fewer bytes than one block of each of three components takes.
        const FEW_BYTES: usize = 3;
        self.refill();
        let real = self.count.saturating_sub(self.padding);
        let (odd, ones) = (real % 8, self.buffer >> 1 >> (63 - real % 8) == (1 << (real % 8)) - 1);
        self.skip(odd);
        let (mut first, mut length, mut uniform) = (None, 0, true);
        loop {
            self.refill();
            let byte = self.take(8);
            if self.overrun() {
                break;
            }
            length += 1;
            uniform &= *first.get_or_insert(byte) == byte;
        }
        match length {
            0 if ones => Rest::Ones,
            _ if uniform || length < FEW_BYTES => Rest::Filler,
            _ => Rest::Data,
        }
    }

    /// Position of the next marker's code byte.
    pub(crate) fn next_marker(&self) -> Option<usize> {
        let mut position = self.position;
        loop {
            position += self.bytes.get(position..)?.iter().position(|&byte| byte == 0xFF)? + 1;
            if !matches!(*self.bytes.get(position)?, 0 | 0xFF) {
                return Some(position);
            }
        }
    }
}

fn has_ff(word: u64) -> bool {
    const ONES: u64 = 0x0101_0101_0101_0101;
    (!word).wrapping_sub(ONES) & word & (ONES << 7) != 0
}
