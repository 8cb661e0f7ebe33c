//! Writing polyhedron files.

use crate::cone::Polyhedron;

/// The text of a polyhedron file; reading it gives the same polyhedron.
///
/// # Examples
/// ```
/// use partplan::cone::{Polyhedron, Representation, format};
/// use partplan::exact::ratio;
/// let row = vec![ratio(1, 1), ratio(-1, 2)];
/// let half_line = Polyhedron::new(Representation::Inequalities, 2, vec![row], &[]);
/// assert_eq!(format::write(&half_line), "H-representation\nbegin\n 1 2 rational\n 1 -1/2\nend\n");
/// ```
#[must_use]
pub fn write(polyhedron: &Polyhedron) -> String {
    let mut text = format!("{}-representation\n", polyhedron.representation().letter());
    if !polyhedron.linear().is_empty() {
        text.push_str(&format!("linearity {}", polyhedron.linear().len()));
        for row in polyhedron.linear() {
            text.push_str(&format!(" {}", row + 1));
        }
        text.push('\n');
    }
    let is_integral = polyhedron.rows().iter().flatten().all(|value| value.is_integer());
    let kind = if is_integral { "integer" } else { "rational" };
    text.push_str(&format!("begin\n {} {} {kind}\n", polyhedron.rows().len(), polyhedron.columns()));
    for row in polyhedron.rows() {
        for value in row {
            text.push_str(&format!(" {value}"));
        }
        text.push('\n');
    }
    text.push_str("end\n");
    text
}
