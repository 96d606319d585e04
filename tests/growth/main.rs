//! How the cost of checks and repairs grows on meshes on which careless code is quadratic.
//!
//! Each family is made at one size and at about twice that. A cost grows too fast if twice the size takes more than
//! [`MOST_GROWTH`] times as much: n log n takes 2.1 times as much at these sizes, n √n takes 2.8.
//!
//! * As a test: memory, at its peak and allocated in all, on small meshes. Time judges nothing, since it varies with the
//!   machine: where it seems to grow too fast, instructions are counted, and they judge.
//! * With a size: instructions as well, which needs valgrind. Names of work may follow, such as check, repair, cut,
//!   pinch-only, outward-nested, files, render.
//!   `cargo test --release -p meshmend-tests --test growth -- 500000`
//!
//! Each figure is of a process of its own on one thread, so it is the same every time.

mod cost;
mod families;
mod work;

use std::process::ExitCode;

use cost::{Comparison, Cost, Meter};
use families::FAMILIES;
use work::Work;

#[global_allocator]
static ALLOCATOR: cap::Cap<std::alloc::System> = cap::Cap::new(std::alloc::System, usize::MAX);

/// How much more may be taken where there is twice as much.
const MOST_GROWTH: f64 = 2.3;
/// How many faces or corners the smaller mesh of a test has, about.
const SMALL: usize = 10_000;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let is_well = match &words[..] {
        [] => compare(SMALL, Meter::Memory, &Work::ALL),
        [size, works @ ..] => match (size.parse(), Work::all_named(works)) {
            (Ok(size), Some(works)) => compare(size, Meter::Instructions, &works),
            _ => measured(&words),
        },
    };
    if is_well { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Prints how everything grows from a size on; gives whether nothing grows too fast.
fn compare(size: usize, meter: Meter, works: &[Work]) -> bool {
    println!("{}", Comparison::HEAD);
    let mut is_well = true;
    for family in FAMILIES {
        let of_both = |work, meter| [size, 2 * size].map(|size| Cost::of(family, size, work, meter));
        let made = of_both(Work::Make, meter);
        for &work in works.iter().filter(|work| !grows_by_nature(family.name, **work)) {
            let compared = |meter| {
                let made = if meter == Meter::Memory { made.clone() } else { of_both(Work::Make, meter) };
                let [less, more] = of_both(work, meter);
                Comparison { family, work, costs: [less.beyond(&made[0]), more.beyond(&made[1])] }
            };
            let mut comparison = compared(meter);
            if meter == Meter::Memory && comparison.seems_too_slow() {
                if cost::has_valgrind() {
                    comparison = compared(Meter::Instructions);
                } else {
                    println!("{}, {}: seems slow; without valgrind not counted", family.name, work.name());
                }
            }
            println!("{comparison}");
            is_well &= comparison.growths().into_iter().flatten().all(|growth| growth <= MOST_GROWTH);
        }
    }
    is_well
}

/// Tetrahedra in general position on one vertex are needles, more and more of which touch each other as far as doubles
/// tell; shells that touch are asked about in pairs.
fn grows_by_nature(family: &str, work: Work) -> bool {
    family == "umbrellas" && work == Work::OutwardNested
}

/// Does what this program asks itself for in a process of its own: a family, a size and a work. Anything else is the
/// name of another test.
fn measured(words: &[String]) -> bool {
    let [family, size, work] = words else { return true };
    let family = FAMILIES.iter().find(|known| known.name == family);
    let (Some(family), Ok(size), Some(work)) = (family, size.parse(), Work::named(work)) else { return true };
    let (mesh, shell) = family.mesh(size);
    work.run(&mesh, &shell);
    cost::print(&mesh, &ALLOCATOR);
    true
}
