// The Parma Polyhedra Library, closed polyhedra.

#include "peer.hpp"

#include <ppl.hh>

namespace ppl = Parma_Polyhedra_Library;

int main(int, char** argv) {
    const Rows given = read_rows(argv[1]);
    ppl::Constraint_System constraints;
    ppl::Generator_System generators;
    bool has_point = false;
    for (std::size_t row = 0; row < given.rows.size(); ++row) {
        const auto& entries = given.rows[row];
        ppl::Linear_Expression expression;
        for (std::size_t column = entries.size() - 1; column > 0; --column) {
            expression += entries[column] * ppl::Variable(column - 1);
        }
        if (given.inequalities) {
            expression += entries[0];
            constraints.insert(given.linear[row] ? expression == 0 : expression >= 0);
        } else if (given.linear[row]) {
            generators.insert(ppl::line(expression));
        } else if (entries[0] == 0) {
            if (!expression.all_homogeneous_terms_are_zero()) generators.insert(ppl::ray(expression));
        } else {
            has_point = true;
            generators.insert(ppl::point(expression, entries[0]));
        }
    }
    if (!given.inequalities && !has_point) generators.insert(ppl::point());
    const auto dimension = given.columns() - 1;
    if (given.inequalities) {
        constraints.set_space_dimension(dimension);
        return report([&] {
            ppl::C_Polyhedron polyhedron(constraints);
            Size size{0, 0};
            for (const auto& generator : polyhedron.minimized_generators()) {
                if (given.cone && generator.is_point()) continue;
                ++(generator.is_line() ? size.linear : size.rows);
            }
            return size;
        });
    }
    generators.set_space_dimension(dimension);
    return report([&] {
        ppl::C_Polyhedron polyhedron(generators);
        Size size{0, 0};
        for (const auto& constraint : polyhedron.minimized_constraints()) {
            ++(constraint.is_equality() ? size.linear : size.rows);
        }
        return size;
    });
}
