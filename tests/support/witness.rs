//! Checks what the documents say about a wrench by arithmetic alone: Newton's law, the letters' table, the friction of
//! the case, and what each set is.

use super::cases::strings;
use super::modes::{Contact, Contacts};
use super::{Wrench, dot};
use num_traits::{Signed, Zero};
use partplan::exact::{Q, parse_literal};
use partplan::model::{Fixture, Part, Range};
use serde_json::Value;

/// One line on what is wrong.
pub type Check = Result<(), String>;

macro_rules! ensure {
    ($holds:expr, $($what:tt)*) => {
        if !$holds {
            return Err(format!($($what)*));
        }
    };
}

pub struct Checker {
    contacts: Contacts,
    /// Diagonal of M.
    mass: [Q; 3],
}

/// One contact of a motion.
struct At {
    a_n: Q,
    a_t: Q,
    c_n: Q,
    c_t: Q,
    friction: Option<Q>,
}

impl Checker {
    pub fn of(part: &Part, fixture: &Fixture) -> Self {
        let mass = [part.mass.clone(), part.mass.clone(), part.inertia.clone()];
        Self { contacts: Contacts::of(part, fixture), mass }
    }

    /// Modes over `s l r n`, `s` strict, that the programs find consistent with `g`.
    pub fn consistent(&self, g: &Wrench) -> Vec<String> {
        let modes = self.contacts.feasible_modes("blrn").into_iter();
        let mut modes: Vec<String> =
            modes.filter(|mode| self.contacts.consistent(mode, g)).map(|mode| mode.replace('b', "s")).collect();
        modes.sort();
        modes
    }

    /// Everything that the entry of one wrench says, the list of consistent modes only for itself.
    pub fn entry(&self, entry: &Value) -> Check {
        let g = triple(&entry["g"])?;
        let witness = &entry["witness"];
        for (set, shown_if) in
            [("weak", true), ("strong", false), ("goal", false), ("acyclic", false), ("unrefuted", false)]
        {
            let verdict = entry[set].as_bool().ok_or("no verdict")?;
            ensure!(witness[set].is_null() != (verdict == shown_if), "{set} is {verdict} and shown {}", witness[set]);
            if witness[set].is_null() {
                continue;
            }
            let check = match set {
                "weak" => self.weak(&g, &witness[set]),
                "strong" => self.strong(&g, &witness[set]),
                "goal" => self.goal(&g, &witness[set]),
                "acyclic" => self.acyclic(&g, &witness[set]),
                _ => self.unrefuted(&g, &witness[set]),
            };
            check.map_err(|fault| format!("{set}: {fault}"))?;
        }
        let (consistent, motions) = (strings(&entry["consistent"]), entry["motions"].as_object().ok_or("no motions")?);
        ensure!(motions.keys().eq(consistent.iter()), "motions of {:?}", motions.keys());
        for (mode, motion) in motions {
            ensure!(motion["mode"] == mode.as_str(), "{mode} is shown by {}", motion["mode"]);
            letters_in(motion, "slrn")?;
            self.motion(&g, motion, true).map_err(|fault| format!("{mode}: {fault}"))?;
        }
        Ok(())
    }

    /// At rest, and so under any coefficients of static friction.
    fn weak(&self, g: &Wrench, motion: &Value) -> Check {
        letters_in(motion, "n")?;
        ensure!(is_at_rest(motion)?, "not at rest");
        self.motion(g, motion, true)?;
        for (contact, at) in self.contacts.list.iter().zip(contacts(motion)?) {
            ensure!(at.c_t.abs() <= &contact.friction.static_.min * &at.c_n, "more than the least static friction");
        }
        Ok(())
    }

    fn strong(&self, g: &Wrench, motion: &Value) -> Check {
        letters_in(motion, "slrn")?;
        ensure!(!is_at_rest(motion)?, "at rest");
        self.motion(g, motion, true)
    }

