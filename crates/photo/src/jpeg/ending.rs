//! How much of a JPEG file is there, told by its markers.

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
    /// Without it.
    Unmarked {
        /// The scan that it ends in, if no other need come behind it.
        last_scan: Option<LastScan<'a>>,
        /// The file up to the end of the scan before, if only refinements come behind it: of each coefficient of the
        /// picture, all bits but at most the last one are there.
        nearly_all: Option<&'a [u8]>,
    },
}

/// The scan that a file ends in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LastScan<'a> {
    /// The file without what was filled up behind it.
    pub(crate) scanned: &'a [u8],
    /// How many restart markers this scan has so far.
    restarts: u8,
}

pub(crate) fn ending(bytes: &[u8]) -> Ending<'_> {
    let (mut position, mut scans, mut nearly_all) = (0, Scans::default(), None);
    while let Some((marker, after)) = next_marker(bytes, position) {
        if scans.could_be_nearly_all() {
            nearly_all = bytes.get(..after - 2);
        }
        position = match marker {
            END_OF_IMAGE => return Ending::Marked,
            START_OF_IMAGE => after,
            _ => {
                after
                    + bytes
                        .get(after..)
                        .and_then(<[u8]>::first_chunk)
                        .map_or(2, |&length| usize::from(u16::from_be_bytes(length)))
            }
        };
        let Some(segment) = bytes.get(after..position) else { return Ending::Unmarked { last_scan: None, nearly_all } };
        scans.see(marker, segment);
    }
    Ending::Unmarked { last_scan: if scans.could_be_all() { LastScan::new(bytes, position) } else { None }, nearly_all }
}

impl<'a> LastScan<'a> {
    /// What of a file is scanned by a scan that begins at `start`.
    fn new(bytes: &'a [u8], start: usize) -> Option<Self> {
        let scanned = without_padding(bytes);
        let markers =
            scanned.get(start..)?.windows(2).filter(|two| two[0] == FILL && RESTART.contains(&two[1])).count();
        Some(Self { scanned, restarts: (markers % 8) as u8 })
    }

    /// What may be put behind it to see how much of it is there: bits that differ from the first on, and the same behind
    /// the restart marker that would come next.
    pub(crate) fn tails(&self) -> Vec<Vec<u8>> {
        const BITS: [[u8; 6]; 3] = [
            [0x55, 0x33, 0x5A, 0x0F, 0x66, 0x3C],
            [0xAA, 0xCC, 0xA5, 0xF0, 0x99, 0xC3],
            [0x12, 0x9D, 0x74, 0xE8, 0x2B, 0xB1],
        ];
        let restart = [FILL, RESTART.start() + self.restarts];
        let behind = |marker: &[u8], bits: [u8; 6]| [marker, bits.repeat(16).as_slice()].concat();
        BITS.iter().flat_map(|&bits| [behind(&[], bits), behind(&restart, bits)]).collect()
    }
}

/// What the scans so far have told of the picture.
#[derive(Default)]
struct Scans {
    progressive: bool,
    components: Vec<Component>,
    scanning: bool,
}

/// Which of a component's 64 coefficients are there, a bit for each.
#[derive(Default)]
struct Component {
    name: u8,
    /// To the last bit.
    whole: u64,
    /// To the last bit or the last but one; none in a picture that has no refinements.
    nearly_whole: u64,
}

impl Scans {
    /// Takes note of a segment (its two bytes of length included).
    fn see(&mut self, marker: u8, segment: &[u8]) {
        self.scanning = marker == START_OF_SCAN;
        match marker {
            0xC0..=PROGRESSIVE => {
                self.progressive = marker == PROGRESSIVE;
                let names = segment.get(8..).unwrap_or_default().as_chunks::<3>().0;
                self.components = names.iter().map(|&[name, ..]| Component { name, ..Component::default() }).collect();
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
        let (told, missing_bits) = match self.progressive {
            false => (u64::MAX, 0),
            true if first <= last && last < 64 => ((u64::MAX >> (63 - (last - first))) << first, bits & 0x0F),
            true => (0, 0),
        };
        let is_told =
            |component: &&mut Component| names.as_chunks::<2>().0.iter().any(|[name, _]| *name == component.name);
        for component in self.components.iter_mut().filter(is_told) {
            component.whole |= if missing_bits == 0 { told } else { 0 };
            component.nearly_whole |= if self.progressive && missing_bits <= 1 { told } else { 0 };
        }
    }

    /// Whether there need not be another scan behind this one.
    fn could_be_all(&self) -> bool {
        self.scanning && self.all(|component| component.whole == u64::MAX)
    }

    /// Whether the scans so far show all but the last bits of the picture.
    fn could_be_nearly_all(&self) -> bool {
        self.all(|component| component.nearly_whole == u64::MAX)
    }

    fn all(&self, is_there: impl Fn(&Component) -> bool) -> bool {
        !self.components.is_empty() && self.components.iter().all(is_there)
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
