//! Balkcom & Trinkle (2002): the printed matrices, figures and tables, and where they are misprinted.

mod support;

use num_traits::{Signed, Zero};
use partplan::answer::{Cone, Stability};
use partplan::exact::Q;
use partplan::mechanics::Mode;
use partplan::model::{Fixture, Friction, Part, Range};
use partplan::planner::{Question, insertion, mode_cones, stability};
use std::collections::BTreeSet;
use support::canonical::canonical;
use support::cases::{expected, seated, wrench_of};
use support::member::{in_cone, landmarks};
use support::modes::{Contacts, unseating_modes};
use support::paper::{self, Matrix, SlidingSign, cone_form};
use support::{Wrench, int, q, wrench};

/// A case with one friction number at every fixel.
fn with_friction(name: &str, mu: &str) -> (Part, Fixture) {
    let (part, mut fixture) = seated(name);
    let range = Range::exactly(q(mu));
    for fixel in &mut fixture.fixels {
        fixel.friction = Friction { static_: range.clone(), kinetic: range.clone() };
    }
    (part, fixture)
}

fn cones(part: &Part, fixture: &Fixture, modes: &[&str]) -> Vec<Cone> {
    let modes: Vec<Mode> = modes.iter().map(|mode| mode.parse().unwrap()).collect();
    let question = Question { modes, ..Question::default() };
    mode_cones(part, fixture, &question).unwrap().into_iter().map(|(_, cone)| cone).collect()
}

fn stable(part: &Part, fixture: &Fixture) -> Stability {
    stability(part, fixture, &Question::default()).unwrap()
}

fn goal_volume(name: &str, mu: &str) -> Q {
    let (part, fixture) = with_friction(name, mu);
    insertion(&part, &fixture, &Question::default()).unwrap().goal.volume_in_box
}

fn matrix<const ROWS: usize, const COLUMNS: usize>(entries: [[&str; COLUMNS]; ROWS]) -> Matrix {
    Matrix::from_fn(ROWS, COLUMNS, |i, j| q(entries[i][j]))
}

/// The unit disc of Section 4, `M` the identity, in the paper's contact order.
fn disc() -> Contacts {
    let (part, fixture) = with_friction("n2_disc_paper", "0.2");
    Contacts::of(&part, &fixture)
}

/// Section 4, the Jacobian and eq. (12).
#[test]
fn the_disc_has_the_printed_jacobian_and_equations() {
    let j = matrix([["0", "-1", "-1", "0"], ["1", "0", "0", "-1"], ["0", "0", "-1", "-1"]]);
    let c = matrix([
        ["1", "0", "0", "0", "-1", "0", "0", "1"],
        ["0", "1", "0", "0", "0", "-1", "-1", "0"],
        ["0", "0", "1", "0", "0", "-1", "-2", "-1"],
        ["0", "0", "0", "1", "1", "0", "-1", "-2"],
    ]);
    let b = matrix([["0", "1", "0"], ["-1", "0", "0"], ["-1", "0", "-1"], ["0", "-1", "-1"]]);
    assert_eq!(paper::jacobian(&disc()), j);
    assert_eq!(paper::c_matrix(&disc()), c);
    assert_eq!(paper::b_matrix(&disc()), b);
}

