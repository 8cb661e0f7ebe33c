//! Why a wrench does not seat or hold the part, in plain words.

use super::super::phrase;
use crate::answer::{Motion, Step, WrenchVerdict};

/// Fixels and modes named in full up to this many.
const MOST_NAMED: usize = 4;

/// What may keep the part from its seat, and what the seated part may do; nothing where both are certain.
pub(super) fn reasons(verdict: &WrenchVerdict) -> Vec<String> {
    let witness = &verdict.witness;
    let (rest, leaving) = match &witness.unrefuted {
        Some(step) if step.from == step.to => (Some(step), None),
        step => (None, step.as_ref().map(|step| &step.motion)),
    };
    let detour = match (rest, &witness.acyclic, &witness.goal) {
        (Some(rest), _, _) => Some(resting(rest)),
        (None, Some(steps), _) => Some(circling(steps)),
        (None, None, Some(step)) => Some(losing(step)),
        (None, None, None) => None,
    };
    let motion = leaving.or(witness.strong.as_ref());
    detour.into_iter().chain(motion.map(|motion| moving(motion, &witness.consistent))).collect()
}

fn resting(step: &Step) -> String {
    format!("it may rest {}, short of {}", place(&step.from), fixels(&absent(step)))
}

fn circling(steps: &[Step]) -> String {
    let [only] = steps else {
        let states: Vec<String> = steps.iter().map(|step| place(&step.from)).collect();
        return format!("contacts may come and go for ever: {}, and again", states.join(", then "));
    };
    format!("{} it may stay without nearing {}", place(&only.from), fixels(&absent(only)))
}

/// A step of the paper's stricter condition for a part that is seated all the same.
fn losing(step: &Step) -> String {
    let lost: Vec<usize> = step.from.iter().filter(|contact| !step.to.contains(contact)).copied().collect();
    let meanwhile = if step.to.is_empty() { String::new() } else { format!(" while on {}", fixels(&step.to)) };
    format!("not every step adds a contact: it may lose {}{meanwhile}", fixels(&lost))
}

fn moving(motion: &Motion, consistent: &[Motion]) -> String {
    let acts = [('l', "slide left on"), ('r', "slide right on"), ('n', "turn about"), ('s', "lift off")];
    let parts: Vec<String> = acts
        .iter()
        .filter(|(letter, _)| motion.mode.contains(*letter))
        .map(|(letter, act)| {
            let on = motion.mode.char_indices().filter(|(_, other)| other == letter).map(|(contact, _)| contact);
            format!("{act} {}", fixels(&on.collect::<Vec<_>>()))
        })
        .collect();
    let parts = phrase::joined(&parts, "and");
    let modes: Vec<&str> = consistent.iter().map(|motion| motion.mode.as_str()).collect();
    match modes.as_slice() {
        [only] => format!("seated, it must {parts} ({only})"),
        many => {
            let shown = if many.len() > MOST_NAMED { MOST_NAMED - 1 } else { many.len() };
            let rest = if shown < many.len() { format!(" and {} more", many.len() - shown) } else { String::new() };
            format!("seated, it may {parts} ({}); undetermined between {}{rest}", motion.mode, many[..shown].join(" "))
        }
    }
}

fn place(contacts: &[usize]) -> String {
    if contacts.is_empty() { "clear of all fixels".to_owned() } else { format!("on {}", fixels(contacts)) }
}

fn absent(step: &Step) -> Vec<usize> {
    (0..step.motion.contacts.len()).filter(|contact| !step.from.contains(contact)).collect()
}

fn fixels(numbers: &[usize]) -> String {
    let noun = if numbers.len() == 1 { "fixel" } else { "fixels" };
    format!("{noun} {}", phrase::numbered(numbers, MOST_NAMED))
}
