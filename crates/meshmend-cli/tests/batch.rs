//! Many files: a tree of results, a row for each file, and what dies is done again.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod common;

use std::collections::BTreeMap;
use std::fs;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use common::{Folder, meshmend, piped, program};
use rustix::process::{Pid, Signal, kill_process};
use serde_json::Value;

/// So many files are in a folder of many.
const MANY: usize = 300;

/// A triangle that is there twice, with a number in it.
fn twice(number: usize) -> String {
    format!("v 0 0 {number}\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n")
}

/// A folder of many files in three folders, each tenth cut off.
fn many(folder: &Folder) -> String {
    for number in 0..MANY {
        let path = folder.at(&format!("in/{}", number % 3));
        fs::create_dir_all(&path).unwrap();
        let text = if number % 10 == 0 { "v 0 0 x\n".to_owned() } else { twice(number) };
        fs::write(format!("{path}/{number}.obj"), text).unwrap();
    }
    folder.at("in")
}

/// The rows of a ledger by path, the last of each, without the columns of the run and what hangs on the output's folder.
fn rows(ledger: &str) -> BTreeMap<String, Value> {
    let text = fs::read_to_string(ledger).unwrap();
    let rows = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let settled = |mut row: Value| {
        for column in ["attempts", "seconds", "cpu_seconds", "peak_bytes", "host", "output"] {
            row.as_object_mut().unwrap().remove(column).unwrap();
        }
        (row["path"].as_str().unwrap().to_owned(), row)
    };
    rows.map(settled).collect()
}

/// All files below a folder, by name, without the ledger.
fn tree(root: &str) -> BTreeMap<String, Vec<u8>> {
    let files = walkdir::WalkDir::new(root).into_iter().map(Result::unwrap);
    let files = files.filter(|file| file.file_type().is_file() && file.file_name() != "batch.jsonl");
    files
        .map(|file| {
            (file.path().strip_prefix(root).unwrap().display().to_string(), fs::read(file.path()).unwrap())
        })
        .collect()
}

fn start(arguments: &[&str]) -> Child {
    program().arg("batch").args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// The processes that a process has started and that are there.
fn children(of: u32) -> Vec<i32> {
    let threads = fs::read_dir(format!("/proc/{of}/task")).into_iter().flatten().flatten();
    let lists = threads.filter_map(|thread| fs::read_to_string(thread.path().join("children")).ok());
    lists
        .flat_map(|list| list.split_whitespace().map(|id| id.parse().unwrap()).collect::<Vec<i32>>())
        .collect()
}

fn send(process: i32, signal: Signal) {
    kill_process(Pid::from_raw(process).unwrap(), signal).ok();
}

fn lines(path: &str) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.lines().count())
}

#[test]
fn each_file_has_a_row_and_its_place_with_one_worker_and_with_two() {
    let folder = Folder::new();
    let input = many(&folder);
    let run = |jobs: &str| {
        let out = folder.at(&format!("out{jobs}"));
        let run = meshmend(&["batch", &input, "-o", &out, "--jobs", jobs, "--json"]);
        assert_eq!((run.status, run.stderr.as_str()), (1, ""));
        let counts = run.json();
        assert_eq!((&counts["files"], &counts["to_do"]), (&MANY.into(), &0.into()));
        assert_eq!(counts["statuses"]["mended"], MANY - MANY / 10);
        assert_eq!(counts["statuses"]["unreadable"], MANY / 10);
        assert_eq!(lines(&format!("{out}/batch.jsonl")), MANY);
        (rows(&format!("{out}/batch.jsonl")), tree(&out))
    };
    let (one, two) = (run("1"), run("2"));
    assert_eq!((one.0.len(), one.1.len()), (MANY, MANY - MANY / 10));
    assert!(one == two);
    let file = folder.at("alone.obj");
    meshmend(&["repair", &format!("{input}/1/1.obj"), "-o", &file]).succeeds();
    assert_eq!(one.1["1/1.obj"], fs::read(file).unwrap());
}

