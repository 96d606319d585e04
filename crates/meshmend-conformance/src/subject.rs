//! A kernel under test, and how its laws are asked.

use std::process::exit;
use std::sync::OnceLock;

use meshmend_core::{Capabilities, Connectivity};

use crate::Settings;
use crate::laws::{Breach, capacity, number};
use crate::run::{
    Ask, Example, Finding, Job, OppositeOf, Visit, asked_here, claimed, folder_of_child, guarded, run_child,
};
use crate::verdict::Verdicts;

/// A kernel under test. The macros make one; it is made by hand where verdicts are looked at instead of asserted.
///
/// ```no_run
/// use meshmend_conformance::{Settings, Subject};
/// use meshmend_core::EdgeUse;
///
/// // In a test function: the process that asks the laws is this program again, with that test alone.
/// let verdicts = Subject::of::<EdgeUse>().in_test("my_tests::edge_use").verdicts(&Settings::default())?;
/// assert!(verdicts.are_all_kept());
/// # Ok::<(), String>(())
/// ```
pub struct Subject {
    kernel: &'static str,
    claimed: u8,
    capacity: Result<(), Breach>,
    arguments: Vec<String>,
    is_of_size: bool,
    ask: Box<Ask>,
    verdicts: OnceLock<Result<Verdicts, String>>,
}

impl Subject {
    /// A kernel whose laws are asked by a program that calls [`verdicts`](Subject::verdicts) first of all.
    pub fn of<K: Connectivity + 'static>() -> Self {
        Self::with_opposite::<K>(None)
    }

    /// As [`of`](Subject::of), with what the kernel says is opposite.
    #[doc(hidden)]
    pub fn with_opposite<K: Connectivity + 'static>(opposite: OppositeOf<K>) -> Self {
        let ask: Box<Ask> = Box::new(move |job, place, world, tell| {
            Visit::<K>::new(job, place, opposite, tell).over(world);
        });
        Subject {
            kernel: K::NAME,
            claimed: claimed(&K::CAPABILITIES),
            capacity: Ok(()),
            arguments: Vec::new(),
            is_of_size: false,
            ask,
            verdicts: OnceLock::new(),
        }
    }

    /// The size of a kernel, in a program whose allocator counts.
    #[doc(hidden)]
    pub fn measured<K: Connectivity + 'static>(allocated: fn() -> usize) -> Self {
        let ask: Box<Ask> = Box::new(move |job, place, _, tell| {
            Visit::<K>::new(job, place, None, tell).sizes(allocated);
        });
        Subject { is_of_size: true, ask, ..Self::of::<K>() }
    }

    /// The same kernel, whose laws are asked in a test: the path of the function, with or without the crate.
    #[must_use]
    pub fn in_test(self, path: &str) -> Self {
        let test = path.split_once("::").map_or(path, |(_, test)| test);
        let options = ["--exact", "--include-ignored", "--nocapture", "--test-threads=1"];
        let arguments = [test].iter().chain(&options).map(|&argument| argument.to_owned()).collect();
        Subject { arguments, ..self }
    }

    /// The same kernel, which has to hold all that some capabilities admit.
    #[must_use]
    pub fn at_least<K: Connectivity>(self, least: Capabilities) -> Self {
        Subject { capacity: capacity::<K>(&least), ..self }
    }

    /// The verdict on each law. In the process that was begun for it, asks the laws and does not come back.
    ///
    /// # Errors
    /// When the laws can't be asked.
    ///
    /// *Cost*: some seconds with the usual effort, and the patience for each question that does not come back.
    pub fn verdicts(&self, settings: &Settings) -> Result<Verdicts, String> {
        if let Some(folder) = folder_of_child() {
            exit(i32::from(run_child(&folder, &*self.ask).is_err()));
        }
        let job = Job {
            effort: settings.effort,
            patience: settings.patience.as_millis().max(1) as u64,
            is_of_size: self.is_of_size,
            shut: Vec::new(),
            closed: Vec::new(),
            from: 0,
            is_recorded: false,
        };
        let mut results = if settings.in_process {
            asked_here(&job, &*self.ask)
        } else {
            guarded(self.kernel, &self.arguments, job)?
        };
        results.blame_capabilities(self.claimed);
        if let Err(breach) = self.capacity.clone() {
            results.find(Finding::wrong(number("capacity"), Example::default(), breach));
        }
        let verdicts = Verdicts::of(self.kernel, settings.effort, self.is_of_size, results);
        verdicts.write();
        Ok(verdicts)
    }

    /// Asserts that a law is kept, as the environment says how; the laws are asked once.
    ///
    /// # Panics
    /// When the law is broken, with the verdict; or when the laws can't be asked.
    #[doc(hidden)]
    #[track_caller]
    pub fn assert_kept(&self, law: &str) {
        let asked = || self.verdicts(&Settings::from_environment()?);
        match self.verdicts.get_or_init(asked) {
            Ok(verdicts) => assert!(verdicts.is_kept(law), "{}", verdicts.text(law)),
            Err(reason) => assert!(reason.is_empty(), "{reason}"),
        }
    }
}
