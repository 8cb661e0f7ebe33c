//! Projected Gauss-Seidel for contacts, as physics engines do it: for comparison only.

use crate::complementarity::Factors;

/// Impulses after so many sweeps over the contacts, with two friction directions each, as the variables of the contact
/// problem: normal impulses, friction impulses, and the slip that stands for the multiplier.
pub(super) fn swept(factors: &Factors, sweeps: usize) -> Vec<f64> {
    let (contacts, size) = (factors.mu.len(), factors.inverse_mass.len());
    let row = |index: usize| &factors.jacobian[index * size..(index + 1) * size];
    let normal = |contact: usize| row(contact);
    let tangent = |contact: usize| row(contacts + 2 * contact);
    let mobility =
        |row: &[f64]| row.iter().zip(factors.inverse_mass).map(|(entry, inverse)| entry * entry * inverse).sum::<f64>();
    let weights: Vec<[f64; 2]> = (0..contacts).map(|at| [mobility(normal(at)), mobility(tangent(at))]).collect();
    let mut change = vec![0.0; size];
    let mut impulses = vec![[0.0_f64; 2]; contacts];
    let speed = |row: &[f64], change: &[f64]| row.iter().zip(change).map(|(a, b)| a * b).sum::<f64>();
    for _ in 0..sweeps {
        for contact in 0..contacts {
            let [p, f] = impulses[contact];
            let w = speed(normal(contact), &change) + factors.q[contact];
            let next = if weights[contact][0] > 0.0 { (p - w / weights[contact][0]).max(0.0) } else { p };
            push(&mut change, normal(contact), factors.inverse_mass, next - p);
            let slip = speed(tangent(contact), &change) + factors.q[contacts + 2 * contact];
            let most = factors.mu[contact] * next;
            let free = if weights[contact][1] > 0.0 { f - slip / weights[contact][1] } else { f };
            let held = free.clamp(-most, most);
            push(&mut change, tangent(contact), factors.inverse_mass, held - f);
            impulses[contact] = [next, held];
        }
    }
    let mut z: Vec<f64> = impulses.iter().map(|[p, _]| *p).collect();
    z.extend(impulses.iter().flat_map(|[_, f]| [f.max(0.0), (-f).max(0.0)]));
    let slips = (0..contacts).map(|at| speed(tangent(at), &change) + factors.q[contacts + 2 * at]);
    let at_limit = |contact: usize| impulses[contact][1].abs() >= factors.mu[contact] * impulses[contact][0];
    z.extend(slips.enumerate().map(|(contact, slip)| if at_limit(contact) { slip.abs() } else { 0.0 }));
    z
}

fn push(change: &mut [f64], row: &[f64], inverse_mass: &[f64], impulse: f64) {
    for ((change, entry), inverse) in change.iter_mut().zip(row).zip(inverse_mass) {
        *change += entry * inverse * impulse;
    }
}