#[test]
fn outputs_that_are_one_file_or_an_input_are_refused_before_anything_is_done() {
    let folder = Folder::new();
    fs::create_dir_all(folder.at("in")).unwrap();
    let (a, b) = (folder.with("in/a.obj", &twice(1)), folder.with("in/a.ply", "ply\n"));
    let out = folder.at("out");
    meshmend(&["batch", &a, &b, "-o", &out, "--to", "stl"]).fails(2, "the output of both");
    meshmend(&["batch", &folder.at("in"), "-o", &folder.at("in")]).fails(2, "the place of an input");
    assert_eq!((folder.names(), fs::read_to_string(&a).unwrap()), (vec!["in".to_owned()], twice(1)));
    let upper = folder.with("in/A.obj", &twice(2));
    meshmend(&["batch", &a, &upper, "-o", &out]).fails(2, "where case makes no difference");
    fs::remove_file(upper).unwrap();
    for ledger in [&a, &folder.at("in/../in/a.obj")] {
        meshmend(&["batch", &a, "-o", &out, "--ledger", ledger]).fails(2, "the ledger is an input too");
    }
    meshmend(&["batch", &a, "-o", &out, "--ledger", &format!("{out}/./a.obj")])
        .fails(2, "the ledger is an output too");
    let list = folder.with("list.txt", &a);
    meshmend(&["batch", "--from", &list, "-o", &out, "--ledger", &list]).fails(2, "the ledger is an input");
    assert_eq!((fs::read_to_string(&list).unwrap(), fs::read_to_string(&a).unwrap()), (a.clone(), twice(1)));
    fs::remove_file(list).unwrap();
    assert_eq!(folder.names(), ["in"]);
    let run = meshmend(&[
        "batch",
        &folder.at("in/*.obj"),
        &folder.at("none.obj"),
        "-o",
        &out,
        "--suffix=_new",
        "--json",
    ]);
    assert_eq!((run.status, tree(&out).into_keys().collect::<Vec<_>>()), (1, vec!["a_new.obj".to_owned()]));
    assert_eq!(run.json()["statuses"]["missing"], 1);
}

#[test]
fn a_list_is_a_file_or_standard_input() {
    let folder = Folder::new();
    let paths = ["one.obj", "two.obj", "b/three.obj"].map(|name| folder.at(name));
    fs::create_dir_all(folder.at("b")).unwrap();
    paths.iter().enumerate().for_each(|(number, path)| fs::write(path, twice(number)).unwrap());
    // A folder, an empty line, an ending of Windows, and no ending of the last line.
    let text = format!("{}\n\n{}\r\n{}", paths[0], folder.at("b"), folder.at("none.obj"));
    let list = folder.with("list.txt", &text);
    let [by_file, by_stream, by_word] = ["file", "stream", "word"].map(|name| folder.at(name));
    let run = meshmend(&["batch", "--from", &list, &paths[1], "-o", &by_file, "--json"]);
    assert_eq!((run.status, &run.json()["files"]), (1, &4.into()), "{}", run.stderr);
    assert_eq!(run.json()["statuses"]["missing"], 1);
    for words in [["--from", "-", &by_stream].as_slice(), &["-", &by_word]] {
        let (out, list) = words.split_last().unwrap();
        let run = piped(&[&["batch", &paths[1], "-o", out], list].concat(), text.as_bytes());
        assert_eq!(run.status.code(), Some(1), "{run:?}");
    }
    let placed = tree(&by_file);
    assert_eq!(placed.len(), 3);
    assert!(placed.contains_key("two.obj") && placed.contains_key(paths[2].trim_start_matches('/')));
    assert!(placed == tree(&by_stream) && placed == tree(&by_word));

    meshmend(&["batch", "-o", &by_file]).fails(2, "<IN>...");
    meshmend(&["batch", "--from", &folder.at("gone.txt"), "-o", &by_file]).fails(2, "gone.txt");
    meshmend(&["batch", "-", "--from", "-", "-o", &by_file]).fails(2, "only once");
    let up = folder.with("up.txt", "../one.obj\n");
    meshmend(&["batch", "--from", &up, "-o", &by_file]).fails(2, "no `..`");
}

