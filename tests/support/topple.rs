//! What a pin does to a part on a belt: balance of forces in doubles, angle by angle.
//!
//! Lengths are divided by the largest distance of a corner from the center of mass. World frame: the belt moves in +x,
//! the pivot is the origin, heights are above the belt, and the part turns counter-clockwise.

use super::{cross, dot};
use num_traits::{Signed, Zero};
use partplan::answer::PinAction;
use partplan::exact::{Q, to_f64};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

type Point = [f64; 2];

/// Forces, with lengths as above and the friction's scale divided out, nearer to balance than doubles can tell.
const TIE: f64 = 1e-13;

/// A part on a belt.
pub struct Conveyed {
    /// Corners of the hull, counter-clockwise from the first corner of the outline that is one.
    pub hull: Vec<[Q; 2]>,
    /// Edges on which the part rests stably.
    pub stable: Vec<usize>,
    center: [Q; 2],
    /// One for each corner: the turn about it from its own edge flat to the edge before it flat.
    legs: Vec<Leg>,
    size: f64,
    belt: f64,
    pin: f64,
}

/// What happens between a part and a pin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Meeting {
    pub action: PinAction,
    /// The edge that touches the pin first, if the two touch.
    pub first: Option<usize>,
    /// The part ducks below the pin while it settles.
    pub ducks: bool,
    /// The forces balance exactly, or so nearly that doubles cannot tell: said to jam.
    pub tied: bool,
}

impl Conveyed {
    /// `outline` of either winding, friction between part and belt, and part and pin.
    pub fn new(outline: &[[Q; 2]], center: &[Q; 2], belt: &Q, pin: &Q) -> Self {
        let hull = hull(outline);
        let count = hull.len();
        let far2 = hull.iter().map(|v| minus(v, center)).map(|v| to_f64(&dot(&v, &v))).fold(0.0, f64::max);
        let size = far2.sqrt();
        let stable = (0..count).filter(|edge| {
            let (a, b) = (&hull[*edge], &hull[(edge + 1) % count]);
            let along = minus(b, a);
            dot(&minus(center, a), &along).is_positive() && dot(&minus(b, center), &along).is_positive()
        });
        let stable = stable.collect();
        let legs = (0..count).map(|pivot| Leg::new(&hull, center, pivot, size)).collect();
        Self { stable, center: center.clone(), legs, size, belt: to_f64(belt), pin: to_f64(pin), hull }
    }

    /// The corners about which the part turns from `edge` to the next stable edge.
    pub fn pivots(&self, edge: usize) -> Vec<usize> {
        let mut pivots = vec![edge];
        let mut at = self.before(edge);
        while !self.stable.contains(&at) {
            pivots.push(at);
            at = self.before(at);
        }
        pivots
    }

    pub fn next(&self, edge: usize) -> usize {
        self.before(*self.pivots(edge).last().expect("an edge has a pivot"))
    }

    fn before(&self, edge: usize) -> usize {
        (edge + self.hull.len() - 1) % self.hull.len()
    }

    /// Height of the part with `edge` on the belt.
    pub fn height(&self, edge: usize) -> f64 {
        self.legs[edge].top(0.0) * self.size
    }

    /// Turns in radians: until the center of mass is over the pivot, and until the next stable edge is flat.
    pub fn turns(&self, edge: usize) -> [f64; 2] {
        let (mut total, mut over) = (0.0, None);
        let pivots = self.pivots(edge);
        for (place, pivot) in pivots.iter().enumerate() {
            let leg = &self.legs[*pivot];
            let upright = FRAC_PI_2 - angle(leg.center);
            // one that is upright just as it meets the belt flat tips on over the next corner
            if over.is_none() && (upright < leg.turn - 1e-12 || place + 1 == pivots.len()) {
                over = Some(total + upright);
            }
            total += leg.turn;
        }
        [over.expect("a part between two stable edges is upright once"), total]
    }

    /// What a pin does, unless it is so near a critical height that doubles should not decide.
    pub fn action(&self, edge: usize, height: f64) -> Option<PinAction> {
        let [at, below, above] = [1.0, 1.0 - 1e-7, 1.0 + 1e-7].map(|factor| self.meet(edge, height * factor));
        (at.action == below.action && at.action == above.action && !at.tied).then_some(at.action)
    }

