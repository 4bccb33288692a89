// SPDX-License-Identifier: BSD-3-Clause
// See processors.h.  Control groups: cgroup v2's cpu.max ("quota period" or "max period"), v1's cpu.cfs_quota_us (-1:
// none) and cpu.cfs_period_us; the limits of a group and of all groups above it hold.
#include "base/processors.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif
#include <fmt/core.h>
#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "base/value.h"

namespace base {
namespace {

constexpr long most_threads = 4096;
unsigned said_by_user = 0;

// Processors that the process may run on; the set grows until the system's fits.
unsigned affinity() {
#ifdef __linux__
    for (int most = 1024; most <= 1 << 20; most *= 2) {
        cpu_set_t* set = CPU_ALLOC(size_t(most));
        if (!set) break;
        const size_t size = CPU_ALLOC_SIZE(size_t(most));
        const bool known = sched_getaffinity(0, size, set) == 0;
        const int count = known ? CPU_COUNT_S(size, set) : 0;
        CPU_FREE(set);
        if (known) return unsigned(count);
    }
#endif
    return std::thread::hardware_concurrency();
}

std::string first_line(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    return line;
}

// Processors that a control group may use, its quota over its period; 0 where there is no limit.
double cgroup_cpu_quota(const std::string& folder, bool version2) {
    std::istringstream in(version2 ? first_line(folder + "/cpu.max")
                                   : first_line(folder + "/cpu.cfs_quota_us") + " " +
                                         first_line(folder + "/cpu.cfs_period_us"));
    double quota = 0, period = 0;
    return in >> quota >> period && quota > 0 && period > 0 ? quota / period : 0;
}

unsigned environment_count(const char* name) {
    const char* text = std::getenv(name);
    const int count = text ? std::atoi(text) : 0;
    return count > 0 ? unsigned(count) : 0;
}

// The least limit that is one.
void limit(unsigned& count, unsigned by) {
    if (by) count = std::min(count, by);
}

unsigned found() {
    if (const char* wanted = std::getenv("LUXPIPE_THREADS"); wanted && *wanted) {
        const long count = to_int(wanted, "LUXPIPE_THREADS");
        if (count < 1 || count > most_threads)
            fail("LUXPIPE_THREADS", fmt::format("{} is not a number of threads", count));
        return unsigned(count);
    }
    std::ostringstream groups;
    groups << std::ifstream("/proc/self/cgroup").rdbuf();
    unsigned count = std::max(1u, affinity());
    limit(count, control_group_limit(groups.str(), "/sys/fs/cgroup"));
    limit(count, environment_count("SLURM_CPUS_PER_TASK"));
    return count;
}

}  // namespace

unsigned control_group_limit(const std::string& groups, const std::string& mount) {
    double least = 0;
    std::istringstream lines(groups);
    for (std::string line; std::getline(lines, line);) {
        const size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const bool version2 = controllers == ",,";
        if (!version2 && controllers.find(",cpu,") == std::string::npos) continue;
        const std::string top = mount + (version2 ? "" : "/cpu");
        for (std::string group = line.substr(second + 1);; group.erase(group.rfind('/'))) {
            const double quota = cgroup_cpu_quota(top + group, version2);
            if (quota > 0 && (least == 0 || quota < least)) least = quota;
            if (group.find('/') == std::string::npos) break;
        }
    }
    return unsigned(std::ceil(std::min(least, 1e6)));
}

// The processor is asked itself, and the system whether it keeps these registers: zig's library answers
// __builtin_cpu_supports with no.
#if defined(__x86_64__)
static bool has(unsigned state, unsigned instructions) {
    unsigned a = 0, b = 0, c = 0, d = 0, kept = 0;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & bit_OSXSAVE)) return false;
    __asm__("xgetbv" : "=a"(kept), "=d"(d) : "c"(0));
    return (kept & state) == state && __get_cpuid_count(7, 0, &a, &b, &c, &d) && (b & instructions) == instructions;
}
bool has_avx2() { return has(0x6, bit_AVX2); }
bool has_avx512() { return has(0xe6, bit_AVX512F | bit_AVX512VL | bit_AVX512DQ | bit_AVX512BW); }
#else
bool has_avx2() { return false; }
bool has_avx512() { return false; }
#endif

void use_processors(unsigned count) { said_by_user = count; }

unsigned processors() {
    static const unsigned by_itself = found();
    return said_by_user ? said_by_user : by_itself;
}

}  // namespace base
