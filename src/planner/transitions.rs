//! The graph of possible transitions between sets of achieved contacts, and the wrenches for which it has no cycle.

use crate::cone::{Cone, HalfSpaces, split};
use crate::exact::{Int, Overflow};
use crate::mechanics::{ContactRows, Interaction, mode_cone};

/// All transitions that some wrench makes possible. A state is a set of contacts, bit `i` for fixel `i`.
pub(super) struct Transitions<T> {
    n_states: usize,
    /// Cones of the wrenches under which some unseated state can persist.
    pub(super) loops: Vec<Cone<T>>,
    /// The states that can, one for each loop.
    persisting: Vec<usize>,
    edges: Vec<Edge<T>>,
}

/// What the contacts do in a step from one state to another.
pub(super) struct Step {
    pub(super) mode: Vec<Interaction>,
    /// Whether the letter `s` means that a contact breaks.
    pub(super) strict_s: bool,
}

/// A change of state and the wrenches under which it is possible.
struct Edge<T> {
    from: usize,
    to: usize,
    possible: HalfSpaces<T>,
    cone: Cone<T>,
}

/// Wrenches for which the transitions `present` are possible, `undecided` are not cut by yet, and the others are impossible.
struct OpenPiece<T> {
    piece: Cone<T>,
    present: u64,
    undecided: u64,
}

/// The space of wrenches cut into convex cells by whether the graph can have a cycle.
pub(super) struct Verdict<T> {
    /// Disjoint cells without a cycle.
    pub(super) acyclic: Vec<Cone<T>>,
    /// Cells with a cycle; together with the loops they cover the rest.
    pub(super) cyclic: Vec<Cone<T>>,
}

impl Step {
    /// Contacts break, `C -> C \ D`, with `s` (strict) on `D` and `m` on the rest of `C`; are added, `C -> C + T`, with `m`
    /// on `C` and `a` on `T`; or stay as they are, `C -> C`, with `m` on `C` and `s` elsewhere, unless `C` is the seated
    /// state. All other contacts are `u`. `None` for what is no step.
    pub(super) fn between(from: usize, to: usize, n_contacts: usize) -> Option<Self> {
        let seated = (1_usize << n_contacts) - 1;
        let (separating, maintained, approaching) = match (from & !to, to & !from) {
            (0, 0) if from == seated => return None,
            (0, 0) => (seated & !from, from, 0),
            (broken, 0) => (broken, to, 0),
            (0, added) => (0, from, added),
            _ => return None,
        };
        let letter = |contact: usize| match 1_usize << contact {
            bit if separating & bit != 0 => Interaction::Separate,
            bit if maintained & bit != 0 => Interaction::Maintain,
            bit if approaching & bit != 0 => Interaction::Approach,
            _ => Interaction::Unconstrained,
        };
        Some(Self { mode: (0..n_contacts).map(letter).collect(), strict_s: from != to })
    }
}

impl<T: Int> Transitions<T> {
    /// The transitions of at most three contacts.
    ///
    /// # Source
    /// The question that Balkcom & Trinkle (2002) leave open at the end of §9: the complete set asks for all acyclic
    /// graphs with the seated state as their only sink.
    pub(super) fn of(contacts: &[ContactRows<T>]) -> Result<Self, Overflow> {
        let n_states = 1_usize << contacts.len();
        let mut graph = Self { n_states, loops: Vec::new(), persisting: Vec::new(), edges: Vec::new() };
        for from in 0..n_states {
            for to in 0..n_states {
                let Some(step) = Step::between(from, to, contacts.len()) else { continue };
                let Some(cone) = mode_cone(contacts, &step.mode, step.strict_s)? else { continue };
                if from == to {
                    graph.loops.push(cone);
                    graph.persisting.push(from);
                } else {
                    graph.edges.push(Edge { from, to, possible: cone.half_spaces()?, cone });
                }
            }
        }
        Ok(graph)
    }

    /// Whether the graph under `wrench` has no cycle.
    pub(super) fn is_acyclic(&self, wrench: &[T]) -> Result<bool, Overflow> {
        Ok(self.cycle(wrench)?.is_empty())
    }

    /// The states on a shortest cycle of the graph under `wrench`, in order and each once; none if there is no cycle.
    pub(super) fn cycle(&self, wrench: &[T]) -> Result<Vec<usize>, Overflow> {
        for (cone, state) in self.loops.iter().zip(&self.persisting) {
            if cone.contains(wrench)? {
                return Ok(vec![*state]);
            }
        }
        let mut present = 0;
        for (index, edge) in self.edges.iter().enumerate() {
            if edge.cone.contains(wrench)? {
                present |= 1 << index;
            }
        }
        let cycles = (0..self.n_states).filter_map(|state| self.way_back(present, state));
        Ok(cycles.min_by_key(Vec::len).unwrap_or_default())
    }

