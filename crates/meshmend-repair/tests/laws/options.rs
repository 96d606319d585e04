//! Every pass with every choice of its options, found by asking: a plan that says a word which an option does not know
//! is answered with the words that it knows.

use meshmend_repair::{AnyPass, PassKind, Plan};
use serde_json::{Map, Value, json};

/// What an option that takes a number is given.
const AMOUNTS: [f64; 3] = [0.0, 0.3, 1.0];

/// Every pass of the registry with every choice of its options.
pub(crate) fn every_choice() -> Vec<AnyPass> {
    PassKind::ALL.iter().flat_map(|&kind| choices_of(kind)).collect()
}

/// A pass with every choice of its options, the defaults among them.
fn choices_of(kind: PassKind) -> Vec<AnyPass> {
    let plan = serde_json::to_value(Plan::default().with(kind)).unwrap();
    let defaults = plan[kind.name()].as_object().unwrap();
    let mut choices = vec![Map::new()];
    for (option, default) in defaults {
        let mut values = values_of(kind, option);
        if !values.contains(default) {
            values.push(default.clone());
        }
        assert!(!values.is_empty(), "nothing is known of the option {option} of {kind}");
        let with = |(choice, value): (&Map<String, Value>, &Value)| {
            let mut choice = choice.clone();
            choice.insert(option.clone(), value.clone());
            choice
        };
        choices =
            choices.iter().flat_map(|choice| values.iter().map(move |v| (choice, v))).map(with).collect();
    }
    choices.into_iter().map(|choice| pass(kind, choice.into()).unwrap()).collect()
}

fn values_of(kind: PassKind, option: &str) -> Vec<Value> {
    let is_taken = |value: &Value| pass(kind, json!({ option: value })).is_ok();
    let complaint = pass(kind, json!({ option: "?" })).unwrap_err().to_string();
    let known = complaint.split_once("expected").map_or("", |(_, known)| known);
    let words = known.split('`').skip(1).step_by(2);
    let limits = json!({ "edges": 5, "length": { "relative": 0.9 } });
    let alone_or_with_amounts = |word: &str| {
        let amounts = AMOUNTS.map(|amount| json!({ word: amount }));
        std::iter::once(json!(word)).chain(amounts).chain([json!({ word: limits })])
    };
    let numbers = AMOUNTS.map(|amount| json!(amount));
    words.flat_map(alone_or_with_amounts).chain(numbers).filter(is_taken).collect()
}

fn pass(kind: PassKind, options: Value) -> Result<AnyPass, serde_json::Error> {
    let plan: Plan = serde_json::from_value(json!({ "passes": [kind], kind.name(): options }))?;
    Ok(plan.pipeline().passes()[0].clone())
}

#[test]
fn all_choices_are_found() {
    let all = every_choice();
    for &kind in PassKind::ALL {
        let choices: Vec<&AnyPass> = all.iter().filter(|pass| pass.kind() == kind).collect();
        assert!(choices.contains(&&kind.with_defaults()), "{kind}");
        let is_new = |place: usize| !choices[..place].contains(&choices[place]);
        assert!((0..choices.len()).all(is_new), "{kind} has a choice twice");
    }
    let count = |kind| all.iter().filter(|pass| pass.kind() == kind).count();
    assert_eq!(count(PassKind::Weld), 2 * (3 + 4 * AMOUNTS.len()));
    assert_eq!(count(PassKind::Orient), 3 * 3 * 3 * 2);
}