    /// Formula (21).
    fn goal(&self, g: &Wrench, step: &Value) -> Check {
        letters_in(step, "smu")?;
        let (kept, lost) = (with(step, "m"), with(step, "s"));
        ensure!(lost.len() == 1, "formula (21) has one s");
        ensure!(self.states(step)? == (with(step, "ms"), kept), "the states are not those of the mode");
        self.motion(g, step, false)
    }

    fn acyclic(&self, g: &Wrench, steps: &Value) -> Check {
        let steps = steps.as_array().ok_or("no steps")?;
        ensure!(!steps.is_empty(), "no steps");
        for (step, next) in steps.iter().zip(steps.iter().cycle().skip(1)) {
            ensure!(step["to"] == next["from"], "the cycle is not closed");
            self.transition(g, step)?;
        }
        Ok(())
    }

    /// `C -> C \ D`: `s` (strict) on D, `m` on the rest of C; `C -> C + T`: `m` on C, `a` on T; `C -> C`, C not full: `m` on
    /// C, `s` elsewhere; else `u`.
    fn transition(&self, g: &Wrench, step: &Value) -> Check {
        let (from, to) = self.states(step)?;
        let n = self.contacts.list.len();
        let letter = |contact: usize| match (from.contains(&contact), to.contains(&contact)) {
            (true, true) => 'm',
            (true, false) => 's',
            (false, true) => 'a',
            (false, false) if from == to => 's',
            (false, false) => 'u',
        };
        let mode: String = (0..n).map(letter).collect();
        ensure!(step["mode"] == mode.as_str(), "the mode of {from:?} -> {to:?} is {mode}, not {}", step["mode"]);
        ensure!(from != to || from.len() < n, "the seated state may persist");
        ensure!(from == to || !(mode.contains('s') && mode.contains('a')), "contacts are lost and added at once");
        self.motion(g, step, from != to)
    }

    /// At rest on all contacts but one, or a seated contact breaks.
    fn unrefuted(&self, g: &Wrench, step: &Value) -> Check {
        letters_in(step, "slrn")?;
        let (from, to) = self.states(step)?;
        let n = self.contacts.list.len();
        if from == to {
            ensure!(is_at_rest(step)?, "not at rest");
            ensure!(from.len() < n, "at rest on all contacts");
            ensure!(with(step, "n") == from && with(step, "s").len() == n - from.len(), "the state is not the mode's");
            return self.motion(g, step, false);
        }
        ensure!(from.len() == n && to == with(step, "lrn"), "the states are not those of a break");
        self.motion(g, step, true)
    }

    /// Contacts before and after, each in order and once.
    fn states(&self, step: &Value) -> Result<(Vec<usize>, Vec<usize>), String> {
        let state = |key: &str| -> Result<Vec<usize>, String> {
            let list = step[key].as_array().ok_or(format!("no {key}"))?.iter();
            let state: Option<Vec<usize>> = list.map(|v| v.as_u64().and_then(|v| usize::try_from(v).ok())).collect();
            let state = state.ok_or(format!("{key} is no list of contacts"))?;
            let n = self.contacts.list.len();
            ensure!(state.is_sorted_by(|a, b| a < b) && state.iter().all(|contact| *contact < n), "{key} is no state");
            Ok(state)
        };
        Ok((state("from")?, state("to")?))
    }

    /// Newton's law, and at every contact what its letter asks for.
    fn motion(&self, g: &Wrench, motion: &Value, strict_s: bool) -> Check {
        let acceleration = triple(&motion["acceleration"])?;
        let mode = motion["mode"].as_str().ok_or("no mode")?;
        let at = contacts(motion)?;
        ensure!(at.len() == self.contacts.list.len() && mode.len() == at.len(), "one letter and one line a contact");
        for axis in 0..3 {
            let forces = self.contacts.list.iter().zip(&at);
            let sum: Q = forces.map(|(c, at)| &c.normal[axis] * &at.c_n + &c.tangent[axis] * &at.c_t).sum();
            ensure!(&self.mass[axis] * &acceleration[axis] == &g[axis] + sum, "Newton's law fails on axis {axis}");
        }
        for (index, ((contact, at), letter)) in self.contacts.list.iter().zip(&at).zip(mode.chars()).enumerate() {
            ensure!(dot(&contact.normal, &acceleration) == at.a_n, "contact {index}: a_n is not the part's");
            ensure!(dot(&contact.tangent, &acceleration) == at.a_t, "contact {index}: a_t is not the part's");
            at.is(letter, strict_s, contact).map_err(|fault| format!("contact {index} is no {letter}: {fault}"))?;
        }
        Ok(())
    }
}

