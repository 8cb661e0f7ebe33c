//! What happens where two touch: the entry of the pair, else what one of the two says, else what the scene says.

use super::super::fault::Fault;
use super::super::kind::{FaultKind, PairFault};
use super::super::reader::{Fields, Path, Reader, span_of};
use super::super::{show, suggest};
use super::body::Item;
use super::material::{FRICTION_HELP, Setting, Settings};
use crate::model::{Body, Compliance, Material, Obstacle, Restitution, Space};
use jsonc_parser::ast::Value;
use std::collections::HashMap;
use std::ops::Range;

const PAIR_HELP: &str = r#"write {"between": ["peg", "floor"], "friction": 0.3}"#;

/// A body or a fixed thing, bodies first.
struct Party<'a> {
    name: &'a str,
    span: Range<usize>,
    settings: &'a Settings,
    is_free: bool,
    is_body: bool,
}

impl Reader {
    /// A row for each body, a column for each body and fixed thing.
    pub fn materials<S: Space>(
        &mut self,
        bodies: &[Item<Body<S>>],
        fixed: &[Item<Obstacle<S>>],
        fields: &Fields,
        path: &Path,
    ) -> Option<Vec<Material>> {
        let parties: Vec<Party> =
            bodies.iter().map(|item| party(item, true)).chain(fixed.iter().map(|item| party(item, false))).collect();
        let scene = self.settings(fields, path);
        let names = self.names(&parties, path);
        let pairs = self.pairs(fields, path, &parties, &names);
        let mut table = vec![None; bodies.len() * parties.len()];
        let mut frictionless: Vec<[usize; 2]> = Vec::new();
        let mut is_whole = true;
        for a in 0..bodies.len() {
            for b in a + 1..parties.len() {
                let between = [&parties[a], &parties[b]];
                // what cannot be moved by a contact needs none of this
                if between.iter().all(|party| !party.is_free) {
                    continue;
                }
                let pair = pairs.get(&[a, b]);
                let friction = self.choose(between, pair, &scene, "friction", |settings| &settings.friction);
                let restitution = self.choose(between, pair, &scene, "restitution", |settings| &settings.restitution);
                let contact = self.choose(between, pair, &scene, "contact", |settings| &settings.contact);
                if friction == Some(None) {
                    frictionless.push([a, b]);
                }
                let (Some(friction), Some(restitution), Some(compliance)) = (friction, restitution, contact) else {
                    is_whole = false;
                    continue;
                };
                let restitution = restitution.unwrap_or(Restitution::Newton(0.0));
                let material = Material { friction: friction.unwrap_or(0.0), restitution, compliance };
                table[a * parties.len() + b] = Some(material);
                if b < bodies.len() {
                    table[b * parties.len() + a] = Some(material);
                }
            }
        }
        self.no_friction(&frictionless, &parties, fields, path);
        let unfelt = Material { friction: 0.0, restitution: Restitution::Newton(0.0), compliance: None };
        is_whole.then(|| table.into_iter().map(|material| material.unwrap_or(unfelt)).collect())
    }

