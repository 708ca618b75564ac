use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(file = "robots/broken.yaml")]
struct Broken;

fn main() {}
