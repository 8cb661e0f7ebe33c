//! Located impacts on the scenes on which other engines were measured: errors, order, and the error that a run prints.

use crate::peers::{Peer, scenes, sphere, sphere_error};
use partplan::answer::{Simulation, Status};
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Planar, World};

fn run(world: &World<Planar>, model: ModelKind, step: Option<f64>) -> Simulation<Planar> {
    let options = Options { model, step, frames: 1_000_000, ..Options::default() };
    simulate(world, &options, &mut |_| true).unwrap()
}

fn peer(name: &str) -> Peer {
    scenes().into_iter().find(|peer| peer.name == name).unwrap_or_else(|| panic!("no scene {name}"))
}

/// Largest error at steps of 10 ms and of 1 ms, relative to the scale of the scene: about twice what is reached, and
/// rounding where the scheme is exact.
const BOUNDS: [(&str, f64, f64); 17] = [
    ("slide_stop", 1e-5, 4e-7),
    ("incline_stick", 1e-15, 1e-15),
    ("incline_slip", 1e-12, 1e-12),
    ("bounce_e08", 1e-10, 1e-10),
    ("backspin_57", 8e-5, 8e-7),
    ("rocking_block", 5e-5, 1.2e-5),
    ("peg_drop_mu0", 1e-12, 1e-12),
    ("peg_drop_mu0.2", 3e-4, 3e-6),
    ("peg_drop_mu1", 5e-3, 6e-5),
    ("vgroove_mu0.5", 1e-15, 1e-15),
    ("vgroove_mu1.2", 1e-15, 1e-15),
    ("stack4", 1e-12, 1e-12),
    ("flat_landing", 1e-12, 1e-12),
    ("mass_ratio_100", 1e-10, 1e-11),
    ("mass_ratio_1000", 3e-9, 3e-10),
    ("cradle3", 1e-14, 1e-14),
    ("popout_1mm", 0.0, 0.0),
];

#[test]
fn errors_stay_below_their_bounds() {
    let mut n_scenes = 0;
    for peer in scenes() {
        let Some((_, coarse, fine)) = BOUNDS.iter().find(|(name, ..)| *name == peer.name) else {
            assert!(peer.name.starts_with("painleve"), "{} has no bound", peer.name);
            continue;
        };
        n_scenes += 1;
        for (h, bound) in [(1e-2, coarse), (1e-3, fine)] {
            let run = run(&peer.world, ModelKind::Moreau, Some(h));
            assert_eq!(run.status, Status::Complete, "{}: {:?}", peer.name, run.notes);
            let error = peer.error(&run);
            assert!(error <= *bound, "{} at h = {h}: error {error:e}, at most {bound:e}", peer.name);
        }
    }
    assert_eq!(n_scenes, BOUNDS.len());
}

/// The ball of Fig. 3 bounces and slips on the exact cone: rounding is all that is left, at any step.
#[test]
fn a_bouncing_ball_ends_where_it_must() {
    for h in [1e-2, 1e-3] {
        let options = Options { model: ModelKind::Moreau, step: Some(h), ..Options::default() };
        let error = sphere_error(&simulate(&sphere(), &options, &mut |_| true).unwrap());
        assert!(error < 1e-11, "{error:e} m at h = {h}");
    }
}

/// Second order: an eighth of the step leaves a 64th of the error.
///
/// The error of one run depends on where in a step the slip ends or a corner lifts, so the mean over eight nearly equal
/// steps is compared, and may be off by a factor of 2.
#[test]
fn errors_fall_with_the_square_of_the_step() {
    for name in ["slide_stop", "backspin_57", "peg_drop_mu0.2", "peg_drop_mu1", "rocking_block"] {
        let peer = peer(name);
        let mean = |n: usize| {
            let error = |j: usize| {
                let h = peer.world.duration / (n + j * n / 40) as f64;
                peer.error(&run(&peer.world, ModelKind::Moreau, Some(h)))
            };
            (0..8).map(error).sum::<f64>() / 8.0
        };
        let (coarse, fine) = (mean(80), mean(640));
        assert!((32.0..128.0).contains(&(coarse / fine)), "{name}: errors {coarse:e} and {fine:e}");
    }
}

/// Length that an error of 1 stands for (m), where the scene ends in poses that are known.
fn scale(name: &str) -> Option<f64> {
    match name {
        "slide_stop" => Some(1.529_052),
        "incline_slip" => Some(0.087_567_5),
        "bounce_e08" => Some(0.15),
        "backspin_57" => Some(1.0),
        // a swing of 0.0947 rad at an arm of 0.206 m
        "rocking_block" => Some(0.094_7 * 0.206),
        // velocities, over half a second
        "cradle3" => Some(0.5),
        name if name.starts_with("painleve") => None,
        _ => Some(0.1),
    }
}

/// Without a step the run chooses one by the tolerance of 1 mm: the end is within it, and in at least 95 % of the
/// scenes within twice the error that is printed. Rounding is not estimated: 1e-12 m are allowed for it.
///
/// Against the scale of the scene the error is below 1e-3 in every scene but one, the peg that sticks: 1.7e-4 m of its
/// 0.1 m. Told the scale, by a tolerance of 1e-4 m, that one is below 1e-3 too.
#[test]
fn the_printed_error_brackets_the_true_one() {
    let (mut bracketed, mut n_scenes) = (0, 0);
    for peer in scenes() {
        let Some(scale) = scale(&peer.name) else { continue };
        let run = run(&peer.world, ModelKind::Auto, None);
        let (error, printed) = (peer.error(&run), run.model.error.unwrap());
        assert!(printed <= 1e-3 && error * scale <= 1e-3, "{}: {error:e}, {printed:e} m printed", peer.name);
        let bound = if peer.name == "peg_drop_mu1" { 2e-3 } else { 1e-3 };
        assert!(error <= bound, "{}: {error:e}", peer.name);
        n_scenes += 1;
        bracketed += usize::from(error * scale <= 2.0 * printed + 1e-12);
    }
    let run_sphere = simulate(&sphere(), &Options::default(), &mut |_| true).unwrap();
    bracketed += usize::from(sphere_error(&run_sphere) <= 2.0 * run_sphere.model.error.unwrap() + 1e-12);
    n_scenes += 1;
    assert_eq!(n_scenes, 18);
    assert!(bracketed * 100 >= 95 * n_scenes, "only {bracketed} of {n_scenes}");
    let sticking = peer("peg_drop_mu1");
    let options = Options { tolerance: 1e-4, ..Options::default() };
    let error = sticking.error(&simulate(&sticking.world, &options, &mut |_| true).unwrap());
    assert!(error <= 1e-3, "{error:e}");
}

/// Where rigid bodies have no motion, or several, no error is the last word: the status says so.
#[test]
fn paradoxes_are_named_not_measured() {
    for (name, status) in
        [("painleve_inconsistent", Status::Inconsistent), ("painleve_indeterminate", Status::Ambiguous)]
    {
        for (model, step) in
            [(ModelKind::Auto, None), (ModelKind::Moreau, Some(1e-3)), (ModelKind::StewartTrinkle, Some(1e-3))]
        {
            assert_eq!(run(&peer(name).world, model, step).status, status, "{name} by {model:?}");
        }
    }
}
