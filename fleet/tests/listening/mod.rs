//! A worker that others reach by its address; it ends with the test.

// Each test uses a part of it.
#![allow(dead_code)]

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

pub struct Listening {
    process: Child,
    pub address: String,
    log: tempfile::NamedTempFile,
}

impl Listening {
    pub fn start(listen: &str) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
        // Elsewhere than the asker: what is sent must be enough.
        command.args(["worker", "--threads", "1", "--listen", listen]).current_dir(std::env::temp_dir());
        let log = tempfile::NamedTempFile::new().unwrap();
        command.stdout(Stdio::piped()).stderr(log.reopen().unwrap());
        let mut process = command.spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().strip_prefix("listening on ").expect("the address").to_string();
        Self { process, address, log }
    }

    /// Processor time so far, s, by the kernel's count.
    pub fn processor(&self) -> f64 {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.process.id())).unwrap();
        let fields = stat.rsplit(')').next().unwrap().split_whitespace().filter_map(|field| field.parse::<f64>().ok());
        // Of proc(5): utime and stime are fields 14 and 15, in hundredths; here the first three are left out.
        fields.skip(10).take(2).sum::<f64>() / 100.0
    }

    /// What it has done so far, by its log: recordings or robots.
    pub fn done(&self) -> usize {
        let log = std::fs::read_to_string(self.log.path()).unwrap();
        let counts = log.lines().filter_map(|line| line.strip_suffix(" since the start")?.rsplit(' ').next());
        counts.map(|count| count.parse::<usize>().unwrap()).max().unwrap_or(0)
    }

    /// With `kill -9`.
    pub fn kill(&mut self) {
        self.process.kill().unwrap();
        self.process.wait().unwrap();
    }
}

impl Drop for Listening {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