impl At {
    fn is(&self, letter: char, strict_s: bool, contact: &Contact) -> Check {
        let Self { a_n, a_t, c_n, c_t, friction } = self;
        let kinematic = match letter {
            's' if strict_s => a_n.is_positive(),
            's' => !a_n.is_negative(),
            'a' => a_n.is_negative(),
            'u' => true,
            'l' => a_n.is_zero() && a_t.is_positive(),
            'r' => a_n.is_zero() && a_t.is_negative(),
            'n' => a_n.is_zero() && a_t.is_zero(),
            'm' => a_n.is_zero(),
            _ => return Err("not a letter".into()),
        };
        ensure!(kinematic, "accelerations ({a_n}, {a_t})");
        if c_n.is_zero() {
            ensure!(c_t.is_zero() && friction.is_none(), "friction without a normal force");
            return Ok(());
        }
        ensure!(c_n.is_positive() && "lrnm".contains(letter), "a normal force {c_n}");
        let coefficient = friction.as_ref().ok_or("no coefficient")?;
        let (range, tangential): (&Range, bool) = match letter {
            'l' => (&contact.friction.kinetic, *c_t == -(coefficient * c_n)),
            'r' => (&contact.friction.kinetic, *c_t == coefficient * c_n),
            _ => {
                let static_ = &contact.friction.static_;
                (static_, *coefficient == (c_t.abs() / c_n).max(static_.min.clone()))
            }
        };
        ensure!(tangential, "a force ({c_n}, {c_t}) at friction {coefficient}");
        ensure!(
            range.min <= *coefficient && *coefficient <= range.max,
            "friction {coefficient} is outside of the range"
        );
        Ok(())
    }
}

fn contacts(motion: &Value) -> Result<Vec<At>, String> {
    let at = |contact: &Value| {
        let exact = |key: &str| number(&contact[key]);
        let friction = if contact["friction"].is_null() { None } else { Some(exact("friction")?) };
        Ok(At { a_n: exact("a_n")?, a_t: exact("a_t")?, c_n: exact("c_n")?, c_t: exact("c_t")?, friction })
    };
    motion["contacts"].as_array().ok_or("no contacts")?.iter().map(at).collect()
}

fn is_at_rest(motion: &Value) -> Result<bool, String> {
    Ok(triple(&motion["acceleration"])?.iter().all(Zero::is_zero))
}

fn triple(list: &Value) -> Result<Wrench, String> {
    let numbers = list.as_array().ok_or("no list")?.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    numbers.try_into().map_err(|_| "not three numbers".to_owned())
}

fn number(value: &Value) -> Result<Q, String> {
    let text = match value {
        Value::Number(number) => number.to_string(),
        Value::String(text) => text.clone(),
        other => return Err(format!("{other} is not a number")),
    };
    parse_literal(&text).map_err(|fault| fault.to_string())
}

fn letters_in(motion: &Value, allowed: &str) -> Check {
    let mode = motion["mode"].as_str().ok_or("no mode")?;
    ensure!(mode.chars().all(|letter| allowed.contains(letter)), "{mode} has letters other than {allowed}");
    Ok(())
}

/// Contacts whose letter is one of `letters`.
fn with(motion: &Value, letters: &str) -> Vec<usize> {
    let mode = motion["mode"].as_str().unwrap_or_default();
    mode.char_indices().filter(|(_, letter)| letters.contains(*letter)).map(|(contact, _)| contact).collect()
}
