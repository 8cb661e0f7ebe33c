//! A planner's answer held against balance of forces.

use crate::support::topple::Conveyed;
use partplan::answer::{Orientation, PinAction, Pins};
use partplan::exact::Q;

/// Ends of intervals as doubles; the last is beyond every height that matters.
pub struct Band {
    pub from: f64,
    pub to: f64,
    pub action: PinAction,
}

pub fn bands(orientation: &Orientation) -> Vec<Band> {
    let band = |interval: &partplan::answer::ActionInterval| {
        let from = interval.from.to_f64();
        let to = interval.to.as_ref().map_or(2.0 * from, partplan::exact::Algebraic::to_f64);
        Band { from, to, action: interval.action.expect("nothing in the case is uncertain") }
    };
    orientation.intervals.iter().map(band).collect()
}

/// What a pin does at so many places, and at how many of them doubles cannot say.
#[derive(Debug, Default, Clone, Copy)]
pub struct Tally {
    pub judged: usize,
    pub unsure: usize,
}

/// Everything that `pins` says about single orientations, at `shares` of each interval and just inside of its ends.
pub fn agrees(pins: &Pins, oracle: &Conveyed, shares: &[f64]) -> Result<Tally, String> {
    if pins.hull != oracle.hull || pins.stable != oracle.stable {
        return Err(format!("hull {:?} or stable edges {:?} {:?}", pins.hull, pins.stable, oracle.stable));
    }
    if pins.orientations.iter().map(|o| o.edge).ne(oracle.stable.iter().copied()) {
        return Err("an orientation for each stable edge, in order".into());
    }
    let mut tally = Tally::default();
    for orientation in &pins.orientations {
        orientation_agrees(orientation, oracle, shares, &mut tally)?;
    }
    Ok(tally)
}

/// The same for one orientation.
pub fn orientation_agrees(
    orientation: &Orientation,
    oracle: &Conveyed,
    shares: &[f64],
    tally: &mut Tally,
) -> Result<(), String> {
    path(orientation, oracle)
        .and_then(|()| heights(orientation, oracle, shares, tally))
        .map_err(|fault| format!("edge {}: {fault}", orientation.edge))
}

fn path(orientation: &Orientation, oracle: &Conveyed) -> Result<(), String> {
    let edge = orientation.edge;
    if orientation.next != oracle.next(edge) || orientation.pivots != oracle.pivots(edge) {
        return Err(format!("next {} over {:?}", orientation.next, orientation.pivots));
    }
    let ours = [orientation.theta_t_deg, orientation.theta_1_deg];
    let theirs = oracle.turns(edge).map(f64::to_degrees);
    if ours.iter().zip(theirs).any(|(a, b)| (a - b).abs() > 1e-7) {
        return Err(format!("turns {ours:?}, not {theirs:?}"));
    }
    let [ours, theirs] = [orientation.height.to_f64(), oracle.height(edge)];
    if (ours / theirs - 1.0).abs() > 1e-12 {
        return Err(format!("height {ours}, not {theirs}"));
    }
    let intervals = &orientation.intervals;
    let adjoin = intervals.windows(2).all(|pair| pair[0].to.as_ref() == Some(&pair[1].from));
    // a single height that jams has an interval of its own
    let ascend = intervals
        .iter()
        .all(|i| i.to.as_ref().is_none_or(|to| i.from < *to || i.action == Some(PinAction::Jam) && i.from == *to));
    let [first, .., last] = &intervals[..] else { return Err("fewer than two intervals".into()) };
    if !(adjoin && ascend && first.from == Q::from_integer(0.into()) && last.to.is_none()) {
        return Err(format!("intervals do not cover the heights once: {intervals:?}"));
    }
    Ok(())
}

fn heights(orientation: &Orientation, oracle: &Conveyed, shares: &[f64], tally: &mut Tally) -> Result<(), String> {
    let edge = orientation.edge;
    let table: Vec<_> = orientation.topple.iter().map(|t| (t.edge, t.from.to_f64(), t.to.to_f64())).collect();
    let dips: Vec<_> = orientation.repeat_over_dip.iter().map(|[from, to]| [from.to_f64(), to.to_f64()]).collect();
    let critical: Vec<f64> = orientation.intervals.iter().map(|i| i.from.to_f64()).filter(|h| *h > 0.0).collect();
    let borders = table.iter().flat_map(|(_, from, to)| [*from, *to]).chain(dips.iter().flatten().copied());
    let borders: Vec<f64> = borders.chain(critical.iter().copied()).collect();
    // in doubles nothing can be said of heights far below the size of the part
    let least = 1e-9 * orientation.height.to_f64();
    for Band { from, to, action } in bands(orientation) {
        let inner = shares.iter().map(|share| from + share * (to - from));
        let ends = [from * (1.0 + 1e-6), to * (1.0 - 1e-6)].into_iter().filter(|h| *h > 0.0);
        for h in inner.chain(ends) {
            let near = |border: &f64| (h / border - 1.0).abs() < 4e-7;
            if !(from < h && h < to) || h < least || critical.iter().any(near) {
                continue;
            }
            tally.judged += 1;
            let meeting = oracle.meet(edge, h);
            if meeting.action != action {
                if oracle.action(edge, h).is_none() {
                    tally.unsure += 1;
                    continue;
                }
                return Err(format!("{action:?} at {h} between {from} and {to}, not {:?}", meeting.action));
            }
            if borders.iter().any(near) {
                continue;
            }
            let listed = table.iter().filter(|(_, from, to)| *from < h && h < *to).map(|(edge, ..)| *edge);
            let topples = matches!(action, PinAction::Repeat | PinAction::Pass);
            if listed.collect::<Vec<_>>() != meeting.first.filter(|_| topples).into_iter().collect::<Vec<_>>() {
                return Err(format!("at {h} the part touches {:?} first, not what {table:?} says", meeting.first));
            }
            let flagged = dips.iter().any(|[from, to]| *from < h && h < *to);
            if action == PinAction::Repeat && flagged != meeting.ducks {
                return Err(format!("at {h} ducks: {}, not what {dips:?} says", meeting.ducks));
            }
        }
    }
    Ok(())
}

/// Where a pin at `height` leaves a part that comes on `edge`, by what is said of single orientations; none if it jams.
pub fn end(answer: &Pins, edge: usize, height: &Q) -> Option<usize> {
    let mut at = edge;
    for _ in 0..=answer.stable.len() {
        let orientation = answer.orientations.iter().find(|o| o.edge == at)?;
        at = match orientation.action_at(height).0? {
            PinAction::PassUnder | PinAction::FallBack => return Some(at),
            PinAction::Jam => return None,
            PinAction::Pass => return Some(orientation.next),
            PinAction::Repeat => orientation.next,
        }
    }
    None
}
