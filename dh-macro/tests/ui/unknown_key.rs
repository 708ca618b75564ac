use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(path = "robots/broken.yaml")]
struct Keyed;

fn main() {}