    /// The edge on which the part ends, or none if it jams; nothing near a critical height.
    pub fn outcome(&self, edge: usize, height: f64) -> Option<Option<usize>> {
        let mut at = edge;
        for _ in 0..=self.stable.len() {
            at = match self.action(at, height)? {
                PinAction::PassUnder | PinAction::FallBack => return Some(Some(at)),
                PinAction::Jam => return Some(None),
                PinAction::Pass => return Some(Some(self.next(at))),
                PinAction::Repeat => self.next(at),
            }
        }
        Some(None)
    }

    /// What a pin at `height` does to the part with `edge` on the belt.
    pub fn meet(&self, edge: usize, height: f64) -> Meeting {
        let h = height / self.size;
        let mut meeting = Meeting { action: PinAction::PassUnder, first: None, ducks: false, tied: false };
        if h >= self.legs[edge].top(0.0) {
            return meeting;
        }
        for leg in self.pivots(edge).into_iter().map(|pivot| &self.legs[pivot]) {
            for piece in leg.pieces(h) {
                let middle = (piece[0] + piece[1]) / 2.0;
                let rolls = leg.center_at(middle)[0] > 0.0;
                let Some(touched) = leg.touched(middle, h) else {
                    if rolls {
                        let action = if meeting.tied { PinAction::Jam } else { PinAction::FallBack };
                        return Meeting { action, ..meeting };
                    }
                    meeting.ducks = true;
                    continue;
                };
                meeting.first.get_or_insert(touched);
                let slide = leg.contact(touched, middle, h).slide();
                let margin = |turn: f64| {
                    let contact = leg.contact(touched, turn, h);
                    let center = leg.center_at(turn)[0];
                    if rolls { self.carries(&contact, center, slide) } else { self.releases(&contact, center, slide) }
                };
                let least = least(piece, margin);
                if least < -TIE {
                    return Meeting { action: PinAction::Jam, tied: false, ..meeting };
                }
                meeting.tied |= least <= TIE;
            }
        }
        if meeting.tied {
            return Meeting { action: PinAction::Jam, ..meeting };
        }
        let passes = h >= self.legs[self.next(edge)].top(0.0);
        meeting.ducks &= !passes;
        Meeting { action: if passes { PinAction::Pass } else { PinAction::Repeat }, ..meeting }
    }

    /// Whether the part is stuck from where it first meets the pin until it would have turned by `turn`, and not nearly free,
    /// while the pin neither pushes upward nor tips the part forward: what lifts it may carry it over or under the pin.
    pub fn is_stuck_at_first(&self, edge: usize, height: f64, turn: f64) -> bool {
        const CLEARLY: f64 = 0.01;
        let (leg, h) = (&self.legs[edge], height / self.size);
        let is_stuck = |angle: f64| {
            leg.touched(angle, h).is_some_and(|touched| {
                let contact = leg.contact(touched, angle, h);
                let right = leg.corner_at(edge + 1, angle);
                let arm = [contact.at[0] - right[0], contact.at[1] - right[1]];
                let [x, y] = contact.along;
                let pushes = [1.0, -1.0].map(|side| [-y + side * self.pin * x, x + side * self.pin * y]);
                let only_holds = x <= 0.0 && pushes.iter().all(|push| turning(arm, *push) >= 0.0);
                only_holds && self.carries(&contact, leg.center_at(angle)[0], contact.slide()) < -CLEARLY
            })
        };
        (0..=4).all(|quarter| is_stuck(f64::from(quarter) / 4.0 * turn))
    }

    /// How far the center of mass would have to rise to topple the part where it turns out from under a pin that touched it.
    pub fn left_to_rise(&self, edge: usize, height: f64) -> f64 {
        let (leg, h) = (&self.legs[edge], height / self.size);
        let over = |turn: f64| leg.top(turn) <= h;
        let steps = (0..=1_000).map(|step| f64::from(step) * 1e-3 * leg.turn);
        let lost = steps.skip_while(|turn| over(*turn)).find(|turn| over(*turn)).unwrap_or(0.0);
        let [x, y] = leg.center_at(lost);
        (x.hypot(y) - y) * self.size
    }

    /// Positive if the part turns slowly on while the belt carries its pivot along: the pin, the weight and the belt
    /// balance, the pin's friction against the sliding, the belt's inside of its cone.
    fn carries(&self, contact: &Contact, center: f64, slide: f64) -> f64 {
        let (weight, belt) = self.balance(contact, center, -slide * self.pin);
        weight.min(self.within(belt).into_iter().fold(f64::INFINITY, f64::min))
    }

