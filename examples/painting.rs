use denavit::reproduce::{PaintingSettings, painting};
fn main() {
    let start = std::time::Instant::now();
    let found = painting(&PaintingSettings::default(), &|what, share| {
        if std::env::var("QUIET").is_err() {
            eprint!("\r{:5.1}% {what:60}", 100.0 * share)
        }
    })
    .unwrap();
    dump(&found);
    println!("\n{:?} seconds {:?} torque {:?}", start.elapsed(), found.seconds, found.torque);
    for r in &found.rows {
        println!(
            "{:14} {:22} {:?}: {:?} tracking {:.4} off {:.3} {:?}",
            r.roller,
            r.case.title(),
            r.feedback,
            r.ours(),
            r.run.tracking,
            r.run.off,
            r.run.status
        );
    }
    let t = &found.rows[0].run.tuning;
    for j in &t.joints {
        println!("kp {:.1} kd {:.2} bw {:.1} {:?}", j.kp, j.kd, j.bandwidth, j.margins);
    }
    println!(
        "{} {} {:?} overshoot {} settled {}",
        t.force.kp, t.force.ki, t.force.margins, t.force.step.overshoot, t.force.step.settled
    );
    for c in &found.diagnosis.causes {
        println!(
            "{} {:?} {:.2} {:?}",
            c.cause,
            c.joints,
            c.probability,
            c.keys.iter().map(|k| format!("{}={:.5}", k.symbol, k.value)).collect::<Vec<_>>()
        );
    }
    println!(
        "{:?} base {:?} refit {:?} ext {:?} floor {:?}",
        found.diagnosis.verdict,
        found.diagnosis.baseline.validate,
        found.diagnosis.refitted.validate,
        found.diagnosis.extended.validate,
        found.diagnosis.noise_floor
    );
}
fn dump(found: &denavit::reproduce::Painting) {
    for (k, r) in found.rows.iter().enumerate() {
        let mut s = String::from("t,est,meas,truth,disp,px,py,pz,ax,ay,az\n");
        let t = &r.run.trace;
        for i in (0..t.t.len()).step_by(5) {
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
        std::fs::write(format!("/tmp/paint{k}.csv"), s).unwrap();
    }
}