#[test]
fn a_run_that_is_killed_is_gone_on_with_and_leaves_no_worker() {
    let folder = Folder::new();
    let (input, out, whole) = (many(&folder), folder.at("out"), folder.at("whole"));
    meshmend(&["batch", &input, "-o", &whole, "--jobs", "2"]);
    let ledger = format!("{out}/batch.jsonl");
    for part in 1..=3 {
        let mut run = start(&[&input, "-o", &out, "--jobs", "2", "--resume"]);
        while lines(&ledger) < part * MANY / 5 && run.try_wait().unwrap().is_none() {
            std::thread::yield_now();
        }
        let workers = children(run.id());
        run.kill().unwrap();
        run.wait().unwrap();
        let begin = Instant::now();
        while workers.iter().any(|worker| fs::exists(format!("/proc/{worker}")).unwrap()) {
            assert!(begin.elapsed() < Duration::from_secs(20), "a worker is left");
            sleep(Duration::from_millis(5));
        }
    }
    // What a write would leave that was cut off.
    let torn = fs::read_to_string(&ledger).unwrap() + "{\"path\":\"";
    fs::write(&ledger, torn).unwrap();
    let last = meshmend(&["batch", &input, "-o", &out, "--resume", "--json"]);
    assert!(last.stderr.contains("lines that are no row are passed over: 1"), "{}", last.stderr);
    assert!(last.json()["done_before"].as_u64().unwrap() >= 3 * MANY as u64 / 5, "{}", last.stdout);
    assert!(rows(&ledger) == rows(&format!("{whole}/batch.jsonl")) && tree(&out) == tree(&whole));
    // Nothing is done twice, unless its result is gone, or it is asked for.
    let before = lines(&ledger);
    fs::remove_file(format!("{out}/1/1.obj")).unwrap();
    meshmend(&["batch", &input, "-o", &out, "--resume"]);
    assert_eq!(lines(&ledger), before + 1);
    meshmend(&["batch", &input, "-o", &out, "--resume", "--retry", "unreadable"]);
    assert_eq!(lines(&ledger), before + 1 + MANY / 10);
    meshmend(&["batch", &input, "-o", &out, "--resume", "--weld", "off"]);
    assert_eq!(lines(&ledger), before + 1 + MANY / 10 + MANY);
}

#[test]
fn workers_that_are_killed_cost_no_file() {
    let folder = Folder::new();
    let (input, out, whole) = (many(&folder), folder.at("out"), folder.at("whole"));
    meshmend(&["batch", &input, "-o", &whole]);
    let ledger = format!("{out}/batch.jsonl");
    let mut run = start(&[&input, "-o", &out, "--jobs", "2"]);
    for part in 1..=4 {
        while lines(&ledger) < part * MANY / 8 && run.try_wait().unwrap().is_none() {
            std::thread::yield_now();
        }
        let signal = if part % 2 == 0 { Signal::KILL } else { Signal::SEGV };
        children(run.id()).first().into_iter().for_each(|&worker| send(worker, signal));
    }
    assert_eq!(run.wait().unwrap().code(), Some(1));
    assert!(rows(&ledger) == rows(&format!("{whole}/batch.jsonl")) && tree(&out) == tree(&whole));
}

#[test]
fn what_crashes_twice_or_takes_too_long_is_a_row() {
    let folder = Folder::new();
    let input = folder.at("large.stl");
    meshmend(&["make", "torus", "-o", &input, "--resolution", "400"]).succeeds();
    let row = |out: &str| rows(&format!("{out}/batch.jsonl")).remove(&input).unwrap();

    let out = folder.at("late");
    let late = meshmend(&["batch", &input, "-o", &out, "--timeout", "1ms"]);
    assert_eq!((late.status, &row(&out)["status"]), (1, &"timeout".into()), "{}", late.stderr);
    assert_eq!(tree(&out).len(), 0);

    let out = folder.at("dead");
    let mut run = start(&[&input, "-o", &out]);
    while run.try_wait().unwrap().is_none() {
        children(run.id()).into_iter().for_each(|worker| send(worker, Signal::SEGV));
    }
    assert_eq!((&row(&out)["status"], &row(&out)["signal"]), (&"crashed".into(), &11.into()));

    let out = folder.at("narrow");
    let narrow = meshmend(&["batch", &input, "-o", &out, "--memory-per-file", "40MiB"]);
    assert_eq!(
        (narrow.status, &row(&out)["status"]),
        (1, &"memory".into()),
        "{} {}",
        narrow.stderr,
        row(&out)
    );
}

