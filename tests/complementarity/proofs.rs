//! Problems without a solution, and the proofs of that.

use crate::check::{proof_holds, violation};
use crate::contacts::{Family, Random, draw};
use partplan::complementarity::{Lcp, Proof, Solver, Verdict};
use partplan::exact::ratio;

/// Two walls 2 mm closer than the body is wide: no velocity satisfies both gaps.
#[test]
fn a_frictionless_squeeze_has_farkas_multipliers() {
    let factors = partplan::complementarity::Factors {
        jacobian: &[1.0, 0.0, -1.0, 0.0],
        inverse_mass: &[2.0, 1.0],
        mu: &[],
        directions: 0,
        q: &[-0.25, -0.5],
    };
    let mut m = Vec::new();
    factors.assemble(&mut m).unwrap();
    let mut solver = Solver::default();
    let verdict = solver.solve(Lcp { m: &m, q: factors.q }, None, &|| factors.to_exact()).unwrap();
    let Verdict::NoSolution(Proof::Farkas(y)) = &verdict else { panic!("{verdict:?}") };
    assert!(y[0] == y[1] && y[0] > ratio(0, 1));
    assert!(proof_holds(&factors.to_exact().unwrap(), &Proof::Farkas(y.clone())));
}

/// Opposed contacts that overlap are refused with a proof or solved; both kinds of proof occur.
#[test]
fn squeezes_are_refused_with_proofs_that_hold() {
    let mut random = Random(11);
    let mut solver = Solver::default();
    let mut m = Vec::new();
    let (mut farkas, mut cases, mut solved) = (0, 0, 0);
    for _ in 0..60 {
        let problem = draw(Family::Squeeze, &mut random);
        let factors = problem.factors();
        factors.assemble(&mut m).unwrap();
        match solver.solve(Lcp { m: &m, q: &problem.q }, None, &|| factors.to_exact()).unwrap() {
            Verdict::Solved(solution) => {
                assert!(violation(&problem, solution.z) <= 1e-7);
                solved += 1;
            }
            Verdict::NoSolution(proof) => {
                assert!(proof_holds(&factors.to_exact().unwrap(), &proof));
                match proof {
                    Proof::Farkas(_) => farkas += 1,
                    Proof::Cases(_) => cases += 1,
                }
            }
            Verdict::Undecided(why) => panic!("{why:?}"),
        }
    }
    assert!(farkas >= 10 && cases >= 10, "{farkas} {cases} {solved}");
}

/// The checker of proofs refuses what is not one.
#[test]
fn wrong_proofs_are_seen() {
    let lcp = crate::brute::lcp(&[&[1, -1], &[-1, 1]], &[-1, -1]);
    let y = |a: i64, b: i64| vec![ratio(a, 1), ratio(b, 1)];
    assert!(proof_holds(&lcp, &Proof::Farkas(y(1, 1))));
    for wrong in [y(1, 0), y(0, 1), y(-1, -1), y(0, 0), y(2, 1)] {
        assert!(!proof_holds(&lcp, &Proof::Farkas(wrong)));
    }
    let case = |zero_z: &[usize], zero_w: &[usize]| partplan::complementarity::ExcludedCase {
        zero_z: zero_z.to_vec(),
        zero_w: zero_w.to_vec(),
        multipliers: y(1, 1),
    };
    assert!(proof_holds(&lcp, &Proof::Cases(vec![case(&[0], &[]), case(&[], &[0])])));
    assert!(!proof_holds(&lcp, &Proof::Cases(vec![case(&[0], &[])])), "half of the choices are missing");
    assert!(!proof_holds(&lcp, &Proof::Cases(vec![case(&[0], &[]), case(&[], &[1])])), "the cases overlap");
}
