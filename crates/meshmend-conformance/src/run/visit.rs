//! The laws asked on one mesh after the other.

use std::sync::Arc;

use meshmend_core::{Build, Complex, Connectivity, CornerId};

use super::event::{Event, Example, Job};
use super::findings::{Answer, Findings, finding};
use super::needs::claimed;
use super::opposite::OppositeOf;
use crate::Soup;
use crate::guard::{At, Guarded, Place, Query, caught};
use crate::laws::{
    Asked, Basis, Check, Expected, Sizes, built, checks, growth, is_cross_check, number, size,
};
use crate::worlds::{FAMILIES, Family, World, shrunk, sized_meshes};

/// What is asked on a mesh.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Look {
    /// The laws that look at plain lists.
    Plain,
    /// Also those about answers that are made of others.
    Close,
    /// Also the cross-check, and whether a refusal has every reason, which takes admission twice.
    Whole,
}

/// A run over the meshes of a world.
pub(crate) struct Visit<'a, K> {
    job: &'a Job,
    place: &'a Arc<Place>,
    opposite: OppositeOf<K>,
    findings: Findings<'a>,
    checks: Vec<Check<Guarded<K>>>,
    mesh: u32,
    held: u32,
}

/// Each how many meshes the run says where it is.
const LAP: u32 = 64;
/// Of the meshes of which there are many, one in so many has a close look, and one in so many the whole one.
const OFTEN: u32 = 8;
const SELDOM: u32 = 64;
/// Faces, or corners of one face, of the meshes on which growth is watched.
const SIZES: [usize; 2] = [2_500, 20_000];

impl<'a, K: Connectivity> Visit<'a, K> {
    pub(crate) fn new(
        job: &'a Job,
        place: &'a Arc<Place>,
        opposite: OppositeOf<K>,
        tell: &'a mut dyn FnMut(Event),
    ) -> Self {
        let findings = Findings::new(tell, &job.shut, claimed(&K::CAPABILITIES));
        Visit { job, place, opposite, findings, checks: checks(), mesh: 0, held: 0 }
    }

    /// Asks every law but the size.
    pub(crate) fn over(mut self, world: &World) {
        for number in self.job.from..world.len() as u32 {
            self.mesh = number;
            if number.is_multiple_of(LAP) || number == self.job.from {
                self.findings.tell(Event::At(number));
            }
            let candidate = world.mesh(number as usize);
            let is_one_in = |many| !candidate.is_one_of_many || number.is_multiple_of(many);
            let look = if is_one_in(SELDOM) {
                Look::Whole
            } else if is_one_in(OFTEN) {
                Look::Close
            } else {
                Look::Plain
            };
            self.on(&candidate.soup, candidate.is_random, look);
        }
        for (family, number) in FAMILIES.iter().zip(world.len() as u32..) {
            if number >= self.job.from {
                self.mesh = number;
                self.findings.tell(Event::At(number));
                self.grow(family);
            }
        }
        self.findings.tell(Event::Done { tried: world.len() as u32, held: self.held });
    }

    /// Measures the size of the kernel over meshes of some size.
    pub(crate) fn sizes(mut self, allocated: fn() -> usize) {
        let meshes = sized_meshes();
        for (number, (name, soup)) in (0..).zip(&meshes) {
            self.mesh = number;
            self.findings.tell(Event::At(number));
            self.go_on("size");
            let complex = soup.complex();
            let holds = caught(|| built::<K>(&complex).is_ok_and(|kernel| kernel.is_some()));
            self.held += u32::from(holds == Ok(true));
            let answer = match holds {
                Ok(true) => caught(|| size::<K>(soup.complex(), allocated)),
                Ok(false) => Ok(Ok(())),
                Err(stopped) => Err(stopped),
            };
            self.findings.judge(self.place.at(), answer, None, || Example::of_family((*name).to_owned()));
        }
        self.findings.tell(Event::Done { tried: meshes.len() as u32, held: self.held });
    }

    /// All laws on one mesh.
    fn on(&mut self, soup: &Soup, is_random: bool, look: Look) {
        let mesh = (look == Look::Whole).then(|| soup.mesh());
        let made;
        let complex = match &mesh {
            Some(mesh) => mesh.complex(),
            None => {
                made = soup.complex();
                &made
            }
        };
        let (at, answer, kernel) = self.build(complex, look == Look::Whole);
        self.findings.judge(at, answer, Some(complex), || Example::of(soup));
        let Some(kernel) = kernel else { return };
        self.held += 1;
        let expected = Expected::of(complex);
        let opposite = self.opposite.map(|opposite| opposed(&kernel, opposite));
        let opposite = opposite.as_ref().map(|opposite| opposite as &dyn Fn(CornerId) -> Option<CornerId>);
        let asked = Asked { kernel: &kernel, expected: &expected, mesh: mesh.as_ref(), opposite };
        let mut are_lists_kept = true;
        for at in 0..self.checks.len() {
            let Check { law, basis, ask } = self.checks[at];
            let is_due = look >= if is_cross_check(law) { Look::Whole } else { Look::Close };
            let is_off = basis == Basis::Answers && !(are_lists_kept && is_due);
            if is_off || self.findings.is_shut(number(law.id)) {
                continue;
            }
            self.go_on(law.id);
            let answer = caught(|| ask(&asked));
            are_lists_kept &= matches!(answer, Ok(Ok(())));
            let is_first = self.findings.judge(self.place.at(), answer, Some(complex), || Example::of(soup));
            if is_first && is_random {
                self.shrink(at, soup);
            }
        }
    }