    /// Positive if the part cannot rest between pin and belt although it tips over: whatever friction against the
    /// sliding, the three forces do not balance.
    fn releases(&self, contact: &Contact, center: f64, slide: f64) -> f64 {
        let ends = [0.0, -slide * self.pin].map(|friction| {
            let (weight, belt) = self.balance(contact, center, friction);
            let [left, right] = self.within([-belt[0], -belt[1]]);
            [-weight, left, right]
        });
        // each is linear in the friction; the greatest least is at an end or where two are equal
        let at = |share: f64| {
            let value = |i: usize| ends[0][i] + share * (ends[1][i] - ends[0][i]);
            (0..3).map(value).fold(f64::INFINITY, f64::min)
        };
        let mut best = at(0.0).max(at(1.0));
        for [i, j] in [[0, 1], [0, 2], [1, 2]] {
            let [first, last] = ends.map(|values| values[i] - values[j]);
            if first * last < 0.0 {
                best = best.max(at(first / (first - last)));
            }
        }
        -best
    }

    /// The weight that a pin's force of the size of `center` times that of its normal part balances about the pivot,
    /// and the force that the belt must add at the pivot.
    fn balance(&self, contact: &Contact, center: f64, friction: f64) -> (f64, Point) {
        let Contact { at, along } = contact;
        let scale = 1.0 + self.pin;
        let force = [0, 1].map(|i| ([-along[1], along[0]][i] + friction * along[i]) / scale);
        let weight = turning(*at, force);
        (weight, [-center * force[0], weight - center * force[1]])
    }

    /// How far inside of both sides of the belt's friction cone a force is.
    fn within(&self, force: Point) -> Point {
        [1.0, -1.0].map(|side| (self.belt * force[1] + side * force[0]) / (1.0 + self.belt))
    }
}

/// A point of the outline at the pin, and the unit direction of its edge, counter-clockwise.
struct Contact {
    at: Point,
    along: Point,
}

impl Contact {
    /// The sign with which the part slides along its edge past the pin, if it turns while the belt carries the pivot by
    /// one and the contact lasts.
    fn slide(&self) -> f64 {
        let Self { at, along } = self;
        let from_foot = along[0] * at[0] + along[1] * at[1];
        if from_foot <= 0.0 {
            // only turning back keeps the contact, and turning on presses the part into the pin, sliding upwards
            return 1.0;
        }
        let turn = along[1] / from_foot;
        let velocity = [1.0 - turn * at[1], turn * at[0]];
        (velocity[0] * along[0] + velocity[1] * along[1]).signum()
    }
}

/// A turn about one corner.
struct Leg {
    turn: f64,
    /// Corners and center of mass from the pivot, at the start of the turn.
    corners: Vec<Point>,
    center: Point,
}

impl Leg {
    fn new(hull: &[[Q; 2]], center: &[Q; 2], pivot: usize, size: f64) -> Self {
        let count = hull.len();
        let along = minus(&hull[(pivot + 1) % count], &hull[pivot]);
        let earlier = minus(&hull[pivot], &hull[(pivot + count - 1) % count]);
        let length = to_f64(&dot(&along, &along)).sqrt() * size;
        let seen = |point: &[Q; 2]| {
            let from = minus(point, &hull[pivot]);
            [to_f64(&dot(&along, &from)) / length, to_f64(&cross(&along, &from)) / length]
        };
        let turn = to_f64(&cross(&earlier, &along)).atan2(to_f64(&dot(&earlier, &along)));
        Self { turn, corners: hull.iter().map(seen).collect(), center: seen(center) }
    }

    fn corner_at(&self, corner: usize, turn: f64) -> Point {
        turned(self.corners[corner % self.corners.len()], turn)
    }

    fn center_at(&self, turn: f64) -> Point {
        turned(self.center, turn)
    }

    fn top(&self, turn: f64) -> f64 {
        (0..self.corners.len()).map(|corner| self.corner_at(corner, turn)[1]).fold(0.0, f64::max)
    }

