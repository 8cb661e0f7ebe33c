//! Random small problems against brute force.

use crate::brute::{basic_solutions, in_doubles, is_p_matrix};
use crate::check::proof_holds;
use num_traits::One as _;
use partplan::complementarity::{Basis, Count, Enumeration, ExactLcp, Lcp, Limits, Rung, Solver, Verdict, enumerate};
use partplan::exact::{Q, Z, ratio, to_f64};
use proptest::prelude::*;

fn any_lcp(most: usize, size: i64) -> impl Strategy<Value = ExactLcp> {
    (1..=most).prop_flat_map(move |n| {
        let rows = prop::collection::vec(prop::collection::vec(-size..=size, n), n);
        (rows, prop::collection::vec(-size..=size, n)).prop_map(|(m, q)| {
            let row = |row: Vec<i64>| row.into_iter().map(|entry| ratio(entry, 1)).collect::<Vec<Q>>();
            ExactLcp::new(m.into_iter().map(row).collect(), row(q)).unwrap()
        })
    })
}

/// `B Bᵀ + skew + I`, whose symmetric part is positive definite.
fn p_lcp() -> impl Strategy<Value = ExactLcp> {
    any_lcp(5, 3).prop_map(|lcp| {
        let b = lcp.m();
        let n = lcp.size();
        let entry = |i: usize, j: usize| {
            let product: Q = (0..n).map(|k| &b[i][k] * &b[j][k]).sum();
            let diagonal = if i == j { Q::one() } else { ratio(0, 1) };
            product + &b[i][j] - &b[j][i] + diagonal
        };
        ExactLcp::new((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect(), lcp.q().to_vec()).unwrap()
    })
}

fn solve_exactly(lcp: &ExactLcp, check: impl FnOnce(Verdict<'_>)) {
    let (m, q) = in_doubles(lcp);
    let mut solver = Solver::with_limits(Limits { first: Rung::Exact, ..Limits::default() });
    check(solver.solve(Lcp { m: &m, q: &q }, None, &|| Ok(lcp.clone())).unwrap());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// A P-matrix has one solution for each right side: the same in integers, doubles and by brute force.
    #[test]
    fn p_matrices_have_one_solution(lcp in p_lcp()) {
        prop_assert!(is_p_matrix(&lcp));
        let brute = basic_solutions(&lcp);
        prop_assert_eq!(brute.len(), 1);
        solve_exactly(&lcp, |verdict| {
            let Verdict::Solved(solution) = verdict else { panic!("{verdict:?}") };
            assert_eq!(solution.exact.unwrap(), brute[0]);
        });
        let (m, q) = in_doubles(&lcp);
        let mut solver = Solver::default();
        let Verdict::Solved(solution) = solver.solve(Lcp { m: &m, q: &q }, None, &|| panic!("doubles suffice")).unwrap()
        else { panic!("there is one") };
        let close = |(z, exact): (&f64, &Q)| (z - to_f64(exact)).abs() <= 1e-9 * (1.0 + to_f64(exact));
        prop_assert!(solution.z.iter().zip(&brute[0]).all(close));
        let Enumeration::Complete(all) = enumerate(&lcp, 1000) else { panic!("few cases") };
        prop_assert_eq!(all.count(), Count::Unique);
        prop_assert_eq!(&all.pieces[0].vertices[0], &brute[0]);
    }

    /// Any matrix: a solution is one, and where there is none brute force finds none and the proof holds.
    #[test]
    fn the_exact_rungs_are_never_wrong(lcp in any_lcp(5, 2)) {
        let brute = basic_solutions(&lcp);
        solve_exactly(&lcp, |verdict| match verdict {
            Verdict::Solved(solution) => assert!(lcp.is_solution(solution.exact.unwrap())),
            Verdict::NoSolution(proof) => assert!(brute.is_empty() && proof_holds(&lcp, &proof)),
            Verdict::Undecided(why) => panic!("{why:?}"),
        });
    }

    /// The enumeration holds every solution that brute force finds, and its vertices and rays are solutions.
    #[test]
    fn enumeration_agrees_with_brute_force(lcp in any_lcp(5, 2)) {
        let Enumeration::Complete(all) = enumerate(&lcp, 10_000) else { panic!("few cases") };
        for z in basic_solutions(&lcp) {
            prop_assert!(all.contains(&lcp, &z));
        }
        for piece in &all.pieces {
            for vertex in &piece.vertices {
                prop_assert!(lcp.is_solution(vertex));
                for ray in &piece.rays {
                    let far: Vec<Q> = vertex.iter().zip(ray).map(|(x, r)| x + r * Q::from(Z::from(1000))).collect();
                    prop_assert!(lcp.is_solution(&far));
                }
            }
            let count = Q::from(Z::from(piece.vertices.len() as u64));
            let mean: Vec<Q> = (0..lcp.size()).map(|i| piece.vertices.iter().map(|z| &z[i]).sum::<Q>() / &count).collect();
            prop_assert!(lcp.is_solution(&mean));
        }
        if let Count::Finite(_) | Count::Unique = all.count() {
            // isolated solutions of nonsingular bases are all there is; a singular basis may add a point to them
            prop_assert!(all.pieces.len() >= basic_solutions(&lcp).len());
        }
    }

    /// The exact answer of a problem with one solution does not depend on its units.
    #[test]
    fn units_do_not_matter(lcp in p_lcp(), exponents in prop::collection::vec(-40_i32..40, 5)) {
        let power = |e: i32| if e < 0 { Q::new(Z::from(1), Z::from(1) << -e) } else { Q::from(Z::from(1) << e) };
        let n = lcp.size();
        let scale: Vec<Q> = exponents[..n].iter().map(|e| power(*e)).collect();
        let entry = |i: usize, j: usize| &lcp.m()[i][j] * &scale[i] * &scale[j];
        let m = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let scaled = ExactLcp::new(m, lcp.q().iter().zip(&scale).map(|(q, s)| q * s).collect()).unwrap();
        let expected = basic_solutions(&lcp).remove(0);
        solve_exactly(&scaled, |verdict| {
            let Verdict::Solved(solution) = verdict else { panic!("{verdict:?}") };
            let back: Vec<Q> = solution.exact.unwrap().iter().zip(&scale).map(|(z, s)| z * s).collect();
            assert_eq!(back, expected);
        });
    }

    /// A basis is the set that was put into it.
    #[test]
    fn a_basis_is_a_set(size in 0_usize..200, members in prop::collection::btree_set(0_usize..220, 0..40)) {
        let basis = Basis::with(size, members.iter().copied());
        let inside: Vec<usize> = members.into_iter().filter(|index| *index < size).collect();
        prop_assert_eq!(basis.iter().collect::<Vec<_>>(), inside.clone());
        prop_assert!((0..230).all(|index| basis.contains(index) == inside.contains(&index)));
    }
}