    /// The kernel over a complex, with what came of building it.
    fn build(&self, complex: &Complex, is_sampled: bool) -> (At, Answer, Option<Guarded<K>>) {
        self.go_on("assembly");
        self.place.ask(Query::ASSEMBLE, 0);
        let built = caught(|| if is_sampled { built::<K>(complex) } else { Ok(K::build(complex).ok()) });
        let mut at = self.place.at();
        match built {
            Ok(Ok(kernel)) => {
                (at, Ok(Ok(())), kernel.map(|kernel| Guarded::new(kernel, complex, self.place)))
            }
            Ok(Err(breach)) => {
                at.law = number("refusal");
                (at, Ok(Err(breach)), None)
            }
            Err(stopped) => (at, Err(stopped), None),
        }
    }

    /// Looks for a smaller mesh that breaks a law, which a random mesh was found to break.
    fn shrink(&mut self, check: usize, soup: &Soup) {
        let least = shrunk(soup, |soup| self.broken_on(check, soup).is_some());
        let example = Example { is_shrunk: true, ..Example::of(&least) };
        if let Some((at, answer)) = self.broken_on(check, &least)
            && let Some(finding) = finding(at, answer, example)
        {
            self.findings.tell(Event::Found(finding));
        }
    }

    /// How a law is broken on a mesh, and where; `None` where it is kept or not asked.
    fn broken_on(&self, check: usize, soup: &Soup) -> Option<(At, Answer)> {
        let complex = soup.complex();
        let kernel = self.build(&complex, true).2?;
        let expected = Expected::of(&complex);
        let opposite = self.opposite.map(|opposite| opposed(&kernel, opposite));
        let opposite = opposite.as_ref().map(|opposite| opposite as &dyn Fn(CornerId) -> Option<CornerId>);
        let mesh = soup.mesh();
        let asked = Asked { kernel: &kernel, expected: &expected, mesh: Some(&mesh), opposite };
        let ask = |check: &Check<Guarded<K>>| {
            self.go_on(check.law.id);
            caught(|| (check.ask)(&asked))
        };
        let judged = &self.checks[check];
        let lists = self.checks.iter().filter(|check| check.basis == Basis::Lists);
        if judged.basis == Basis::Answers && !lists.map(ask).all(|answer| matches!(answer, Ok(Ok(())))) {
            return None;
        }
        let answer = ask(judged);
        (!matches!(answer, Ok(Ok(())))).then(|| (self.place.at(), answer))
    }

    /// The cost of answers on a family of meshes.
    fn grow(&mut self, family: &Family) {
        let Some(meshes) = SIZES.map(|size| family.of_size(size)).into_iter().collect::<Option<Vec<_>>>()
        else {
            return;
        };
        let name = family.said();
        let mut kernels = Vec::new();
        for mesh in &meshes {
            let (at, answer, kernel) = self.build(mesh.complex(), true);
            self.findings.judge(at, answer, Some(mesh.complex()), || Example::of_family(name.clone()));
            kernels.extend(kernel);
        }
        if self.findings.is_shut(number("growth")) {
            return;
        }
        self.go_on("growth");
        if let ([small, large], [small_mesh, large_mesh]) = (kernels.as_slice(), meshes.as_slice()) {
            let complexes = [small_mesh.complex(), large_mesh.complex()];
            let sizes = Sizes { family: &name, complexes, is_crowded: family.is_crowded };
            let answer = growth([small, large], &sizes, &|| self.place.tick());
            self.findings.judge(self.place.at(), answer, None, || Example::of_family(name.clone()));
        }
    }

    /// Goes on to a law on the mesh that is looked at.
    fn go_on(&self, law: &str) {
        let is_closed = |&&(_, from): &&(u8, u32)| from <= self.mesh;
        let closed = self.job.closed.iter().filter(is_closed).fold(0, |all, (query, _)| all | 1u64 << query);
        self.place.go_on(self.mesh, number(law), closed);
    }
}

/// What a guarded kernel says is opposite.
fn opposed<'a, K: Connectivity>(
    kernel: &'a Guarded<K>,
    opposite: fn(&K, CornerId) -> Option<CornerId>,
) -> impl Fn(CornerId) -> Option<CornerId> + 'a {
    move |corner| kernel.ask(Query::OPPOSITE, corner.0, |kernel| opposite(kernel, corner))
}
