// Normaliz, rational cones in arbitrary precision with its own machine-integer start.

#include "peer.hpp"

#include <libnormaliz/libnormaliz.h>

using namespace libnormaliz;

static bool is_at_infinity(const std::vector<mpz_class>& row) {
    return std::all_of(row.begin() + 1, row.end(), [](const mpz_class& entry) { return entry == 0; });
}

int main(int, char** argv) {
    const Rows given = read_rows(argv[1]);
    const std::size_t skipped = given.cone ? 1 : 0;
    std::vector<std::vector<mpz_class>> linear, others;
    for (std::size_t row = 0; row < given.rows.size(); ++row) {
        std::vector<mpz_class> entries(given.rows[row].begin() + long(skipped), given.rows[row].end());
        (given.linear[row] ? linear : others).push_back(entries);
    }
    const std::size_t columns = given.columns() - skipped;
    if (given.inequalities && !given.cone) {
        std::vector<mpz_class> positive(columns);
        positive[0] = 1;
        others.push_back(positive);
    }
    std::map<Type::InputType, std::vector<std::vector<mpz_class>>> input;
    if (given.inequalities) {
        input[Type::inequalities] = others;
        if (!linear.empty()) input[Type::equations] = linear;
    } else {
        input[Type::cone] = others;
        if (!linear.empty()) input[Type::subspace] = linear;
    }
    return report([&] {
        Cone<mpz_class> cone(input);
        cone.setVerbose(false);
        if (given.inequalities) {
            cone.compute(ConeProperty::ExtremeRays);
            return Size{cone.getExtremeRays().size(), cone.getMaximalSubspace().size()};
        }
        cone.compute(ConeProperty::SupportHyperplanes);
        const auto& facets = cone.getSupportHyperplanes();
        const auto at_infinity = given.cone ? 0 : std::count_if(facets.begin(), facets.end(), is_at_infinity);
        return Size{facets.size() - std::size_t(at_infinity), cone.getEquations().size()};
    });
}
