//! A worker: jobs in, rows out, as `docs/batch.md` says.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod common;

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

use common::{Folder, example, meshmend, piped, program};
use serde_json::{Value, json};

/// A triangle that is there twice.
const TWICE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n";

/// A worker that waits for jobs.
struct Worker {
    process: Child,
    jobs: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Worker {
    fn start(arguments: &[&str]) -> Self {
        let mut command = program();
        command.arg("worker").args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = command.spawn().unwrap();
        let (jobs, answers) = (process.stdin.take().unwrap(), process.stdout.take().unwrap());
        Worker { process, jobs, answers: BufReader::new(answers) }
    }

    /// Hands in a job with its bytes, and gives the answer with those that come back.
    fn on(&mut self, job: &Value, bytes: &[u8]) -> (Value, Vec<u8>) {
        writeln!(self.jobs, "{job}").unwrap();
        self.jobs.write_all(bytes).unwrap();
        let mut line = String::new();
        self.answers.read_line(&mut line).unwrap();
        let answer: Value = serde_json::from_str(&line).unwrap();
        let mut bytes = vec![0; answer["bytes"].as_u64().unwrap_or(0) as usize];
        self.answers.read_exact(&mut bytes).unwrap();
        (answer, bytes)
    }

    /// Ends it by the end of its input; gives what it still said, and its status.
    fn end(mut self) -> (String, Option<i32>) {
        drop(self.jobs);
        let mut rest = String::new();
        self.answers.read_to_string(&mut rest).unwrap();
        (rest, self.process.wait().unwrap().code())
    }
}

/// A job from a path to a path.
fn job(id: u64, input: &str, output: &str) -> Value {
    json!({"id": id, "name": input, "input": {"path": input}, "output": {"path": output}})
}

/// A row without the columns that may differ from run to run.
fn settled(row: &Value) -> Value {
    let mut row = row.clone();
    for column in ["attempts", "seconds", "cpu_seconds", "peak_bytes", "host"] {
        assert!(row.as_object_mut().unwrap().remove(column).is_some(), "{column}");
    }
    row
}

#[test]
fn a_file_is_written_as_repair_writes_it_and_its_row_has_what_the_report_has() {
    let folder = Folder::new();
    let mut worker = Worker::start(&["--orient", "majority", "--reports"]);
    for (id, name) in ["broken.obj", "pinched.ply", "soup.stl", "moebius.off"].into_iter().enumerate() {
        let input = folder.at(name);
        fs::copy(example(name), &input).unwrap();
        let (by_worker, by_repair) = (folder.at(&format!("new/{name}")), folder.at(&format!("r-{name}")));
        let repair =
            meshmend(&["repair", &input, "-o", &by_repair, "--orient", "majority", "--companions", "skip"]);
        assert_eq!(repair.status, 0, "{}", repair.stderr);
        let (answer, _) = worker.on(&job(id as u64, &input, &by_worker), b"");
        let (written, row) = (fs::read(&by_repair).unwrap(), &answer["row"]);
        assert_eq!(fs::read(&by_worker).unwrap(), written, "{name}: {answer}");
        let report = meshmend(&["repair", &input, "-o", &by_worker, "--orient", "majority", "--json"]);
        assert_eq!(row["report"].as_str().unwrap().to_owned() + "\n", report.stdout, "{name}");

        let report = report.json();
        for (column, value) in [
            ("changed", &report["changed"]),
            ("removed_faces", &report["removed_faces"]["count"]),
            ("flipped_faces", &report["flipped_faces"]["count"]),
            ("path", &json!(input)),
            ("output", &json!(by_worker)),
            ("size", &json!(fs::metadata(&input).unwrap().len())),
            ("schema", &json!(2)),
            ("attempts", &json!(1)),
            ("version", &json!(env!("CARGO_PKG_VERSION"))),
        ] {
            assert_eq!(&row[column], value, "{name}: {column}");
        }
        for (side, column) in [("before", "vertices"), ("after", "faces"), ("after", "genus")] {
            assert_eq!(row[side][column], report[side][column], "{name}: {side}.{column}");
        }
        for group in report["before"]["defects"].as_array().unwrap() {
            assert_eq!(row["defects"][group["kind"].as_str().unwrap()], group["count"], "{name}");
        }
    }
    assert_eq!(worker.end(), (String::new(), Some(0)));
}

#[test]
fn bytes_come_and_go_through_the_pipes_and_nothing_else_does() {
    let folder = Folder::new();
    let input = folder.with("twice.obj", TWICE);
    let mut worker = Worker::start(&[]);
    for (id, format) in ["obj", "ply", "stl", "off", "glb", "gltf", "3mf"].into_iter().enumerate() {
        let output = folder.at(&format!("once.{format}"));
        meshmend(&["repair", &input, "-o", &output]).succeeds();
        let job = json!({
            "id": id, "name": "a/twice.obj", "input": {"bytes": TWICE.len()}, "output": {"bytes": true}, "format": format,
        });
        let (answer, bytes) = worker.on(&job, TWICE.as_bytes());
        assert_eq!(answer["row"]["status"], "mended", "{answer}");
        assert_eq!((&answer["id"], bytes == fs::read(&output).unwrap()), (&json!(id), true), "{format}");
        assert_eq!((&answer["row"]["output"], &answer["row"]["path"]), (&Value::Null, &json!("a/twice.obj")));
    }
    // Without a format, that of the name; without an output, none.
    let named = json!({"id": 9, "name": "b.off", "input": {"bytes": TWICE.len()}, "output": {"bytes": true}});
    let (answer, bytes) = worker.on(&named, TWICE.as_bytes());
    assert!(bytes.starts_with(b"OFF"), "{answer}");
    let judged = json!({"id": 10, "name": "b.obj", "input": {"bytes": TWICE.len()}});
    let (answer, bytes) = worker.on(&judged, TWICE.as_bytes());
    assert_eq!((&answer["row"]["status"], &answer["row"]["format_out"]), (&json!("mended"), &Value::Null));
    assert!(bytes.is_empty() && answer.get("bytes").is_none());
    assert_eq!(worker.end(), (String::new(), Some(0)));
}

#[test]
fn what_is_wrong_with_one_file_is_its_row_and_the_next_one_is_mended() {
    let folder = Folder::new();
    let good = folder.with("twice.obj", TWICE);
    let clean = folder.with("once.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let left = folder.with("band.off", &fs::read_to_string(example("moebius.off")).unwrap());
    let broken = folder.with("broken.obj", "v 0 0 x\n");
    let cut = folder.with("cut.ply", "ply\nformat ascii 1.0\nelement vertex 9\n");
    let out = folder.at("out/a.obj");
    let in_the_way = folder.with("file", "");
    let mut worker = Worker::start(&["--non-orientable", "report"]);
    let mut id = 0;
    let mut row = |input: &str, output: &str| {
        id += 1;
        let (answer, _) = worker.on(&job(id, input, output), b"");
        assert_eq!(answer["id"], id);
        answer["row"].clone()
    };
    for (input, output, status) in [
        (&good, &out, "mended"),
        (&clean, &out, "clean"),
        (&left, &out, "left"),
        (&broken, &out, "unreadable"),
        (&cut, &out, "unreadable"),
        (&folder.at("none.obj"), &out, "missing"),
        (&folder.at("."), &out, "unreadable"),
        (&good, &folder.at("file/b.obj"), "unwritable"),
        (&good, &folder.at("b.unknown"), "unwritable"),
        (&good, &out, "mended"),
    ] {
        let row = row(input, output);
        assert_eq!(row["status"], status, "{row}");
        let is_written = ["mended", "clean", "left"].contains(&status);
        assert_eq!((row["output"].is_string(), row["message"].is_null()), (is_written, is_written), "{row}");
        assert_eq!(row["output_sha256"].is_string(), is_written);
    }
    assert_eq!(row(&broken, &out)["line"], 1);
    assert_eq!(fs::read(in_the_way).unwrap(), b"");
    assert_eq!(worker.end(), (String::new(), Some(0)));

    let mut strict = Worker::start(&["--non-orientable", "fail"]);
    let (answer, _) = strict.on(&job(1, &left, &out), b"");
    assert_eq!(answer["row"]["status"], "refused", "{answer}");
    assert!(answer["row"]["message"].as_str().unwrap().contains("band.off"), "{answer}");
}

#[test]
fn what_a_file_is_failed_on_is_left_and_strictly_it_is_not_written() {
    let folder = Folder::new();
    let input = folder.with("twice.obj", TWICE);
    for (arguments, is_written) in
        [(&["--fail-on", "removed"][..], true), (&["--fail-on", "removed", "--strict"], false)]
    {
        let mut worker = Worker::start(arguments);
        let output = folder.at(&format!("{}.obj", arguments.len()));
        let row = worker.on(&job(1, &input, &output), b"").0["row"].clone();
        assert_eq!((&row["status"], row["output"].is_string()), (&json!("left"), is_written), "{row}");
        assert_eq!(fs::exists(output).unwrap(), is_written);
    }
}

#[test]
fn a_line_that_is_no_job_ends_it_with_status_2_and_the_end_of_its_input_with_0() {
    for broken in
        ["\n", "{}\n", "{\"id\":1", "hello\n", r#"{"id":1,"name":"a","input":{"path":"a"},"more":1}"#]
    {
        let run = piped(&["worker"], broken.as_bytes());
        assert_eq!((run.status.code(), run.stdout.as_slice()), (Some(2), &b""[..]), "{broken:?}");
        assert!(String::from_utf8(run.stderr).unwrap().contains("standard input: not a job"), "{broken:?}");
    }
    let short = piped(&["worker"], b"{\"id\":1,\"name\":\"a.obj\",\"input\":{\"bytes\":9}}\nv 0");
    assert_eq!(short.status.code(), Some(2));
    assert!(String::from_utf8(short.stderr).unwrap().contains("9 bytes were announced, and 3 came"));
    let nothing = piped(&["worker"], b"");
    assert_eq!((nothing.status.code(), nothing.stdout.len()), (Some(0), 0));
    // What is wrong with its own policies is told before a job is read.
    let policies = piped(&["worker", "--weld", "-1"], b"{}\n");
    assert_eq!(policies.status.code(), Some(2));
}

#[test]
fn the_digest_hangs_on_what_the_policies_mean_and_on_the_form_of_the_output() {
    let folder = Folder::new();
    let input = folder.with("twice.obj", TWICE);
    let plan = folder.with("plan.toml", "[orient]\nside = \"outward\"\n");
    let seams = folder.with("seams.toml", "seams = \"corners\"\nlimit = 3\n");
    let digest = |arguments: &[&str], output: &str| {
        let mut worker = Worker::start(arguments);
        let (answer, _) = worker.on(&job(1, &input, &folder.at(output)), b"");
        answer["row"]["plan_digest"].as_str().unwrap().to_owned()
    };
    let usual = digest(&[], "a.obj");
    let outward = digest(&["--orient", "outward", "--split", "cut"], "a.obj");
    assert_eq!(outward, digest(&["--split", "cut", "--orient=outward"], "b.obj"));
    assert_eq!(digest(&["--plan", &plan], "a.obj"), digest(&["--orient", "outward"], "a.obj"));
    assert_eq!(digest(&["--plan", &seams], "a.obj"), digest(&["--seams", "corners"], "a.obj"));
    assert_eq!(usual, digest(&["--limit", "3", "--memory", "8GiB"], "a.obj"));
    let others = [&outward, &digest(&[], "a.ply"), &digest(&["--to", "ply", "--encoding", "ascii"], "a.ply")];
    for (at, one) in others.iter().enumerate() {
        assert!(**one != usual && !others[at + 1..].contains(one), "{at}");
    }
}

#[test]
fn rows_are_the_same_in_every_worker_but_for_the_columns_of_the_run() {
    let folder = Folder::new();
    let inputs = [folder.with("twice.obj", TWICE), folder.with("broken.obj", "f 1 2 9\n")];
    let rows = |order: &[usize]| {
        let mut worker = Worker::start(&[]);
        let mut rows: Vec<(usize, String)> = Vec::new();
        for &at in order {
            let (answer, _) = worker.on(&job(1, &inputs[at], &folder.at(&format!("out{at}.obj"))), b"");
            assert!(answer["row"]["seconds"].as_f64().unwrap() > 0.0);
            rows.push((at, settled(&answer["row"]).to_string()));
        }
        rows.sort();
        rows
    };
    assert_eq!(rows(&[0, 1]), rows(&[1, 0]));
}

#[test]
fn cost_is_printed_and_memory_is_a_limit_of_the_process() {
    let cost = meshmend(&["worker", "--cost", "1MiB", "stl"]).succeeds();
    assert_eq!(cost.stdout, format!("{}\n", 70 << 20));
    meshmend(&["worker", "--cost", "1MiB"]).fails(2, "FORMAT");
    meshmend(&["worker", "stl"]).fails(2, "--cost SIZE");
    meshmend(&["worker", "--memory", "much"]).fails(2, "expected a size such as 4GiB");

    if !cfg!(target_os = "linux") {
        return;
    }
    let worker = Worker::start(&["--memory", "3GiB"]);
    let limit = loop {
        let limits = fs::read_to_string(format!("/proc/{}/limits", worker.process.id())).unwrap();
        let line = limits.lines().find(|line| line.starts_with("Max address space")).unwrap();
        let limit = line.split_whitespace().nth(3).unwrap().to_owned();
        if limit != "unlimited" {
            break limit;
        }
        std::thread::yield_now();
    };
    assert_eq!(limit, (3_u64 << 30).to_string());
    // What is announced and does not fit is passed over, and is a row.
    let mut narrow = Worker::start(&["--memory", "1GiB"]);
    let large = 1_u64 << 30;
    writeln!(narrow.jobs, r#"{{"id":1,"name":"a.obj","input":{{"bytes":{large}}}}}"#).unwrap();
    let block = vec![b'\n'; 1 << 20];
    for _ in 0..1 << 10 {
        narrow.jobs.write_all(&block).unwrap();
    }
    let mut line = String::new();
    narrow.answers.read_line(&mut line).unwrap();
    let answer: Value = serde_json::from_str(&line).unwrap();
    assert_eq!(answer["row"]["status"], "memory", "{answer}");
    let job = json!({"id": 2, "name": "a.obj", "input": {"bytes": TWICE.len()}});
    assert_eq!(narrow.on(&job, TWICE.as_bytes()).0["row"]["status"], "mended");
}
