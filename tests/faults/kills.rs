//! A run that is killed at any instant: the file is the old or the new one, and the next run clears what was left.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use meshmend_io::Format;
use meshmend_tests::program::binary;
use meshmend_tests::scratch::Scratch;

use super::{encoded, forms, said, sheet, sheet_mesh, wait};

/// Pseudo-random fractions of one.
struct Instants(u64);

impl Instants {
    fn seeded() -> Self {
        let seed = std::env::var("MESHMEND_SEED").ok().map(|seed| seed.parse().unwrap()).unwrap_or(1);
        println!("seed {seed}");
        Instants(seed)
    }

    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f64 / (1_u64 << 24) as f64
    }
}

/// A command that replaces a file, to be killed.
struct Replacement {
    name: String,
    folder: Scratch,
    arguments: Vec<String>,
    target: PathBuf,
    old: Vec<u8>,
    new: Vec<u8>,
    names: Vec<String>,
    takes: Duration,
}

impl Replacement {
    /// Puts the input and, where that is another file, the old output into a folder, and runs once undisturbed.
    fn new(name: String, input: (&str, &[u8]), output: &str, arguments: &[&str]) -> Self {
        let folder = Scratch::new();
        let target = folder.path().join(output);
        fs::write(&target, "the old file\n").unwrap();
        fs::write(folder.path().join(input.0), input.1).unwrap();
        let mut replacement = Replacement {
            name,
            arguments: arguments.iter().map(|&argument| argument.to_owned()).collect(),
            old: fs::read(&target).unwrap(),
            new: Vec::new(),
            names: folder.file_names(),
            takes: Duration::ZERO,
            target,
            folder,
        };
        let start = Instant::now();
        replacement.run_on();
        replacement.takes = start.elapsed();
        replacement.new = fs::read(&replacement.target).unwrap();
        assert_ne!(replacement.new, replacement.old, "{}", replacement.name);
        replacement
    }

    fn command(&self) -> Command {
        let mut command = Command::new(binary());
        command.args(&self.arguments).current_dir(self.folder.path()).stdin(Stdio::null());
        command
    }

    /// A run to the end.
    fn run_on(&self) {
        let output = wait(&mut self.command());
        assert!(output.status.success(), "{}: {}", self.name, said(&output));
    }

    fn has_debris(&self) -> bool {
        self.folder.file_names() != self.names
    }

    /// Starts, kills, and looks; whether the output was old, and whether there was debris.
    fn kill(&self, instants: &mut Instants) -> (bool, bool) {
        fs::write(&self.target, &self.old).unwrap();
        let mut command = self.command();
        let child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // Half of the kills come at any time, half of them while the new file is being written.
        if instants.next() < 0.5 {
            std::thread::sleep(self.takes.mul_f64(1.1 * instants.next()));
            end(child);
        } else {
            self.kill_while_writing(child, instants.next());
        }
        let found = fs::read(&self.target).unwrap();
        let is_old = found == self.old;
        assert!(is_old || found == self.new, "{}: {} bytes that are neither", self.name, found.len());
        let has_debris = self.has_debris();
        if has_debris {
            self.run_on();
            assert_eq!(fs::read(&self.target).unwrap(), self.new, "{}", self.name);
            // Elsewhere a process that is gone can't be told, and debris stays for an hour.
            let tells_the_dead = Path::new("/proc/self").exists();
            assert!(!tells_the_dead || !self.has_debris(), "{}: debris stays", self.name);
        }
        (is_old, has_debris)
    }

    fn kill_while_writing(&self, mut child: Child, fraction: f64) {
        while !self.has_debris() && child.try_wait().unwrap().is_none() {
            std::thread::yield_now();
        }
        std::thread::sleep(self.takes.mul_f64(0.3 * fraction));
        end(child);
    }
}

/// Kills and waits, so that the process is gone.
fn end(mut child: Child) {
    child.kill().unwrap();
    child.wait().unwrap();
}

/// In every form: to a file that is there, and onto the input itself; and a repair onto its input.
fn replacements() -> Vec<Replacement> {
    let text = sheet(160);
    let mesh = sheet_mesh(160);
    let extension = |format: Format| format.extensions()[0];
    let mut replacements = Vec::new();
    for (format, encoding) in forms() {
        let output = format!("new.{}", extension(format));
        let arguments = ["convert", "sheet.obj", &output, "--encoding", encoding.name()];
        let name = format!("{format} {encoding}");
        replacements.push(Replacement::new(name, ("sheet.obj", text.as_bytes()), &output, &arguments));
        if format == Format::ThreeMf {
            // Onto itself it is written as it was read: nothing is replaced by something else.
            continue;
        }
        // Onto itself: from the same format in another encoding, or with a line that is not kept as it is.
        let other = format.encodings().iter().copied().find(|&other| other != encoding);
        let container = match format {
            Format::Glb => Some(Format::Gltf),
            Format::Gltf => Some(Format::Glb),
            _ => None,
        };
        let bytes = match other {
            Some(other) => encoded(&mesh, (format, other)),
            // What is not changed is written as it was, but for its container.
            None if container.is_some() => encoded(&mesh, (container.unwrap_or(format), encoding)),
            None if format == Format::Obj => text.clone().into_bytes(),
            None => [&encoded(&mesh, (format, encoding))[..], b"\n\n"].concat(),
        };
        let file = format!("mesh.{}", extension(format));
        let arguments = ["convert", &file, &file, "--encoding", encoding.name()];
        let name = format!("{format} {encoding} onto itself");
        replacements.push(Replacement::new(name, (&file, &bytes), &file, &arguments));
    }
    let arguments = ["repair", "--quiet", "mesh.obj", "-o", "mesh.obj"];
    let input = ("mesh.obj", text.as_bytes());
    replacements.push(Replacement::new("repair onto itself".to_owned(), input, "mesh.obj", &arguments));
    replacements
}

#[test]
fn whenever_a_run_is_killed_the_file_is_the_old_or_the_new_one() {
    let kills = std::env::var("MESHMEND_KILLS").map_or(50, |kills| kills.parse().unwrap());
    let replacements = replacements();
    let mut instants = Instants::seeded();
    let (mut old, mut debris) = (0, 0);
    for replacement in replacements.iter().cycle().take(kills) {
        let (is_old, has_debris) = replacement.kill(&mut instants);
        old += usize::from(is_old);
        debris += usize::from(has_debris);
    }
    println!(
        "{kills} kills of {} commands: {old} left the old file, {} the new one; {debris} left debris, cleared \
         by the next run",
        replacements.len(),
        kills - old
    );
}
