//! The modes that may follow each state short of the seat.

use super::super::sets::ModeCone;
use crate::answer::StateModes;
use crate::cone::Cone;
use crate::exact::{Int, Overflow};
use crate::mechanics::{ContactRows, Interaction, Mode, acceleration_system, feasible_modes, force_rays};

/// Up to so many contacts all their states are looked at.
const MOST_CONTACTS: usize = 3;

/// For each unseated state the cones of its modes: `s` (strict), `l`, `r` or `n` at the contacts that it has, `a` or `s`
/// (closed) at the others.
pub(super) struct States<T>(Vec<(Vec<usize>, Vec<ModeCone<T>>)>);

impl<T: Int> States<T> {
    /// All unseated states of at most three contacts, and none of more.
    pub(super) fn of(contacts: &[ContactRows<T>]) -> Result<Self, Overflow> {
        let n = contacts.len();
        let n_unseated = if n > MOST_CONTACTS { 0 } else { (1_usize << n) - 1 };
        let mut states = Vec::with_capacity(n_unseated);
        for state in 0..n_unseated {
            let on: Vec<usize> = (0..n).filter(|contact| state >> contact & 1 == 1).collect();
            let cones = cones(contacts, &on)?;
            states.push((on, cones));
        }
        Ok(Self(states))
    }

    /// Of each state the modes consistent with a wrench.
    pub(super) fn consistent(&self, wrench: &[T]) -> Result<Vec<StateModes>, Overflow> {
        let of_state = |(contacts, cones): &(Vec<usize>, Vec<ModeCone<T>>)| {
            let mut consistent = Vec::new();
            for (mode, cone) in cones {
                if cone.contains(wrench)? {
                    consistent.push(mode.to_string());
                }
            }
            consistent.sort();
            Ok(StateModes { contacts: contacts.clone(), consistent })
        };
        self.0.iter().map(of_state).collect()
    }
}

/// The cones of the modes of the state in which the part touches `on`.
fn cones<T: Int>(contacts: &[ContactRows<T>], on: &[usize]) -> Result<Vec<ModeCone<T>>, Overflow> {
    let n = contacts.len();
    let touched: Vec<ContactRows<T>> = on.iter().map(|contact| contacts[*contact].clone()).collect();
    let mut cones = Vec::new();
    for letters in feasible_modes(&touched)? {
        let mut touching = vec![Interaction::Unconstrained; n];
        on.iter().zip(letters).for_each(|(contact, letter)| touching[*contact] = letter);
        let accelerations = acceleration_system(contacts, &touching, true);
        let forces = force_rays(contacts, &touching);
        for approaching in (0..1_usize << n).filter(|set| on.iter().all(|contact| set >> contact & 1 == 0)) {
            let letter = |contact: usize| match approaching >> contact & 1 {
                _ if on.contains(&contact) => Interaction::Unconstrained,
                1 => Interaction::Approach,
                _ => Interaction::Separate,
            };
            let open: Vec<Interaction> = (0..n).map(letter).collect();
            let system = accelerations.clone().and(&acceleration_system(contacts, &open, false));
            if let Some(cone) = Cone::from_half_spaces_plus(&system, &forces)? {
                let letter = |contact: usize| if on.contains(&contact) { touching[contact] } else { open[contact] };
                cones.push((Mode((0..n).map(letter).collect()), cone));
            }
        }
    }
    Ok(cones)
}