/// Section 4 at mu_s = 0.2: K, P and the generators G.
#[test]
fn the_disc_rolls_and_approaches_with_the_printed_matrices() {
    let form = cone_form(&disc(), "na", SlidingSign::Table2);
    let k = matrix([["0", "-1", "-1"], ["-1", "0.2", "-0.2"], ["0", "0.4", "-0.4"]]);
    let p = matrix([["0", "1", "0"], ["-1", "0", "0"], ["-1", "0", "-1"]]);
    let g = matrix([["1", "-0.2", "0.2"], ["0", "-1", "-1"], ["-1", "-0.2", "0.2"]]);
    assert_eq!(form.k, k);
    assert_eq!(form.p, p);
    assert_eq!(&form.p * &g, form.k);
    assert_eq!(form.strict, [true, false, false]);

    let (part, fixture) = with_friction("n2_disc_paper", "0.2");
    let [Cone::Of(cone)] = &cones(&part, &fixture, &["na"])[..] else { panic!("the mode is possible") };
    let scaled: BTreeSet<Vec<Q>> = (0..3).map(|column| (0..3).map(|i| &g[(i, column)] * int(5)).collect()).collect();
    let rays: BTreeSet<Vec<Q>> =
        cone.rays.iter().map(|ray| support::member::rational(&support::hull::primitive(ray.clone()))).collect();
    let coprime = |row: &Vec<Q>| support::member::rational(&partplan::exact::primitive_row(row));
    assert_eq!(rays, scaled.iter().map(coprime).collect());
    let strict: Vec<bool> = cone.faces.iter().map(|face| face.strict).collect();
    assert_eq!(strict.iter().filter(|strict| **strict).count(), 1, "only -a_2n is strictly positive");
}

/// Section 4 prints entries 2 and 3 of z in the other order than K and R use; the cone is the same.
#[test]
fn the_printed_order_of_rolling_variables_is_exchanged() {
    let form = cone_form(&disc(), "na", SlidingSign::Table2);
    let (mu, c_n, c_t) = (q("0.2"), int(3), q("1/2"));
    let half = |value: Q| value / (int(2) * &mu);
    let (plus, minus) = (half(&mu * &c_n + &c_t), half(&mu * &c_n - &c_t));
    let forces = |second: &Q, third: &Q| {
        let z = Matrix::from_column_slice(3, 1, &[Q::zero(), second.clone(), third.clone()]);
        let y = &form.n * &form.r * &form.s * &form.v * z;
        [y[(4, 0)].clone(), y[(6, 0)].clone()] // c_1n, c_1t
    };
    assert_eq!(forces(&minus, &plus), [c_n.clone(), c_t.clone()]);
    assert_eq!(forces(&plus, &minus), [c_n, -c_t], "the printed order turns the friction around");
}

/// Section 5.4 prints `s_ij = +mu_k` for the left-sliding set; Table 2 needs `-mu_k`.
#[test]
fn sliding_friction_opposes_motion() {
    let contacts = disc();
    let power = |mode: &str, sign| {
        let form = cone_form(&contacts, mode, sign);
        let ones = Matrix::from_fn(form.v.ncols(), 1, |_, _| int(1));
        let y = &form.n * &form.r * &form.s * &form.v * ones;
        &y[(2, 0)] * &y[(6, 0)] // a_1t c_1t
    };
    for mode in ["lu", "ru", "ls", "ra"] {
        assert!(power(mode, SlidingSign::Table2).is_negative(), "{mode}");
        assert!(power(mode, SlidingSign::Printed).is_positive(), "{mode}");
    }
    let (part, fixture) = with_friction("n2_disc_paper", "0.2");
    let ours = &cones(&part, &fixture, &["ls"])[0];
    let of_sign = |sign| canonical(&paper::inequalities(&cone_form(&contacts, "ls", sign)));
    assert_eq!(*ours, of_sign(SlidingSign::Table2));
    assert_ne!(*ours, of_sign(SlidingSign::Printed));
}

/// Fig. 5: each fixel sees the other inside its friction cone from mu = 3/4 on, strictly so above it.
#[test]
fn two_fixels_close_a_disc_by_force_only_above_three_quarters() {
    for (mu, closes) in [("0", false), ("1/2", false), ("3/4", false), ("750000001/1000000000", true), ("1", true)] {
        let (part, fixture) = with_friction("n2_disc_fig5", mu);
        let answer = stable(&part, &fixture);
        let is_everything = matches!(&answer.weak, Cone::Of(cone) if cone.lines.len() == 3);
        assert_eq!((answer.force_closure, is_everything), (closes, closes), "mu = {mu}");
    }
}

