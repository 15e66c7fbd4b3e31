//! Compares converted graphs with tract's own operators, and tests damaged graphs.

use tract_onnx::Onnx;
use tract_onnx::pb::ModelProto;
use tract_onnx::prelude::*;

use crate::assets;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::seeded::Seeded;
use crate::warp::{self, Outside};

/// File, input side and outputs of a network.
type Case = (Vec<u8>, usize, [&'static str; 2]);

fn networks() -> [Case; 2] {
    let detector = (assets::detector_onnx(), 128, ["regressors", "classificators"]);
    [detector, (assets::landmarks_onnx(), 192, ["conv2d_21", "conv2d_31"])]
}

fn proto(onnx: &[u8]) -> TractResult<ModelProto> {
    Onnx::default().proto_model_for_read(&mut &*onnx)
}

fn portrait(side: usize) -> Tensor {
    let mut planes = vec![0.0; 3 * side * side];
    let whole = RegionPx::whole(PictureSize { width: 512.0, height: 512.0 });
    warp::fill_planes(&mut planes, &assets::portrait(), &whole, Outside::NearestEdge, [1.0 / 255.0, 0.0]);
    Tensor::from_shape(&[1, 3, side, side], &planes).unwrap()
}

fn outputs_of(model: TypedModel, side: usize) -> Vec<Vec<f32>> {
    let outputs = model.into_runnable().unwrap().run(tvec![portrait(side).into()]).unwrap();
    outputs.iter().map(|output| output.try_as_plain_ram().unwrap().as_slice::<f32>().unwrap().to_vec()).collect()
}

fn assert_same(found: &[Vec<f32>], expected: &[Vec<f32>]) {
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.len(), expected.len());
        let magnitude = expected.iter().fold(1.0_f32, |largest, number| largest.max(number.abs()));
        let difference = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(difference < 1e-5 * magnitude, "difference {difference} at a magnitude of {magnitude}");
    }
}

#[test]
fn both_networks_match_tracts_operators() {
    for (onnx, side, outputs) in networks() {
        let converted = super::model(proto(&onnx).unwrap().graph.as_ref().unwrap(), &outputs).unwrap();
        let expected = tract_onnx::onnx().model_for_read(&mut &*onnx).unwrap();
        let expected = expected.with_outputs_by_name(outputs).unwrap().into_optimized().unwrap();
        assert_same(&outputs_of(converted, side), &outputs_of(expected, side));
    }
}

#[test]
fn fused_layers_match_separate_layers() {
    for (onnx, side, outputs) in networks() {
        let proto = proto(&onnx).unwrap();
        let graph = proto.graph.as_ref().unwrap();
        let fused = super::model(graph, &outputs).unwrap();
        // Requesting all intermediate values as outputs prevents fusion.
        let nodes = graph.node.iter().filter(|node| node.op_type != "Cast").map(|node| &*node.output[0]);
        let all: Vec<&str> = outputs.into_iter().chain(nodes).collect();
        let separate = super::model(graph, &all).unwrap();
        assert!(5 * fused.nodes.len() < separate.nodes.len(), "{} of {}", fused.nodes.len(), separate.nodes.len());
        assert_same(&outputs_of(fused, side), &outputs_of(separate, side)[..2]);
    }
}

/// Range of the nodes, which precede the weights in the file.
const BYTES_OF_NODES: usize = 20_000;

#[test]
#[ignore = "slow; runs at night"]
fn a_graph_with_a_changed_byte_is_rejected_or_runs() {
    for (onnx, side, outputs) in networks() {
        for seed in 0..400 {
            let mut seeded = Seeded::new(seed);
            let mut damaged = onnx.clone();
            damaged[seeded.below(BYTES_OF_NODES)] = seeded.bits() as u8;
            let Ok(ModelProto { graph: Some(graph), .. }) = proto(&damaged) else { continue };
            let Ok(model) = super::model(&graph, &outputs) else { continue };
            let plan = model.into_runnable();
            // The output does not matter.
            let _ = plan.and_then(|plan| plan.run(tvec![portrait(side).into()]));
        }
    }
}