    /// The states on a shortest way over `edges` from `start` back to it.
    fn way_back(&self, edges: u64, start: usize) -> Option<Vec<usize>> {
        let mut ways = vec![vec![start]];
        let mut seen = vec![false; self.n_states];
        while let Some(way) = (!ways.is_empty()).then(|| ways.remove(0)) {
            let last = way[way.len() - 1];
            for (_, edge) in self.chosen(edges).filter(|(_, edge)| edge.from == last) {
                if edge.to == start {
                    return Some(way);
                }
                if !std::mem::replace(&mut seen[edge.to], true) {
                    ways.push(way.iter().copied().chain([edge.to]).collect());
                }
            }
        }
        None
    }

    /// Cells of the wrenches outside of all loops, each cut by one more transition only while its verdict is open.
    pub(super) fn verdict(&self, outside_loops: Vec<Cone<T>>) -> Result<Verdict<T>, Overflow> {
        let mut verdict = Verdict { acyclic: Vec::new(), cyclic: Vec::new() };
        let mut open = self.open(outside_loops);
        while let Some((piece, is_acyclic)) = self.decide_next(&mut open)? {
            if is_acyclic { &mut verdict.acyclic } else { &mut verdict.cyclic }.push(piece);
        }
        Ok(verdict)
    }

    /// Whether the graph is without a cycle on some cell of dimension `least_dim` or more of `piece`, which lies outside of
    /// all loops.
    pub(super) fn is_acyclic_somewhere(&self, piece: Cone<T>, least_dim: usize) -> Result<bool, Overflow> {
        let mut open = self.open(vec![piece]);
        while let Some((cell, is_acyclic)) = self.decide_next(&mut open)? {
            if is_acyclic && cell.closure().dim() >= least_dim {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn open(&self, pieces: Vec<Cone<T>>) -> Vec<OpenPiece<T>> {
        let all_edges = (1_u64 << self.edges.len()) - 1;
        pieces.into_iter().map(|piece| OpenPiece { piece, present: 0, undecided: all_edges }).collect()
    }

    /// Cuts open pieces until the last one is decided, takes that one out and says whether its graph has no cycle; `None`
    /// when no piece is left.
    fn decide_next(&self, open: &mut Vec<OpenPiece<T>>) -> Result<Option<(Cone<T>, bool)>, Overflow> {
        while let Some(OpenPiece { piece, present, undecided }) = open.pop() {
            if self.has_cycle(present) {
                return Ok(Some((piece, false)));
            }
            let Some(next) = self.most_telling(present, undecided) else { return Ok(Some((piece, true))) };
            let undecided = undecided & !(1 << next);
            let (possible, impossible) = split(&piece, &self.edges[next].possible)?;
            open.extend(possible.map(|piece| OpenPiece { piece, present: present | 1 << next, undecided }));
            open.extend(impossible.into_iter().map(|piece| OpenPiece { piece, present, undecided }));
        }
        Ok(None)
    }

    fn has_cycle(&self, edges: u64) -> bool {
        let mut left: Vec<bool> = vec![true; self.n_states];
        // a state without a way to a state that is left can be on no cycle
        loop {
            let leads_on = |state: usize| self.chosen(edges).any(|(_, edge)| edge.from == state && left[edge.to]);
            let Some(done) = (0..self.n_states).find(|state| left[*state] && !leads_on(*state)) else { break };
            left[done] = false;
        }
        left.contains(&true)
    }

    /// Of the undecided edges the one whose presence comes closest to closing a cycle, among equals one that breaks
    /// contacts, for those are mostly impossible; `None` if no cycle can be closed.
    fn most_telling(&self, present: u64, undecided: u64) -> Option<usize> {
        let fewest = self.fewest_undecided(present, undecided);
        let candidates = self.chosen(undecided).filter_map(|(index, edge)| {
            let way_back = fewest[edge.to * self.n_states + edge.from]?;
            Some((way_back, edge.to > edge.from, index))
        });
        candidates.min().map(|(_, _, index)| index)
    }

    /// From each state to each other the least number of undecided edges on a way over present and undecided ones.
    fn fewest_undecided(&self, present: u64, undecided: u64) -> Vec<Option<u8>> {
        let n = self.n_states;
        let mut fewest: Vec<Option<u8>> = vec![None; n * n];
        for (index, edge) in self.chosen(present | undecided) {
            fewest[edge.from * n + edge.to] = Some(u8::from(undecided >> index & 1 == 1));
        }
        for via in 0..n {
            for from in 0..n {
                let Some(first) = fewest[from * n + via] else { continue };
                for to in 0..n {
                    let Some(second) = fewest[via * n + to] else { continue };
                    let known = &mut fewest[from * n + to];
                    *known = Some(known.map_or(first + second, |known| known.min(first + second)));
                }
            }
        }
        fewest
    }

    fn chosen(&self, edges: u64) -> impl Iterator<Item = (usize, &Edge<T>)> {
        self.edges.iter().enumerate().filter(move |(index, _)| edges >> index & 1 == 1)
    }
}