/// Waits until something holds.
fn eventually(mut holds: impl FnMut() -> bool, what: &str) {
    let begin = Instant::now();
    while !holds() {
        assert!(begin.elapsed() < Duration::from_secs(20), "{what}");
        sleep(Duration::from_millis(5));
    }
}

fn is_there(process: i32) -> bool {
    let state = fs::read_to_string(format!("/proc/{process}/stat"));
    state.is_ok_and(|state| !state.rsplit(')').next().unwrap_or_default().trim_start().starts_with('Z'))
}

#[test]
fn one_signal_lets_workers_finish_and_a_second_one_ends_all_at_once() {
    use std::os::unix::process::ExitStatusExt;

    let folder = Folder::new();
    let (input, out, whole) = (many(&folder), folder.at("out"), folder.at("whole"));
    meshmend(&["batch", &input, "-o", &whole]);
    let ledger = format!("{out}/batch.jsonl");
    let arguments = [&input, "-o", &out, "--jobs", "1", "--resume"];

    let mut run = start(&arguments);
    eventually(|| lines(&ledger) > MANY / 8, "nothing is done");
    let workers = children(run.id());
    send(run.id() as i32, Signal::INT);
    let status = run.wait().unwrap();
    assert_eq!(status.signal(), Some(2), "{status:?}");
    let done = rows(&ledger);
    assert!(done.len() < MANY && workers.iter().all(|&worker| !is_there(worker)));
    assert!(done.values().all(|row| row["status"] != "crashed"), "what was cut off has no row");

    // One that hangs: it has ten seconds, unless the signal comes again.
    let mut run = start(&arguments);
    eventually(|| lines(&ledger) > MANY / 4, "nothing is done");
    let workers = children(run.id());
    workers.iter().for_each(|&worker| send(worker, Signal::STOP));
    send(run.id() as i32, Signal::TERM);
    sleep(Duration::from_millis(200));
    assert!(run.try_wait().unwrap().is_none(), "it waits for its workers");
    send(run.id() as i32, Signal::TERM);
    assert_eq!(run.wait().unwrap().signal(), Some(15));
    eventually(|| workers.iter().all(|&worker| !is_there(worker)), "a worker is left");

    meshmend(&["batch", &input, "-o", &out, "--resume"]);
    assert!(rows(&ledger) == rows(&format!("{whole}/batch.jsonl")) && tree(&out) == tree(&whole));
}

#[test]
fn no_worker_outlives_its_batch_even_if_it_hangs() {
    let folder = Folder::new();
    let (input, out) = (folder.at("large.stl"), folder.at("out"));
    meshmend(&["make", "torus", "-o", &input, "--resolution", "400"]).succeeds();
    let mut run = start(&[&input, "-o", &out]);
    // Not before it has bound itself.
    let is_at_work = |worker: &i32| {
        let files = fs::read_dir(format!("/proc/{worker}/fd")).into_iter().flatten().flatten();
        files.filter_map(|file| fs::read_link(file.path()).ok()).any(|path| path.ends_with("large.stl"))
    };
    let mut workers = Vec::new();
    eventually(
        || {
            workers = children(run.id());
            run.try_wait().unwrap().is_some() || workers.iter().any(is_at_work)
        },
        "no worker begins",
    );
    workers.iter().for_each(|&worker| send(worker, Signal::STOP));
    run.kill().unwrap();
    run.wait().unwrap();
    eventually(|| workers.iter().all(|&worker| !is_there(worker)), "a worker is left");
}
