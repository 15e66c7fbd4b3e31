//! Whether a JPEG file is whole.
//!
//! The decoder fills what is missing with grey and calls it a success, as browsers do; half a face is no use here.

const STUFFED_ZERO: u8 = 0x00;
const RESTART: std::ops::RangeInclusive<u8> = 0xD0..=0xD7;
const START_OF_IMAGE: u8 = 0xD8;
const END_OF_IMAGE: u8 = 0xD9;
const START_OF_SCAN: u8 = 0xDA;
const PROGRESSIVE: u8 = 0xC2;
const FILL: u8 = 0xFF;

/// The end-of-image marker.
pub(crate) const END: [u8; 2] = [FILL, END_OF_IMAGE];

/// How a file ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ending<'a> {
    /// With the end-of-image marker where it counts: after the scans, not inside an embedded thumbnail.
    Marked,
    /// Without it, in what may be the last scan.
    InLastScan {
        /// The file without what was filled up behind it.
        scanned: &'a [u8],
        /// How many restart markers that scan has so far.
        restarts: u8,
    },
    /// Before what may be the last scan.
    TooEarly,
}

pub(crate) fn ending(bytes: &[u8]) -> Ending<'_> {
    let (mut position, mut scans) = (0, Scans::default());
    while let Some((marker, after)) = next_marker(bytes, position) {
        position = match marker {
            END_OF_IMAGE => return Ending::Marked,
            START_OF_IMAGE => after,
            _ => match bytes.get(after..after + 2) {
                Some(length) => after + usize::from(u16::from_be_bytes([length[0], length[1]])),
                None => return Ending::TooEarly,
            },
        };
        let Some(segment) = bytes.get(after..position) else { return Ending::TooEarly };
        scans.see(marker, segment);
    }
    if !scans.could_be_all() {
        return Ending::TooEarly;
    }
    let scanned = without_padding(bytes);
    let Some(scan) = scanned.get(position..) else { return Ending::TooEarly };
    let markers = scan.windows(2).filter(|two| two[0] == FILL && RESTART.contains(&two[1])).count();
    Ending::InLastScan { scanned, restarts: (markers % 8) as u8 }
}

/// What may be put behind a scan to see whether it is whole: bits that differ from the first on, the same behind the
/// restart marker that would come next.
pub(crate) fn tails(restarts: u8) -> Vec<Vec<u8>> {
    const BITS: [[u8; 6]; 3] = [
        [0x55, 0x33, 0x5A, 0x0F, 0x66, 0x3C],
        [0xAA, 0xCC, 0xA5, 0xF0, 0x99, 0xC3],
        [0x12, 0x9D, 0x74, 0xE8, 0x2B, 0xB1],
    ];
    let restart = [FILL, RESTART.start() + restarts];
    let behind = |marker: &[u8], bits: [u8; 6]| [marker, bits.repeat(16).as_slice()].concat();
    BITS.iter().flat_map(|&bits| [behind(&[], bits), behind(&restart, bits)]).collect()
}

/// What the scans so far have told of the picture.
#[derive(Default)]
struct Scans {
    progressive: bool,
    /// Each component's name, and which of its 64 coefficients are there to the last bit.
    components: Vec<(u8, u64)>,
    scanning: bool,
}

impl Scans {
    /// Takes note of a segment (its two bytes of length included).
    fn see(&mut self, marker: u8, segment: &[u8]) {
        self.scanning = marker == START_OF_SCAN;
        match marker {
            0xC0..=PROGRESSIVE => {
                self.progressive = marker == PROGRESSIVE;
                let names = segment.get(8..).unwrap_or_default().as_chunks::<3>().0;
                self.components = names.iter().map(|component| (component[0], 0)).collect();
            }
            START_OF_SCAN => self.see_scan(segment),
            _ => {}
        }
    }

    fn see_scan(&mut self, segment: &[u8]) {
        let count = usize::from(segment.get(2).copied().unwrap_or_default());
        let Some(names) = segment.get(3..3 + 2 * count) else { return };
        let Some(&[first, last, bits]) = segment.get(3 + 2 * count..).and_then(|rest| rest.first_chunk()) else {
            return;
        };
        let told = match self.progressive {
            false => u64::MAX,
            true if bits & 0x0F == 0 && first <= last && last < 64 => (u64::MAX >> (63 - (last - first))) << first,
            true => 0,
        };
        for &[name, _] in names.as_chunks::<2>().0 {
            self.components
                .iter_mut()
                .filter(|component| component.0 == name)
                .for_each(|component| component.1 |= told);
        }
    }

    /// Whether there need not be another scan.
    fn could_be_all(&self) -> bool {
        self.scanning && !self.components.is_empty() && self.components.iter().all(|component| component.1 == u64::MAX)
    }
}

/// Without zeros that a copy was filled up with, and without half a marker.
fn without_padding(bytes: &[u8]) -> &[u8] {
    /// A scan may end with a zero, but hardly with so many.
    const PADDING: usize = 16;
    let end = bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    let bytes = if bytes.len() - end >= PADDING { &bytes[..end] } else { bytes };
    let end = bytes.iter().rposition(|&byte| byte != FILL).map_or(0, |last| last + 1);
    &bytes[..end]
}

/// The next marker at or after `position` and the position behind it, past any entropy-coded data.
fn next_marker(bytes: &[u8], mut position: usize) -> Option<(u8, usize)> {
    loop {
        position += bytes.get(position..)?.iter().position(|&byte| byte == 0xFF)? + 1;
        match *bytes.get(position)? {
            FILL => {}
            STUFFED_ZERO => position += 1,
            restart if RESTART.contains(&restart) => position += 1,
            marker => return Some((marker, position + 1)),
        }
    }
}
