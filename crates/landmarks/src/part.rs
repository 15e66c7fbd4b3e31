use std::collections::HashSet;

use tract_onnx::pb::GraphProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

/// Leaves of a graph what computes the outputs named out of the inputs named, the inputs in their order.
///
/// # Errors
/// If an input is not one of the graph's, or an output needs another.
pub(crate) fn keep(graph: &mut GraphProto, inputs: &[&str], outputs: &[&str]) -> TractResult<()> {
    let mut wanted: HashSet<String> = outputs.iter().map(|&output| output.to_owned()).collect();
    let mut kept = Vec::new();
    for node in std::mem::take(&mut graph.node).into_iter().rev() {
        if node.output.iter().any(|output| wanted.contains(output)) {
            wanted.extend(node.input.iter().cloned());
            kept.push(node);
        }
    }
    kept.reverse();
    graph.node = kept;
    graph.initializer.retain(|constant| wanted.contains(&constant.name));
    graph.output.retain(|output| outputs.contains(&&*output.name));
    let constants: HashSet<&str> = graph.initializer.iter().map(|constant| &*constant.name).collect();
    let given = std::mem::take(&mut graph.input);
    let other = given
        .iter()
        .map(|input| &*input.name)
        .find(|name| wanted.contains(*name) && !constants.contains(name) && !inputs.contains(name));
    ensure!(other.is_none(), "its outputs need {}, too", other.unwrap_or_default());
    let named = |&name: &&str| given.iter().find(|input| input.name == name).cloned();
    graph.input = inputs
        .iter()
        .map(|name| named(name).with_context(|| format!("it has no input {name}")))
        .collect::<TractResult<_>>()?;
    Ok(())
}
