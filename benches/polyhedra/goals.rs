//! What the kernel aims at, instance by instance: a few times the speed of the best exact program known.

/// Instance and microseconds.
const GOALS: [(&str, f64); 32] = [
    ("wrench3/w3g_n3_m_poly", 0.35),
    ("wrench3/w3g_n6_m_poly", 0.4),
    ("wrench3/w3g_n5_m_big", 0.4),
    ("wrench3/fan3_k128_b24", 30.0),
    ("wrench/wr_n3_nnn_poly", 3.0),
    ("wrench/wr_n6_llllll_poly", 6.0),
    ("wrench/wr_n6_nnnnnn_big", 45.0),
    ("wrench6/w6_n3_k8", 50.0),
    ("wrench6/w6_n6_k8", 550.0),
    ("wrench6/w6_n5_k12", 1_500.0),
    ("classic/cube12", 330.0),
    ("classic/cyclic20_8", 1_600.0),
    ("made/psimp4x4", 45.0),
    ("made/cyclic30_8", 65e3),
    ("classic/rnd01_9_40", 7e3),
    ("classic/rnd01_10_60", 380e3),
    ("classic/rsph7_40", 21e3),
    ("classic/rhp7_40", 17e3),
    ("classic/rhp10_30", 190e3),
    ("degenerate/metcone6", 400.0),
    ("degenerate/metpol6", 4e3),
    ("degenerate/cutcone6", 430.0),
    ("made/cutpol6", 770.0),
    ("degenerate/birk6", 40e3),
    ("degenerate/transp4x5", 900.0),
    ("classic/hypsim10_5", 115.0),
    ("made/perm7", 36e3),
    ("degenerate/perm8", 800e3),
    ("made/cutcone7", 8e6),
    ("coeff/ci8_18_b100", 11_500.0),
    ("coeff/ci8_18_b200", 19e3),
    ("coeff/ci5_16_b31", 130.0),
];

/// Prints every goal that `measured` knows a time for.
pub fn report(measured: impl Fn(&str) -> Option<f64>) {
    let known: Vec<_> = GOALS.iter().filter_map(|(name, goal)| Some((name, goal, measured(name)?))).collect();
    if known.is_empty() {
        return;
    }
    println!("\n| instance | measured | goal | |\n|---|---|---|---|");
    for (name, goal, time) in known {
        let verdict = if time <= *goal { "reached" } else { "not reached" };
        println!("| {name} | {} | {} | {verdict} |", super::shown(time), super::shown(*goal));
    }
}
