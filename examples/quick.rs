fn main() {
    let args: Vec<String> = std::env::args().collect();
    let start = std::time::Instant::now();
    let f =
        if args[2] == "m" { denavit::paint::run::Feedback::Measured } else { denavit::paint::run::Feedback::Estimated };
    let r = denavit::reproduce::painting::quick(args[1] == "1", f);
    println!("\n{:?} {:?} tracking {} off {} {:?}", start.elapsed(), r.accuracy, r.tracking, r.off, r.status);
    let t = &r.tuning;
    for j in &t.joints {
        println!("kp {:.1} kd {:.2} bw {:.1} {:?}", j.kp, j.kd, j.bandwidth, j.margins);
    }
    println!(
        "{} {} {:?} overshoot {} settled {}",
        t.force.kp, t.force.ki, t.force.margins, t.force.step.overshoot, t.force.step.settled
    );
    let mut s = String::from("t,est,meas,truth,disp,px,py,pz,ax,ay,az\n");
    let t = &r.trace;
    for i in 0..t.t.len() {
        s += &format!(
            "{},{},{},{},{},{},{},{},{},{},{}\n",
            t.t[i],
            t.estimated[i],
            t.measured[i],
            t.truth[i],
            t.displacement[i],
            t.planned[i][0],
            t.planned[i][1],
            t.planned[i][2],
            t.actual[i][0],
            t.actual[i][1],
            t.actual[i][2]
        );
    }
    std::fs::write(format!("/tmp/quick{}{}.csv", args[1], args[2]), s).unwrap();
}
