// cddlib over GMP rationals.

#include "peer.hpp"

#define GMPRATIONAL
extern "C" {
#include <cddlib/setoper.h>
#include <cddlib/cdd.h>
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
        const Size size{std::size_t(other->rowsize - set_card(other->linset)), std::size_t(set_card(other->linset))};
        dd_FreeMatrix(other);
        dd_FreePolyhedra(polyhedron);
        return size;
    });
}