/// Fig. 5: weak stability may hold everywhere, strong stability does not.
#[test]
fn strong_stability_of_the_disc_is_a_proper_subset_at_any_friction() {
    for mu in ["1/10", "1/2", "3/4", "1", "4/3", "2", "100"] {
        let (part, fixture) = with_friction("n2_disc_fig5", mu);
        let answer = stable(&part, &fixture);
        assert!(!answer.strong.is_empty() && !answer.strong.everything, "mu = {mu}");
        let contacts = Contacts::of(&part, &fixture);
        let moving = contacts.moving_modes();
        assert!(contacts.strong(&moving, &wrench(0, -1, 0)), "gravity seats the disc, mu = {mu}");
        assert!(!contacts.strong(&moving, &wrench(0, 1, 0)), "lifting the disc moves it, mu = {mu}");
    }
}

/// Fig. 5 lists the kinematically feasible modes other than `nn`.
#[test]
fn the_disc_has_the_feasible_modes_of_figure_5() {
    let (part, fixture) = seated("n2_disc_fig5");
    let mut printed = ["ss", "sl", "sr", "sn", "ls", "rs", "ns", "ll", "rr", "nn"];
    printed.sort_unstable();
    assert_eq!(stable(&part, &fixture).feasible_modes, printed);
}

/// Table 5 by state. Row 111 prints `mss` twice where `ssm` belongs.
const TABLE_5: [(&str, &[&str]); 8] = [
    ("000", &["sss"]),
    ("100", &["suu", "mss"]),
    ("010", &["usu", "sms"]),
    ("001", &["uus", "ssm"]),
    ("110", &["ssu", "msu", "smu", "mms"]),
    ("101", &["sus", "mus", "sum", "msm"]),
    ("011", &["uss", "ums", "usm", "smm"]),
    ("111", &["sss", "mss", "sms", "mss", "mms", "smm", "msm"]),
];

/// Wrenches on and around every face of the given cones.
fn probes(cones: &[Cone]) -> Vec<Wrench> {
    cones.iter().flat_map(|cone| if let Cone::Of(cone) = cone { landmarks(cone) } else { vec![] }).collect()
}

#[test]
fn twelve_modes_of_table_5_hold_all_others() {
    let (part, fixture) = seated("n3_pawl_02");
    let contacts = Contacts::of(&part, &fixture);
    let twelve = ["suu", "usu", "uus", "msu", "mus", "smu", "sum", "ums", "usm", "mms", "msm", "smm"];
    let named: BTreeSet<String> = twelve.iter().map(|mode| (*mode).to_owned()).collect();
    assert_eq!(unseating_modes(3).into_iter().collect::<BTreeSet<_>>(), named);

    let mut probes = probes(&cones(&part, &fixture, &twelve));
    probes.extend(expected("n3_pawl_02")["wrenches"].as_array().unwrap().iter().map(|entry| wrench_of(&entry["g"])));
    let question = Question { wrenches: probes.clone(), ..Question::default() };
    let verdicts = insertion(&part, &fixture, &question).unwrap().wrenches;
    let (mut seated, mut refused) = (0, 0);
    for (g, verdict) in probes.iter().zip(verdicts) {
        let mut listed = TABLE_5.iter().flat_map(|(_, modes)| modes.iter());
        let is_refused = twelve.iter().any(|mode| contacts.consistent(mode, g));
        assert_eq!(listed.any(|mode| contacts.consistent(mode, g)), is_refused, "{g:?}");
        assert_eq!(verdict.goal, !is_refused, "{g:?}");
        if is_refused { refused += 1 } else { seated += 1 }
    }
    assert!(seated > 0 && refused > 0, "the probes see both sides: {seated} and {refused}");
}

