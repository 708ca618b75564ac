use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(file = "robots/missing.yaml")]
struct Missing;

fn main() {}