    /// Every name with its number; a name given twice is a fault.
    fn names<'a>(&mut self, parties: &[Party<'a>], path: &Path) -> HashMap<&'a str, usize> {
        let mut names = HashMap::new();
        for (index, party) in parties.iter().enumerate() {
            let Some(first) = names.get(party.name).copied() else {
                names.insert(party.name, index);
                continue;
            };
            let n_bodies = parties.iter().filter(|party| party.is_body).count();
            let (list, at) = if party.is_body { ("bodies", index) } else { ("fixed", index - n_bodies) };
            let fault = Fault::new(FaultKind::RepeatedName { name: show::clipped(party.name) });
            let fault = fault.at(party.span.clone()).on(path.key(list).index(at).key("name").to_string());
            let first: &Party = &parties[first];
            self.push(fault.help("give it another name").related(first.span.clone(), "its first bearer"));
        }
        names
    }

    /// What the entries of `pairs` say, by the numbers of the two, the smaller first.
    fn pairs(
        &mut self,
        fields: &Fields,
        path: &Path,
        parties: &[Party],
        names: &HashMap<&str, usize>,
    ) -> HashMap<[usize; 2], Settings> {
        let mut found: HashMap<[usize; 2], (Settings, Range<usize>)> = HashMap::new();
        let (Some(value), path) = (fields.get("pairs"), path.key("pairs")) else {
            return HashMap::new();
        };
        let Some(array) = self.array(value, &path, PAIR_HELP) else {
            return HashMap::new();
        };
        for (index, element) in array.elements.iter().enumerate() {
            let path = path.index(index);
            let known = ["between", "friction", "restitution", "contact"];
            let Some(fields) = self.fields(element, &path, &known, PAIR_HELP) else { continue };
            let settings = self.settings(&fields, &path);
            let Some(value) = self.require(&fields, "between", &path, PAIR_HELP) else { continue };
            let path = path.key("between");
            let Some(between) = self.between(value, &path, names) else { continue };
            let twice = found.get(&between).map(|(_, span)| span.clone());
            let fault = match between {
                [a, b] if a == b => Some((PairFault::Same, "a body does not touch itself")),
                between if between.iter().all(|party| !parties[*party].is_body) => {
                    Some((PairFault::Fixed, "name a body and what it touches"))
                }
                _ => twice.is_some().then_some((PairFault::Twice, "keep one of the two")),
            };
            if let Some((kind, help)) = fault {
                let fault = Fault::new(FaultKind::Pair(kind)).at(span_of(value)).on(path.to_string()).help(help);
                self.push(match twice {
                    Some(first) => fault.related(first, "first given here"),
                    None => fault,
                });
                continue;
            }
            found.insert(between, (settings, span_of(value)));
        }
        found.into_iter().map(|(between, (settings, _))| (between, settings)).collect()
    }

    fn between(&mut self, value: &Value, path: &Path, names: &HashMap<&str, usize>) -> Option<[usize; 2]> {
        let elements = &self.array(value, path, PAIR_HELP)?.elements;
        if elements.len() != 2 {
            self.fault(FaultKind::Pair(PairFault::Same), span_of(value), path, PAIR_HELP);
            return None;
        }
        let mut number = |index: usize| {
            let (value, path) = (&elements[index], path.index(index));
            let name = self.string(value, &path, PAIR_HELP)?;
            let number = names.get(name).copied();
            if number.is_none() {
                let mut known: Vec<&str> = names.keys().copied().collect();
                known.sort_unstable();
                let help = suggest::nearest(name, &known).map_or_else(
                    || "give the name of a body or of something fixed".to_owned(),
                    |near| format!("did you mean `{}`?", show::clipped(near)),
                );
                self.fault(FaultKind::NoSuchName { name: show::clipped(name) }, span_of(value), &path, help);
            }
            number
        };
        let (a, b) = (number(0), number(1));
        let (a, b) = (a?, b?);
        Some([a.min(b), a.max(b)])
    }

    /// The setting of a pair: `Some(None)` where nothing states it, `None` after a fault.
    fn choose<T: Copy + PartialEq + Entry>(
        &mut self,
        between: [&Party; 2],
        pair: Option<&Settings>,
        scene: &Settings,
        key: &'static str,
        of: impl Fn(&Settings) -> &Setting<T>,
    ) -> Option<Option<T>> {
        match pair.map(&of) {
            Some(Setting::Given(value, _)) => return Some(Some(*value)),
            Some(Setting::Faulty) => return None,
            Some(Setting::Absent) | None => {}
        }
        match between.map(|party| of(party.settings)) {
            [Setting::Faulty, _] | [_, Setting::Faulty] => None,
            [Setting::Given(first, one), Setting::Given(second, two)] if first != second => {
                let [a, b] = between.map(|party| show::clipped(party.name));
                let kind = FaultKind::Disagreement { key, first: a.clone(), second: b.clone() };
                let entry = format!(r#""pairs": [{{"between": ["{a}", "{b}"], "{key}": {}}}]"#, first.entry());
                let fault = Fault::new(kind).at(two.clone()).on("scene.pairs".to_owned());
                self.push(fault.help(format!("say which by {entry}")).related(one.clone(), "the other value"));
                None
            }
            [Setting::Given(value, _), _] | [_, Setting::Given(value, _)] => Some(Some(*value)),
            [Setting::Absent, Setting::Absent] => match of(scene) {
                Setting::Given(value, _) => Some(Some(*value)),
                Setting::Absent => Some(None),
                Setting::Faulty => None,
            },
        }
    }

    fn no_friction(&mut self, pairs: &[[usize; 2]], parties: &[Party], fields: &Fields, path: &Path) {
        let Some([a, b]) = pairs.first() else { return };
        let others = match pairs.len() - 1 {
            0 => String::new(),
            1 => " and one pair more".to_owned(),
            more => format!(" and {more} pairs more"),
        };
        let [first, second] = [a, b].map(|party| show::clipped(parties[*party].name));
        let help = format!(
            r#"{FRICTION_HELP}: "friction" in the scene, in one of the two, or in "pairs": [{{"between": ["{first}", "{second}"], "friction": 0.2}}]"#
        );
        self.fault(FaultKind::NoFriction { first, second, others }, fields.span.clone(), &path.key("friction"), help);
    }
}

/// A setting as a file writes it.
trait Entry {
    fn entry(&self) -> String;
}

impl Entry for f64 {
    fn entry(&self) -> String {
        self.to_string()
    }
}

impl Entry for Restitution {
    fn entry(&self) -> String {
        match self {
            Self::Newton(e) => e.to_string(),
            Self::Poisson(e) => format!(r#"{{"poisson": {e}}}"#),
        }
    }
}

impl Entry for Compliance {
    fn entry(&self) -> String {
        let Self { stiffness, damping, gamma } = self;
        format!(r#"{{"stiffness": {stiffness:?}, "damping": {damping:?}, "gamma": {gamma:?}}}"#)
    }
}

fn party<T>(item: &Item<T>, is_body: bool) -> Party<'_> {
    Party { name: &item.name, span: item.span.clone(), settings: &item.settings, is_free: item.is_free, is_body }
}
