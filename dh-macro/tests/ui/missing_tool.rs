use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(file = "robots/no-tool.yaml")]
struct NoTool;

fn main() {}