    /// The edge at height `h` on the side of the pin.
    fn touched(&self, turn: f64, h: f64) -> Option<usize> {
        (0..self.corners.len()).find(|edge| self.corner_at(*edge, turn)[1] < h && h < self.corner_at(edge + 1, turn)[1])
    }

    fn contact(&self, edge: usize, turn: f64, h: f64) -> Contact {
        let [a, b] = [edge, edge + 1].map(|corner| self.corner_at(corner, turn));
        let share = ((h - a[1]) / (b[1] - a[1])).clamp(0.0, 1.0);
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        Contact { at: [a[0] + share * along[0], h], along: along.map(|x| x / length) }
    }

    /// The turn cut where the pin passes a corner, an edge is level, or the contact or the center of mass is over the
    /// pivot.
    fn pieces(&self, h: f64) -> Vec<[f64; 2]> {
        let count = self.corners.len();
        let mut cuts = vec![0.0, self.turn, FRAC_PI_2 - angle(self.center)];
        for corner in 0..count {
            let point = self.corners[corner];
            let far = point[0].hypot(point[1]);
            if far > h {
                let rise = (h / far).asin();
                cuts.extend([rise - angle(point), PI - rise - angle(point)]);
            }
            let next = self.corners[(corner + 1) % count];
            let along = [next[0] - point[0], next[1] - point[1]];
            let direction = angle(along);
            cuts.extend([-direction, PI - direction, TAU - direction]);
            let off = turning(along, point) / along[0].hypot(along[1]) / h;
            if off.abs() < 1.0 {
                let lean = off.acos();
                cuts.extend([lean, -lean, TAU + lean, TAU - lean, 2.0 * TAU - lean].map(|a| a - direction));
            }
        }
        cuts.retain(|cut| (0.0..=self.turn).contains(cut));
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).map(|ends| [ends[0], ends[1]]).filter(|[from, to]| to - from > 1e-13).collect()
    }
}

/// The least value on a closed piece, or one that is clearly not positive.
fn least(piece: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 24;
    let at = |step: f64| piece[0] + (piece[1] - piece[0]) * step / STEPS as f64;
    let values: Vec<f64> = (0..=STEPS).map(|step| value(at(step as f64))).collect();
    let mut least = values.iter().copied().fold(f64::INFINITY, f64::min);
    for low in 0..=STEPS {
        let (before, after) = (low.saturating_sub(1), STEPS.min(low + 1));
        if least < -TIE || values[low] > values[before].min(values[after]) {
            continue;
        }
        let (mut from, mut to) = (at(before as f64), at(after as f64));
        for _ in 0..45 {
            let third = (to - from) / 3.0;
            if value(from + third) < value(to - third) { to -= third } else { from += third }
        }
        least = least.min(value((from + to) / 2.0));
    }
    least
}

fn minus(a: &[Q; 2], b: &[Q; 2]) -> [Q; 2] {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

/// The moment of `force` at `at` about the origin.
fn turning(at: Point, force: Point) -> f64 {
    at[0] * force[1] - at[1] * force[0]
}

fn turned([x, y]: Point, by: f64) -> Point {
    let (sin, cos) = by.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// In (-pi, pi].
fn angle([x, y]: Point) -> f64 {
    y.atan2(x)
}

fn hull(outline: &[[Q; 2]]) -> Vec<[Q; 2]> {
    let mut outline = outline.to_vec();
    let next = |i: usize| (i + 1) % outline.len();
    let twice_area: Q = (0..outline.len()).map(|i| cross(&outline[i], &outline[next(i)])).sum();
    if twice_area < Q::zero() {
        outline[1..].reverse();
    }
    let mut sorted = outline.clone();
    sorted.sort();
    let mut hull = half_hull(sorted.iter());
    hull.pop();
    hull.extend(half_hull(sorted.iter().rev()));
    hull.pop();
    let first = outline.iter().find_map(|v| hull.iter().position(|corner| corner == v));
    hull.rotate_left(first.expect("corners of the hull are corners of the outline"));
    hull
}

fn half_hull<'a>(points: impl Iterator<Item = &'a [Q; 2]>) -> Vec<[Q; 2]> {
    let mut chain: Vec<[Q; 2]> = Vec::new();
    for point in points {
        while let [.., a, b] = &chain[..] {
            if cross(&minus(b, a), &minus(point, a)).is_positive() {
                break;
            }
            chain.pop();
        }
        chain.push(point.clone());
    }
    chain
}