/// From the full state the part may leave fixels 1 and 2 and stay on 3; row 111 as printed does not say so.
#[test]
fn the_last_row_of_table_5_lacks_the_mode_that_keeps_the_third_fixel() {
    let (_, printed) = TABLE_5[7];
    assert!(!printed.contains(&"ssm"));
    let (part, fixture) = seated("n3_pawl_02");
    let contacts = Contacts::of(&part, &fixture);
    let probes = probes(&cones(&part, &fixture, &["ssm"]));
    let missed = probes
        .iter()
        .find(|g| contacts.consistent("bbm", g) && !printed.iter().any(|mode| contacts.consistent(mode, g)));
    assert!(missed.is_some(), "some wrench breaks contacts 1 and 2 by no printed mode");
}

/// Fig. 11: plans shrink as friction rises.
#[test]
fn the_pawl_is_harder_to_seat_the_rougher_it_is() {
    let volumes = ["0.01", "0.20", "0.40", "0.60"].map(|mu| goal_volume("n3_pawl_02", mu));
    assert!(volumes[0].is_positive());
    for pair in volumes.windows(2) {
        assert!(pair[0] > pair[1] || (pair[0].is_zero() && pair[1].is_zero()), "{} then {}", pair[0], pair[1]);
    }
}

/// With one fixel `n` includes pivoting: only forces through the contact hold the part, and half of all wrenches seat it.
#[test]
fn one_fixel_lets_the_part_pivot() {
    for name in ["n1_edge", "n1_vertex"] {
        let (part, fixture) = seated(name);
        let answer = stable(&part, &fixture);
        assert_eq!(answer.strong.dim, Some(2), "{name}");
        let Cone::Of(weak) = &answer.weak else { panic!("rest is possible") };
        assert_eq!(weak.dim, 2, "{name}");
        let goal = insertion(&part, &fixture, &Question::default()).unwrap().goal;
        assert_eq!(goal.volume_in_box, q("1/2"), "{name}");
        let contacts = Contacts::of(&part, &fixture);
        let push: Wrench = std::array::from_fn(|i| -&contacts.list[0].normal[i]);
        let mut off_line = push.clone();
        off_line[2] += q("1/1000000");
        let held = |g: &Wrench| contacts.strong(&contacts.moving_modes(), g);
        assert!(held(&push) && !held(&off_line), "{name}");
    }
}

/// Fig. 4(c, d): sliding down both walls may jam, for certain only when the wall fixels see each other inside both
/// friction cones (here above mu = 1/4).
#[test]
fn a_peg_sliding_down_its_hole_may_always_jam_only_between_rough_walls() {
    let jams_always = |mu: &str| {
        let (part, fixture) = with_friction("n3_peg_jam", mu);
        let found = cones(&part, &fixture, &["lra", "nnu"]);
        let probes = probes(&found[..1]);
        let sliding: Vec<&Wrench> = probes.iter().filter(|g| in_cone(&found[0], g)).collect();
        assert!(!sliding.is_empty(), "the peg can slide down, mu = {mu}");
        let contacts = Contacts::of(&part, &fixture);
        for g in &sliding {
            assert!(contacts.consistent("lra", g));
            assert_eq!(contacts.consistent("nnu", g), in_cone(&found[1], g), "{g:?}");
        }
        sliding.iter().all(|g| in_cone(&found[1], g))
    };
    assert!(jams_always("0.3"));
    assert!(jams_always("0.2501"));
    assert!(!jams_always("0.25"));
    assert!(!jams_always("0.1"));
}

/// (19) with Table 2's `s` would call nothing strongly stable in form closure; Table 1's touching case does not.
#[test]
fn four_fixels_in_form_closure_are_strongly_stable() {
    let (part, fixture) = seated("n4_form_closure");
    assert!(stable(&part, &fixture).strong.everything);
    let contacts = Contacts::of(&part, &fixture);
    assert!(contacts.moving_modes().is_empty());
    assert!(contacts.consistent("ssss", &wrench(0, 0, 0)) && !contacts.consistent("bbbb", &wrench(0, 0, 0)));
}
