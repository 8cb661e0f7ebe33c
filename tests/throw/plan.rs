//! The whole planner against the public cases.

use super::expected::{self, Expected};
use partplan::answer::Throw;
use partplan::planner::{self, ThrowQuestion};

fn plan(case: &Expected) -> Throw {
    planner::throw(&case.part(), &case.thrower(), &ThrowQuestion::default(), &mut |_| true).unwrap()
}

#[test]
fn show() {
    for case in expected::all() {
        let start = std::time::Instant::now();
        let answer = plan(&case);
        eprintln!("== {} {:?}", case.name, start.elapsed());
        for edge in &answer.reach.edges {
            eprintln!(
                "  edge {} low {} flip {:?} max {} lowest {:?} pieces {}",
                edge.edge,
                edge.r_low,
                edge.r_flip,
                edge.r_max,
                edge.lowest_image,
                edge.pieces.len()
            );
        }
        eprintln!("  inv {} prop {} {:?}", answer.reach.is_invariant, answer.reach.proposition, answer.reach.problems);
        eprintln!("  hybrid {:?}", answer.hybrid.cycles);
        for set in &answer.limit.sets {
            eprintln!(
                "  set {:?} {:?} jogs {:?} tpc {} lyap {} period {:?} pattern {:?} sec {} trans {} starts {}",
                set.bands,
                set.transitions,
                set.jogs,
                set.throws_per_cycle,
                set.lyapunov,
                set.period,
                set.pattern,
                set.seconds_per_throw,
                set.transient,
                set.starts.len()
            );
        }
        eprintln!(
            "  unique {} in reach {} ended {}",
            answer.limit.is_unique,
            answer.limit.is_unique_in_reach,
            answer.limit.ended.len()
        );
        for sensor in &answer.sensors {
            eprintln!("  sensor {:?} {:?}", sensor.windows, sensor.beyond);
        }
        let c = &answer.certificate;
        eprintln!(
            "  cert inv {} comps {} unique {} beyond {:?} cells {} width {} images {} limit {:?} ce {:?}",
            c.is_invariant,
            c.components.len(),
            c.is_unique,
            c.beyond,
            c.cells,
            c.width,
            c.images,
            c.limit,
            c.counterexample
        );
        for comp in c.components.iter().take(3) {
            eprintln!("    {} {} {:?}", comp.cells, comp.is_terminal, comp.bands);
        }
    }
}
