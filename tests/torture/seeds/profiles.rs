/// ICC profiles of three curves and a matrix, as phones write them, with every kind of curve; and one of another kind.
pub fn profiles() -> Vec<Vec<u8>> {
    let display_p3 = [[0.5151, 0.2412, -0.0011], [0.2920, 0.6922, 0.0419], [0.1571, 0.0666, 0.7841]];
    let parametric = |kind: u16, numbers: &[f64]| {
        let head = [b"para".as_slice(), &[0; 4], &kind.to_be_bytes(), &[0; 2]].concat();
        numbers.iter().fold(head, |curve, &number| [curve, fixed(number)].concat())
    };
    let sampled = |samples: &[u16]| {
        let head = [b"curv".as_slice(), &[0; 4], &(samples.len() as u32).to_be_bytes()].concat();
        samples.iter().fold(head, |curve, sample| [curve, sample.to_be_bytes().to_vec()].concat())
    };
    let ramp: Vec<u16> = (0..64).map(|step: u16| step * 1040).collect();
    let curves = [
        parametric(0, &[2.2]),
        parametric(1, &[2.4, 0.9, 0.1]),
        parametric(2, &[2.4, 0.9, 0.1, 0.01]),
        parametric(3, &[2.4, 0.948, 0.052, 0.0774, 0.0405]),
        parametric(4, &[2.4, 0.948, 0.052, 0.0774, 0.0405, 0.01, 0.0]),
        sampled(&[]),
        sampled(&[0x01CD]),
        sampled(&ramp),
    ];
    let rgb = curves.iter().map(|curve| profile(b"RGB XYZ ", &display_p3, curve));
    rgb.chain([profile(b"GRAYLab ", &display_p3, &curves[0])]).collect()
}

/// The header as far as it is read, the table of tags, the tags; the three curves are one.
fn profile(spaces: &[u8; 8], columns: &[[f64; 3]; 3], curve: &[u8]) -> Vec<u8> {
    const TABLE: usize = 132 + 6 * 12;
    let colorants = columns.map(|column| {
        let head = [b"XYZ ".as_slice(), &[0; 4]].concat();
        column.iter().fold(head, |tag, &number| [tag, fixed(number)].concat())
    });
    let curve_at = TABLE + 3 * 20;
    let entry = |signature: &[u8; 4], at: usize, size: usize| {
        [signature.as_slice(), &(at as u32).to_be_bytes(), &(size as u32).to_be_bytes()].concat()
    };
    let tags = [b"rXYZ", b"gXYZ", b"bXYZ"].iter().enumerate().map(|(which, name)| entry(name, TABLE + 20 * which, 20));
    let curves = [b"rTRC", b"gTRC", b"bTRC"].iter().map(|name| entry(name, curve_at, curve.len()));
    let table: Vec<u8> = tags.chain(curves).flatten().collect();
    let total = (curve_at + curve.len()) as u32;
    let mut header = [0; 128];
    header[..4].copy_from_slice(&total.to_be_bytes());
    header[8..12].copy_from_slice(&[4, 0x30, 0, 0]);
    header[12..16].copy_from_slice(b"mntr");
    header[16..24].copy_from_slice(spaces);
    header[36..40].copy_from_slice(b"acsp");
    [&header, 6_u32.to_be_bytes().as_slice(), &table, &colorants.concat(), curve].concat()
}

/// An s15Fixed16 number.
fn fixed(number: f64) -> Vec<u8> {
    ((number * 65_536.0).round() as i32).to_be_bytes().to_vec()
}
