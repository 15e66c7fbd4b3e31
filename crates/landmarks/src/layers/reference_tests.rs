//! Compares each layer with a direct implementation in f64, channels first as in ONNX, on random shapes.

use std::ops::Range;

use super::*;
use crate::seeded::Seeded;

/// A picture stored channels first.
#[derive(Clone)]
struct Planes {
    channels: usize,
    height: usize,
    width: usize,
    numbers: Vec<f64>,
}

impl Planes {
    fn of(shape: [usize; 3], number: impl FnMut() -> f64) -> Self {
        let [channels, height, width] = shape;
        let numbers = std::iter::repeat_with(number).take(channels * height * width).collect();
        Self { channels, height, width, numbers }
    }

    /// The number at a position; `None` outside the picture.
    fn at(&self, channel: usize, y: isize, x: isize) -> Option<f64> {
        let inside = (0..self.height as isize).contains(&y) && (0..self.width as isize).contains(&x);
        inside.then(|| self.numbers[(channel * self.height + y as usize) * self.width + x as usize])
    }

    fn channels_last(&self) -> Vec<f32> {
        let pixels = self.height * self.width;
        let positions = (0..pixels).flat_map(|pixel| (0..self.channels).map(move |channel| channel * pixels + pixel));
        positions.map(|position| self.numbers[position] as f32).collect()
    }

    fn shape(&self) -> [usize; 4] {
        [1, self.height, self.width, self.channels]
    }
}

/// Random numbers that are exact in f32.
fn numbers(seeded: &mut Seeded, count: usize) -> Vec<f64> {
    (0..count).map(|_| f64::from(seeded.signed() as f32)).collect()
}

fn singles(numbers: &[f64]) -> Vec<f32> {
    numbers.iter().map(|&number| number as f32).collect()
}

fn in_range(seeded: &mut Seeded, range: Range<usize>) -> usize {
    range.start + seeded.below(range.len())
}

fn picture_of(seeded: &mut Seeded, channels: usize) -> Planes {
    let extents = [in_range(seeded, 1..14), in_range(seeded, 1..14)];
    Planes::of([channels, extents[0], extents[1]], || f64::from(seeded.signed() as f32))
}

/// A random window that fits the picture, a point, or MediaPipe's 3 × 3 kernel.
fn window_for(seeded: &mut Seeded, picture: &Planes) -> Window {
    loop {
        let mut two = |range: Range<usize>| [in_range(seeded, range.clone()), in_range(seeded, range)];
        let random =
            Window { kernel: two(1..6), strides: two(1..4), dilations: two(1..3), before: two(0..3), after: two(0..3) };
        let usual = Window { kernel: [3; 2], dilations: [1; 2], before: two(0..2), after: [1; 2], strides: two(1..3) };
        let window = [Window::POINT, random, usual.clone(), usual][seeded.below(4)].clone();
        if window.output([picture.height, picture.width]).is_ok() {
            return window;
        }
    }
}

/// `bias + Σ weight · in` over the taps and the input channels of each output channel; `weights[out][in][tap]`.
fn convolved(picture: &Planes, window: &Window, groups: usize, weights: &[f64], biases: &[f64]) -> Planes {
    let [height, width] = window.output([picture.height, picture.width]).unwrap();
    let (taps, channels_in) = (window.kernel[0] * window.kernel[1], picture.channels / groups);
    let mut at = 0..;
    Planes::of([biases.len(), height, width], || {
        let at = at.next().unwrap();
        let (channel, y, x) = (at / (height * width), at / width % height, at % width);
        let first = channel / (biases.len() / groups) * channels_in;
        let products = (0..channels_in * taps).map(|term| {
            let (input, tap) = (term / taps, term % taps);
            let pixel = |axis: usize, position: usize, tap: usize| {
                (position * window.strides[axis] + tap * window.dilations[axis]) as isize - window.before[axis] as isize
            };
            let (row, column) = (pixel(0, y, tap / window.kernel[1]), pixel(1, x, tap % window.kernel[1]));
            weights[channel * channels_in * taps + term] * picture.at(first + input, row, column).unwrap_or(0.0)
        });
        biases[channel] + products.sum::<f64>()
    })
}

/// Adds a picture with as many or fewer channels, then applies the activation.
fn activated_sum(mut sums: Planes, skip: Option<&Planes>, slopes: &[f64]) -> Planes {
    let pixels = sums.height * sums.width;
    for (at, sum) in sums.numbers.iter_mut().enumerate() {
        *sum += skip.and_then(|skip| skip.numbers.get(at)).unwrap_or(&0.0);
        *sum *= if *sum < 0.0 { slopes[at / pixels] } else { 1.0 };
    }
    sums
}

fn output_of(layer: &impl Layer, inputs: &[&Planes]) -> (Vec<usize>, Vec<f32>) {
    let numbers: Vec<Vec<f32>> = inputs.iter().map(|input| input.channels_last()).collect();
    let shapes: Vec<[usize; 4]> = inputs.iter().map(|input| input.shape()).collect();
    let values: Vec<Value<'_>> = shapes.iter().zip(&numbers).map(|(shape, numbers)| Value { shape, numbers }).collect();
    run(layer, &values)
}

