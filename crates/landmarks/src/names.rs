use std::collections::HashSet;

use tract_onnx::pb::GraphProto;
use tract_onnx::prelude::*;
use tract_onnx::tract_core::internal::{bail, ensure};

/// Fails unless every name that a graph reads is given before: tract panics over some names that are not.
pub(crate) fn check(graph: &GraphProto) -> TractResult<()> {
    let constants: HashSet<&str> = graph.initializer.iter().map(|tensor| &*tensor.name).collect();
    let inputs: Vec<&str> = graph.input.iter().map(|input| &*input.name).collect();
    ensure!(inputs.iter().any(|input| !constants.contains(input)), "it has no input");
    let mut given: HashSet<&str> = constants.into_iter().chain(inputs).collect();
    for node in &graph.node {
        if let Some(unknown) = named(&node.input).find(|input| !given.contains(input)) {
            bail!("node {} reads {unknown}, which nothing before it gives", node.name);
        }
        for output in named(&node.output) {
            ensure!(given.insert(output), "node {} gives {output}, which is given already", node.name);
        }
    }
    match graph.output.iter().find(|output| !given.contains(&*output.name)) {
        Some(unknown) => bail!("its output {} is given by none of its nodes", unknown.name),
        None => Ok(()),
    }
}

/// What is left out has an empty name.
fn named(names: &[String]) -> impl Iterator<Item = &str> {
    names.iter().map(String::as_str).filter(|name| !name.is_empty())
}
