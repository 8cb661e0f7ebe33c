use partplan::complementarity::*;
#[test]
fn dbg() {
    // block .2 x .1 sliding: contacts at (-.1,-.05), (.1,-.05), m=1, J=1/240
    let j = [0.0,1.0,-0.1, 0.0,1.0,0.1, 1.0,0.0,0.05, -1.0,0.0,-0.05, 1.0,0.0,0.05, -1.0,0.0,-0.05];
    let im = [1.0,1.0,240.0]; let mu=[0.3,0.3];
    let h = 1e-3; let v=[3.0,-9.81*h,0.0];
    let dot=|r:&[f64]| r.iter().zip(&v).map(|(a,b)|a*b).sum::<f64>();
    let mut q: Vec<f64> = j.chunks(3).map(dot).collect(); q.extend([0.0,0.0]);
    let f = Factors{jacobian:&j,inverse_mass:&im,mu:&mu,directions:2,q:&q};
    let mut m=Vec::new(); f.assemble(&mut m).unwrap();
    let lcp = Lcp{m:&m,q:&q};
    let mut s = Solver::default();
    let Verdict::Solved(sol) = s.solve(lcp, None, &|| f.to_exact()).unwrap() else {panic!()};
    println!("{:?} {:?} {:?}", sol.rung, sol.z, sol.basis.iter().collect::<Vec<_>>());
    let b = sol.basis.clone();
    let Verdict::Solved(sol) = s.solve(lcp, Some(&b), &|| f.to_exact()).unwrap() else {panic!()};
    println!("{:?} {:?} {:?}", sol.rung, sol.z, sol.basis.iter().collect::<Vec<_>>());
}
