use rosto_laplacian::Operator;

/// What an operator is called in files and on the command line.
pub fn operator_name(operator: Operator) -> &'static str {
    match operator {
        Operator::UniformSymmetric => "L_s",
        Operator::Uniform => "L",
        Operator::Degree => "degree",
        Operator::InverseLength => "inverse-length",
        Operator::Cotangent => "cotangent",
    }
}

/// The operator that [`operator_name`] calls `name`.
pub fn operator_from_name(name: &str) -> Option<Operator> {
    Operator::ALL.into_iter().find(|&operator| operator_name(operator) == name)
}
