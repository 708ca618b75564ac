use dh_macro::DhRobot;

#[derive(DhRobot)]
struct Nameless;

fn main() {}
