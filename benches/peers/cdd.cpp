// cddlib over GMP rationals.

#include "peer.hpp"

#define GMPRATIONAL
extern "C" {
#include <cddlib/setoper.h>
#include <cddlib/cdd.h>
}

static bool is_at_infinity(const mytype* row, std::size_t columns) {
    return std::all_of(row + 1, row + columns, [](const mytype& entry) { return mpq_sgn(entry) == 0; });
}

int main(int, char** argv) {
    const Rows given = read_rows(argv[1]);
    dd_set_global_constants();
    const std::size_t count = given.rows.size(), columns = given.columns();
    dd_MatrixPtr matrix = dd_CreateMatrix(long(count), long(columns));
    matrix->representation = given.inequalities ? dd_Inequality : dd_Generator;
    matrix->numbtype = dd_Rational;
    for (std::size_t row = 0; row < count; ++row) {
        if (given.linear[row]) set_addelem(matrix->linset, long(row) + 1);
        const mpz_class& first = given.rows[row][0];
        const bool is_point = !given.inequalities && first != 0;
        for (std::size_t column = 0; column < columns; ++column) {
            mpq_class entry(given.rows[row][column]);
            if (is_point) entry /= first;
            mpq_set(matrix->matrix[row][column], entry.get_mpq_t());
        }
    }
    return report([&] {
        dd_ErrorType error;
        dd_PolyhedraPtr polyhedron = dd_DDMatrix2Poly(matrix, &error);
        dd_MatrixPtr other = given.inequalities ? dd_CopyGenerators(polyhedron) : dd_CopyInequalities(polyhedron);
        Size size{0, std::size_t(set_card(other->linset))};
        for (long row = 0; row < other->rowsize; ++row) {
            if (set_member(row + 1, other->linset)) continue;
            const bool is_left_out = given.inequalities ? given.cone && mpq_sgn(other->matrix[row][0]) != 0
                                                        : is_at_infinity(other->matrix[row], columns);
            if (!is_left_out) ++size.rows;
        }
        dd_FreeMatrix(other);
        dd_FreePolyhedra(polyhedron);
        return size;
    });
}
