//! Every option of every command, as the command line describes itself: without a value, with a bad one and with a
//! good one. The parser has to take what is good and nothing else, and whatever it takes, a run has to keep the
//! promises that fuzzing asks for.

use clap::{Arg, ArgAction, Command};
use meshmend_cli::description;
use meshmend_fuzz::arguments;

/// No option takes this for a value, unless it takes any text.
const BAD: &str = "?";

/// A value that an argument takes, and whether it is any text that it takes.
fn good(argument: &Arg) -> (String, bool) {
    if let Some(value) = argument.get_possible_values().first() {
        return (value.get_name().to_owned(), false);
    }
    let place = argument.get_value_names().and_then(|names| names.first()).map_or("", |name| name.as_str());
    let (value, takes_any_text) = match (argument.get_id().as_str(), place) {
        ("plan", _) => ("plan.toml", true),
        ("name", _) => ("weld", true),
        ("report", _) => ("new.json", true),
        (_, "OUT") => ("new.ply", true),
        (_, "PAGE") => ("new.html", true),
        (_, "TITLE") => ("a page", true),
        (_, "PICTURE" | "OUT.svg") => ("new.svg", true),
        ("maps", _) => ("maps.npz", true),
        (_, "PROCESS") => ("1", false),
        (_, "OUT.mtx") => ("new.mtx", true),
        (_, "IN" | "FILE" | "LIST") => ("broken.obj", true),
        ("from", "V") => ("v0", false),
        (_, "CELLS") => ("v0", false),
        (_, "FIELDS") => ("2", false),
        (_, "N" | "V" | "G" | "M" | "B" | "K") => ("3", false),
        (_, "SIZE") => ("4GiB", false),
        (_, "TIME") => ("60s", false),
        (_, "STATUS") => ("crashed", false),
        (_, "DIR" | "S") => ("new", true),
        ("ledger", _) => ("new.jsonl", true),
        (_, "TIMES") => ("1", false),
        (_, "DEGREES") => ("-30", false),
        (_, "WxH") => ("320x240", false),
        (_, "X,Y,Z") => ("1,-2,3", false),
        (_, "CELL") => ("v0", false),
        (_, "SHAPE") => ("torus", false),
        (_, "DISTANCE") => ("1%", false),
        (_, "LIMITS") => ("all", false),
        (_, "LIMIT") => ("faces:12", false),
        (_, "R") => ("1000", false),
        (_, "LENGTH") => ("1%", false),
        // Which kinds there are hangs on the rules of the program, which judges the word itself.
        (_, "KIND") => ("degenerate-face", true),
        (_, "FORMAT") => ("ply", false),
        // Which kernels there are too.
        ("kernel", _) => ("edge-use", true),
        // Which parts there are hangs on the file.
        ("parts", _) => ("0", true),
        (id, place) => panic!("which value does {id} {place} take?"),
    };
    (value.to_owned(), takes_any_text)
}

fn is_flag(argument: &Arg) -> bool {
    !argument.get_action().takes_values()
}

/// A command with what it needs beside one argument: what it can't do without, and an output.
fn least(command: &Command, but: &Arg) -> Vec<String> {
    let mut words = vec![command.get_name().to_owned()];
    let is_in_the_way = |argument: &Arg| {
        let names = |one: &Arg, other: &Arg| {
            command.get_arg_conflicts_with(one).iter().any(|named| named.get_id() == other.get_id())
        };
        // Either of two that are in each other's way may say so.
        argument.get_id() == but.get_id() || names(but, argument) || names(argument, but)
    };
    for argument in command.get_arguments().filter(|argument| !is_in_the_way(argument)) {
        if argument.is_positional() {
            words.push(good(argument).0);
        } else if argument.is_required_set() || argument.get_id() == "output" {
            words.extend([option(argument), good(argument).0]);
        }
    }
    // What an option asks for beside itself is not told by its description.
    if command.get_name() == "kernels" && ["runs", "json", "svg"].contains(&but.get_id().as_str()) {
        words.push("--bench".to_owned());
    }
    match (command.get_name(), but.get_id().as_str()) {
        ("matrix", "walks") => words.extend(["--from", "v0"].map(str::to_owned)),
        ("batch", "retry") => words.push("--resume".to_owned()),
        ("check", "spill") => words.extend(["--memory", "1GiB"].map(str::to_owned)),
        ("matrix", "from") => words.extend(["--walks", "3"].map(str::to_owned)),
        ("pointers", "at" | "all" | "permutations") => {}
        ("pointers", _) => words.extend(["--at", "v0"].map(str::to_owned)),
        _ => {}
    }
    words
}

fn option(argument: &Arg) -> String {
    format!("--{}", argument.get_long().expect("every option has a long name"))
}

fn is_taken(words: &[String]) -> bool {
    description()
        .try_get_matches_from(std::iter::once("meshmend").chain(words.iter().map(String::as_str)))
        .is_ok()
}

/// Runs a command line; gives whether the parser takes it.
fn run(words: &[String]) -> bool {
    println!("{}", words.join(" "));
    arguments(words.join("\n").as_bytes());
    is_taken(words)
}

#[test]
fn every_option_takes_its_values_and_no_other() {
    let mut count = 0;
    let mut whole = description();
    whole.build();
    for command in whole.get_subcommands().filter(|command| command.get_name() != "help") {
        let options = command.get_arguments().filter(|argument| !argument.is_positional());
        for argument in options.filter(|argument| !matches!(argument.get_action(), ArgAction::Help)) {
            let words = |value: &str| match argument.is_require_equals_set() {
                true => vec![format!("{}={value}", option(argument))],
                false => vec![option(argument), value.to_owned()],
            };
            let with = |value: &str| [least(command, argument), words(value)].concat();
            let bare = [least(command, argument), vec![option(argument)]].concat();
            let needs_no_value = argument.get_num_args().is_some_and(|count| count.min_values() == 0);
            assert_eq!(run(&bare), needs_no_value, "{bare:?}");
            if is_flag(argument) {
                continue;
            }
            let (value, takes_any_text) = good(argument);
            assert!(run(&with(&value)), "{:?}", with(&value));
            assert_eq!(run(&with(BAD)), takes_any_text, "{:?}", with(BAD));
            count += 1;
        }
    }
    assert!(count > 20, "{count} options with a value");
}

#[test]
fn every_command_runs_with_the_least_that_it_takes_and_tells_help() {
    let whole = description();
    let anything = Arg::new("none of them");
    for command in whole.get_subcommands() {
        let words = least(command, &anything);
        assert!(run(&words), "{words:?}");
        let help = [&words[..1], &["--help".to_owned()]].concat();
        assert!(!run(&help), "help is no run");
    }
}
