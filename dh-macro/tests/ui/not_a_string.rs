use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(file = robots)]
struct Unquoted;

fn main() {}
