use std::collections::HashSet;

use tract_onnx::pb::GraphProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{TractErrorContext, ensure};

/// Reduces a graph to the nodes that compute the named outputs from the named inputs, and orders the inputs.
///
/// # Errors
/// If an input does not exist, or an output depends on another input.
pub(crate) fn reduce(graph: &mut GraphProto, inputs: &[&str], outputs: &[&str]) -> TractResult<()> {
    let mut needed: HashSet<String> = outputs.iter().map(|&output| output.to_owned()).collect();
    let mut nodes = Vec::new();
    for node in std::mem::take(&mut graph.node).into_iter().rev() {
        if node.output.iter().any(|output| needed.contains(output)) {
            needed.extend(node.input.iter().cloned());
            nodes.push(node);
        }
    }
    nodes.reverse();
    graph.node = nodes;
    graph.initializer.retain(|constant| needed.contains(&constant.name));
    graph.output.retain(|output| outputs.contains(&&*output.name));
    let constants: HashSet<&str> = graph.initializer.iter().map(|constant| &*constant.name).collect();
    let given = std::mem::take(&mut graph.input);
    let missing = given
        .iter()
        .map(|input| &*input.name)
        .find(|name| needed.contains(*name) && !constants.contains(name) && !inputs.contains(name));
    ensure!(missing.is_none(), "the outputs also depend on {}", missing.unwrap_or_default());
    let named = |&name: &&str| given.iter().find(|input| input.name == name).cloned();
    graph.input = inputs
        .iter()
        .map(|name| named(name).with_context(|| format!("the graph has no input {name}")))
        .collect::<TractResult<_>>()?;
    Ok(())
}
