//! What becomes of a graph answers as the graph does, and damaged graphs are refused.

use tract_onnx::Onnx;
use tract_onnx::pb::ModelProto;
use tract_onnx::prelude::*;

use crate::assets;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::seeded::Seeded;
use crate::warp::{self, Outside};

/// A network's file, the side of its picture, and its outputs.
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

fn answers(model: TypedModel, side: usize) -> Vec<Vec<f32>> {
    let outputs = model.into_runnable().unwrap().run(tvec![portrait(side).into()]).unwrap();
    outputs.iter().map(|output| output.try_as_plain_ram().unwrap().as_slice::<f32>().unwrap().to_vec()).collect()
}

fn assert_same(found: &[Vec<f32>], expected: &[Vec<f32>]) {
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.len(), expected.len());
        let magnitude = expected.iter().fold(1.0_f32, |largest, number| largest.max(number.abs()));
        let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < 1e-5 * magnitude, "{apart} apart, at numbers up to {magnitude}");
    }
}

#[test]
fn both_networks_answer_as_tracts_own_operators_do() {
    for (onnx, side, outputs) in networks() {
        let ours = super::model(proto(&onnx).unwrap().graph.as_ref().unwrap(), &outputs).unwrap();
        let theirs = tract_onnx::onnx().model_for_read(&mut &*onnx).unwrap();
        let theirs = theirs.with_outputs_by_name(outputs).unwrap().into_optimized().unwrap();
        assert_same(&answers(ours, side), &answers(theirs, side));
    }
}

#[test]
fn layers_that_were_joined_answer_as_they_do_one_by_one() {
    for (onnx, side, outputs) in networks() {
        let proto = proto(&onnx).unwrap();
        let graph = proto.graph.as_ref().unwrap();
        let joined = super::model(graph, &outputs).unwrap();
        // What is asked for has to be there, so nothing becomes part of what follows.
        let nodes = graph.node.iter().filter(|node| node.op_type != "Cast").map(|node| &*node.output[0]);
        let all: Vec<&str> = outputs.into_iter().chain(nodes).collect();
        let apart = super::model(graph, &all).unwrap();
        assert!(5 * joined.nodes.len() < apart.nodes.len(), "{} of {}", joined.nodes.len(), apart.nodes.len());
        assert_same(&answers(joined, side), &answers(apart, side)[..2]);
    }
}

/// Nodes come before weights in a file.
const BYTES_OF_NODES: usize = 20_000;

#[test]
fn a_graph_with_a_byte_changed_is_refused_or_runs() {
    for (onnx, side, outputs) in networks() {
        for seed in 0..400 {
            let mut seeded = Seeded::new(seed);
            let mut damaged = onnx.clone();
            damaged[seeded.below(BYTES_OF_NODES)] = seeded.bits() as u8;
            let Ok(ModelProto { graph: Some(graph), .. }) = proto(&damaged) else { continue };
            let Ok(model) = super::model(&graph, &outputs) else { continue };
            let plan = model.into_runnable();
            // Whatever comes out is no concern here.
            let _ = plan.and_then(|plan| plan.run(tvec![portrait(side).into()]));
        }
    }
}
