//! Set-up, serve, dist, test and bench.
fn main() {}
