// lrs as a program: the CPU time of its process, less that of the same process on an instance without work.
//
// The library keeps state between calls and may end the process, hence the program. Starting it costs about a
// millisecond: what takes less than half of one cannot be told from that, and no figure is printed.

#include "peer.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

static void write_polyhedron(const Rows& given, const std::string& path) {
    std::ofstream out(path);
    std::size_t linear = 0;
    std::string numbers;
    for (std::size_t row = 0; row < given.rows.size(); ++row) {
        if (!given.linear[row]) continue;
        ++linear;
        numbers += " " + std::to_string(row + 1);
    }
    out << (given.inequalities ? "H" : "V") << "-representation\n";
    if (linear > 0) out << "linearity " << linear << numbers << "\n";
    out << "begin\n" << given.rows.size() << " " << given.columns() << " rational\n";
    for (const auto& row : given.rows) {
        const bool is_point = !given.inequalities && row[0] != 0;
        for (const auto& entry : row) {
            mpq_class value(entry);
            if (is_point) value /= row[0];
            out << " " << value;
        }
        out << "\n";
    }
    out << "end\n";
}

static void run(const std::string& path) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const char* arguments[] = {"lrs", path.c_str(), nullptr};
    pid_t child;
    if (posix_spawnp(&child, "lrs", &actions, nullptr, const_cast<char**>(arguments), environ) != 0) std::exit(2);
    int status = 0;
    waitpid(child, &status, 0);
    posix_spawn_file_actions_destroy(&actions);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) std::exit(1);
}

static double spent() {
    rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

static double median_of(const std::string& path) {
    std::vector<double> samples;
    for (double total = 0.0; samples.size() < 5 && (samples.empty() || total < 2.0);) {
        const double start = spent();
        run(path);
        samples.push_back(spent() - start);
        total += samples.back();
    }
    std::sort(samples.begin(), samples.end());
    return samples[samples.size() / 2];
}

int main(int, char** argv) {
    const char* cap = std::getenv("CAP");
    const rlim_t seconds = cap ? std::strtoul(cap, nullptr, 10) : 60;
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    const Rows given = read_rows(argv[1]);
    const std::string path = std::string(argv[1]) + ".lrs", idle = path + ".idle";
    write_polyhedron(given, path);
    Rows nothing;
    nothing.rows = {{1, 0}};
    nothing.linear = {false};
    write_polyhedron(nothing, idle);
    const double start = median_of(idle);
    const double microseconds = (median_of(path) - start) * 1e6;
    if (microseconds < 500.0) return 1;
    std::printf("%.4f - -\n", microseconds);
    return 0;
}