fn run(layer: &impl Layer, inputs: &[Value<'_>]) -> (Vec<usize>, Vec<f32>) {
    let shape = layer.output_shape(&inputs.iter().map(|input| input.shape).collect::<Vec<_>>()).unwrap();
    let mut output = vec![0.0; shape.iter().product()];
    layer.run(inputs, &shape, &mut output);
    (shape.to_vec(), output)
}

fn assert_is(layer: &impl Layer, inputs: &[&Planes], expected: &Planes, case: &str) {
    let (shape, found) = output_of(layer, inputs);
    assert_eq!(shape, expected.shape(), "{case}");
    let magnitude = expected.numbers.iter().fold(1.0_f64, |largest, number| largest.max(number.abs()));
    for (found, expected) in found.iter().zip(expected.channels_last()) {
        assert!(f64::from(found - expected).abs() < 1e-5 * magnitude, "{case}: {found}, expected {expected}");
    }
}

fn depthwise(window: &Window, weights: &[f64], biases: &[f64]) -> Depthwise {
    let taps = window.kernel[0] * window.kernel[1];
    Depthwise::new(window.clone(), &singles(biases), |channel, tap| weights[channel * taps + tap] as f32)
}

fn convolution(window: &Window, channels_in: usize, weights: &[f64], biases: &[f64], slopes: &[f64]) -> Convolution {
    let depth = window.kernel[0] * window.kernel[1] * channels_in;
    let dense = Dense::new(&singles(biases), depth, |channel, input| {
        let (tap, input) = (input / channels_in, input % channels_in);
        weights[(channel * channels_in + input) * (depth / channels_in) + tap] as f32
    });
    let dense = dense.with_slopes(&singles(slopes));
    Convolution { depthwise: None, window: window.clone(), channels_in, dense }
}

const CASES: u64 = 300;

#[test]
fn convolution_matches_its_definition() {
    for seed in 0..CASES {
        let mut seeded = Seeded::new(seed);
        let (channels_in, channels) = (in_range(&mut seeded, 1..12), in_range(&mut seeded, 1..28));
        let picture = picture_of(&mut seeded, channels_in);
        let window = window_for(&mut seeded, &picture);
        let weights = numbers(&mut seeded, channels * channels_in * window.kernel[0] * window.kernel[1]);
        let (biases, slopes) = (numbers(&mut seeded, channels), numbers(&mut seeded, channels));
        let sums = convolved(&picture, &window, 1, &weights, &biases);
        let skip_shape = [in_range(&mut seeded, 1..channels + 1), sums.height, sums.width];
        let skip = Planes::of(skip_shape, || f64::from(seeded.signed() as f32));
        let layer = convolution(&window, channels_in, &weights, &biases, &slopes);
        let case = format!("seed {seed}: {channels_in} to {channels} channels, {window:?}");
        assert_is(&layer, &[&picture], &activated_sum(sums.clone(), None, &slopes), &case);
        assert_is(&layer, &[&picture, &skip], &activated_sum(sums, Some(&skip), &slopes), &case);
    }
}

#[test]
fn depthwise_convolution_matches_its_definition() {
    for seed in 0..CASES {
        let mut seeded = Seeded::new(seed);
        let channels = in_range(&mut seeded, 1..20);
        let picture = picture_of(&mut seeded, channels);
        let window = window_for(&mut seeded, &picture);
        let weights = numbers(&mut seeded, channels * window.kernel[0] * window.kernel[1]);
        let (biases, slopes) = (numbers(&mut seeded, channels), numbers(&mut seeded, channels));
        let layer = depthwise(&window, &weights, &biases).with_slopes(&singles(&slopes));
        let sums = convolved(&picture, &window, channels, &weights, &biases);
        let case = format!("seed {seed}: {channels} channels, {window:?}");
        assert_is(&layer, &[&picture], &activated_sum(sums, None, &slopes), &case);
    }
}

#[test]
fn fused_convolutions_match_separate_ones() {
    for seed in 0..CASES {
        let mut seeded = Seeded::new(seed);
        let (channels_in, channels) = (in_range(&mut seeded, 1..12), in_range(&mut seeded, 1..28));
        let picture = picture_of(&mut seeded, channels_in);
        let window = window_for(&mut seeded, &picture);
        let first_weights = numbers(&mut seeded, channels_in * window.kernel[0] * window.kernel[1]);
        let (first_biases, first_slopes) = (numbers(&mut seeded, channels_in), numbers(&mut seeded, channels_in));
        let weights = numbers(&mut seeded, channels * channels_in);
        let (biases, slopes) = (numbers(&mut seeded, channels), numbers(&mut seeded, channels));
        let between = convolved(&picture, &window, channels_in, &first_weights, &first_biases);
        let between = activated_sum(between, None, &first_slopes);
        let sums = convolved(&between, &Window::POINT, 1, &weights, &biases);
        let skip = Planes::of([channels, sums.height, sums.width], || f64::from(seeded.signed() as f32));
        let first = depthwise(&window, &first_weights, &first_biases).with_slopes(&singles(&first_slopes));
        let second = convolution(&Window::POINT, channels_in, &weights, &biases, &slopes);
        let layer = Convolution { depthwise: Some(first), ..second };
        let case = format!("seed {seed}: {channels_in} to {channels} channels, {window:?}");
        assert_is(&layer, &[&picture, &skip], &activated_sum(sums, Some(&skip), &slopes), &case);
    }
}

#[test]
fn max_pooling_matches_its_definition() {
    for seed in 0..CASES {
        let mut seeded = Seeded::new(seed);
        let channels = in_range(&mut seeded, 1..20);
        let picture = picture_of(&mut seeded, channels);
        let window = loop {
            // A window that is entirely outside has no maximum.
            let window = window_for(&mut seeded, &picture);
            let inside = |axis: usize, extent: usize| {
                let positions = window.output([picture.height, picture.width]).unwrap()[axis];
                (0..positions).all(|position| !window.taps(axis, position, extent).is_empty())
            };
            if inside(0, picture.height) && inside(1, picture.width) {
                break window;
            }
        };
        let [height, width] = window.output([picture.height, picture.width]).unwrap();
        let mut at = 0..;
        let expected = Planes::of([channels, height, width], || {
            let at = at.next().unwrap();
            let (channel, y, x) = (at / (height * width), at / width % height, at % width);
            let taps = (0..window.kernel[0]).flat_map(|row| (0..window.kernel[1]).map(move |column| (row, column)));
            let numbers = taps.filter_map(|(row, column)| {
                let y = (y * window.strides[0] + row * window.dilations[0]) as isize - window.before[0] as isize;
                let x = (x * window.strides[1] + column * window.dilations[1]) as isize - window.before[1] as isize;
                picture.at(channel, y, x)
            });
            numbers.fold(f64::NEG_INFINITY, f64::max)
        });
        assert_is(&MaxPool { window }, &[&picture], &expected, &format!("seed {seed}"));
    }
}

#[test]
fn rearranging_layers_move_each_number_to_its_position() {
    let shape = [2, 3, 4, 5];
    let numbers: Vec<f32> = (0..120).map(|i| i as f32).collect();
    let value = || Value { shape: &shape, numbers: &numbers };
    let at = |[a, b, c, d]: [usize; 4], shape: &[usize]| ((a * shape[1] + b) * shape[2] + c) * shape[3] + d;
    let axes = [3, 1, 0, 2];
    let (permuted_shape, permuted) = run(&Permute { axes: axes.to_vec() }, &[value()]);
    let (padded_shape, padded) = run(&Pad { by_axis: vec![[0, 1], [2, 0], [1, 1], [0, 3]] }, &[value()]);
    let (joined_shape, joined) = run(&Concat { axis: 2 }, &[value(), value()]);
    assert_eq!(
        (&*permuted_shape, &*padded_shape, &*joined_shape),
        (&[5, 3, 2, 4][..], &[3, 5, 6, 8][..], &[2, 3, 8, 5][..])
    );
    for (i, &number) in numbers.iter().enumerate() {
        let index = [i / 60, i / 20 % 3, i / 5 % 4, i % 5];
        assert_eq!(permuted[at(axes.map(|axis| index[axis]), &permuted_shape)], number);
        assert_eq!(padded[at([index[0], index[1] + 2, index[2] + 1, index[3]], &padded_shape)], number);
        for copy in 0..2 {
            assert_eq!(joined[at([index[0], index[1], index[2] + 4 * copy, index[3]], &joined_shape)], number);
        }
    }
    assert_eq!(padded.iter().sum::<f32>(), numbers.iter().sum::<f32>());
    assert_eq!(run(&Reshape { shape: tvec![6, 20] }, &[value()]), (vec![6, 20], numbers.clone()));
}

#[test]
fn invalid_shapes_are_rejected() {
    let dense = convolution(&Window::POINT, 3, &[1.0; 6], &[0.0; 2], &[1.0; 2]);
    let wide = Window { kernel: [1, 9], ..Window::POINT };
    let rejected: [(&dyn Layer, &[&[usize]]); 9] = [
        (&dense, &[&[1, 4, 4, 2]]),
        (&dense, &[&[2, 4, 4, 3]]),
        (&dense, &[&[1, 4, 4, 3], &[1, 4, 4, 3]]),
        (&dense, &[&[1, 4, 4, 3], &[1, 4, 5, 2]]),
        (&dense, &[]),
        (&MaxPool { window: wide }, &[&[1, 4, 4, 2]]),
        (&Sum { slopes: None }, &[&[4], &[5]]),
        (&Concat { axis: 1 }, &[&[4, 2], &[5, 2]]),
        (&Reshape { shape: tvec![3] }, &[&[4]]),
    ];
    for (layer, shapes) in rejected {
        assert!(layer.output_shape(shapes).is_err(), "{} of {shapes:?}", layer.name());
    }
    let too_large = Reshape { shape: tvec![1 << 40] };
    assert!(Operator::new(Pad { by_axis: vec![[usize::MAX, 1]] }).output_shape(&[&[1]]).is_err());
    assert!(Operator::new(too_large).output_shape(&[&[1 << 40]]).is_err());
}
