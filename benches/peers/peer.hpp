// What every peer's driver shares: the rows of one instance, and the CPU time that a conversion takes.
//
// Usage of a driver: NAME ROWS. It prints the median CPU time of one conversion in microseconds and how many rows the
// result has, linear ones apart: "MICROSECONDS ROWS LINEAR". Neither the apex of a cone counts nor the facet at infinity,
// which some programs list and others do not. More than CAP seconds of CPU time (60 by default) end a driver.

#pragma once

#include <gmpxx.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

// Coprime integer rows (b, a) of a polyhedron, as the format of cddlib means them, up to a positive factor.
struct Rows {
    bool inequalities = false;
    bool cone = false;  // no constant anywhere: column b is zero
    std::vector<std::vector<mpz_class>> rows;
    std::vector<bool> linear;

    std::size_t columns() const { return rows.empty() ? 0 : rows[0].size(); }
};

struct Size {
    std::size_t rows, linear;
};

inline Rows read_rows(const char* path) {
    std::ifstream file(path);
    std::string kind, shape;
    std::size_t columns = 0, count = 0;
    Rows out;
    file >> kind >> shape >> columns >> count;
    out.inequalities = kind == "H";
    out.cone = shape == "cone";
    for (std::size_t row = 0; row < count; ++row) {
        bool linear = false;
        file >> linear;
        out.linear.push_back(linear);
        std::vector<mpz_class> entries(columns);
        for (auto& entry : entries) file >> entry;
        out.rows.push_back(entries);
    }
    if (!file) {
        std::fprintf(stderr, "%s: not a file of rows\n", path);
        std::exit(2);
    }
    return out;
}

inline double cpu_seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Prints the median of five samples of at least 40 ms each, since some clocks tick every 4 ms; of fewer when one
// conversion is long.
template <class Convert>
int report(Convert convert) {
    const char* cap = std::getenv("CAP");
    const rlim_t seconds = cap ? std::strtoul(cap, nullptr, 10) : 60;
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);

    double start = cpu_seconds();
    const Size size = convert();
    const double first = cpu_seconds() - start;
    std::vector<double> samples;
    if (first > 2.0) samples.push_back(first);
    const std::size_t count = first > 2.0 ? 0 : first > 0.2 ? 3 : 5;
    std::size_t repeats = 1;
    for (double spent = 0.0; count > 0;) {
        start = cpu_seconds();
        for (std::size_t k = 0; k < repeats; ++k) convert();
        spent = cpu_seconds() - start;
        if (spent >= 0.04) break;
        repeats *= 2;
    }
    for (std::size_t k = 0; k < count; ++k) {
        start = cpu_seconds();
        for (std::size_t run = 0; run < repeats; ++run) convert();
        samples.push_back((cpu_seconds() - start) / double(repeats));
    }
    std::sort(samples.begin(), samples.end());
    std::printf("%.4f %zu %zu\n", samples[samples.size() / 2] * 1e6, size.rows, size.linear);
    return 0;
}
