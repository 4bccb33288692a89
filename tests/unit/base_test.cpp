// SPDX-License-Identifier: BSD-3-Clause
// Command lines, warnings, files that appear whole or not at all.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "base/error.h"
#include "base/hash.h"
#include "base/hypot.h"
#include "base/printable.h"
#include "base/processors.h"
#include "base/run.h"
#include "base/tempfile.h"
#include "base/threads.h"
#include "base/warnings.h"
#include "base/work_budget.h"
#include "temp_folder.h"

TEST_CASE("command lines become one header line") {
    char a[] = "ptrace", b[] = "-vp", c[] = "two words", d[] = "it's", e[] = "new\nline";
    char* argv[] = {a, b, c, d, e};
    CHECK(base::command_line({argv, argv + 5}) == "ptrace -vp 'two words' 'it'\\''s' 'new line'");
}

TEST_CASE("warnings: the first of a cause is told, the others counted") {
    base::take_warnings();
    int told = 0;
    base::set_warning_sink([&](const std::string& text) {
        ++told;
        CHECK(text == "a.rad:3: odd");
    });
    base::warn("a.rad:3", "odd");
    base::warn("a.rad:4", "odd");
    base::set_warning_sink({});
    CHECK(told == 1);
    const auto all = base::take_warnings();
    CHECK(all.size() == 1);
    CHECK(all[0].second == 2);
    CHECK(base::take_warnings().empty());
    for (int i = 0; i < 100000; ++i) base::warn("", std::to_string(i));
    CHECK(base::take_warnings().size() < 300);  // memory stays bounded
}

TEST_CASE("a file appears whole or not at all") {
    TempFolder folder;
    const std::string path = folder.name("file");
    {
        const base::TempFile temp(path);
        std::ofstream(temp.path()) << "half";
        CHECK_FALSE(std::ifstream(path));
        CHECK(std::ifstream(temp.path()));
    }
    CHECK_FALSE(std::ifstream(path));
    {
        base::TempFile temp(path);
        std::ofstream(temp.path()) << "whole";
        temp.keep();
    }
    std::string text;
    std::ifstream(path) >> text;
    CHECK(text == "whole");
    std::remove(path.c_str());
    CHECK(base::TempFile("/dev/null").path() == "/dev/null");  // never renamed over
}

TEST_CASE("a temporary file is new, and takes the permissions of what it replaces") {
    namespace fs = std::filesystem;
    TempFolder folder;
    const std::string path = folder.name("file");
    std::ofstream(path) << "old";
    for (const auto wanted : {fs::perms(0600), fs::perms(0640), fs::perms(0444)}) {
        fs::permissions(path, wanted);
        base::TempFile temp(path);
        temp.write("new", 3);
        const std::string name = fs::path(temp.path()).filename().string();
        CHECK(name.size() == std::string(".luxpipe-.tmp").size() + 24);
        CHECK(base::TempFile(path).path() != temp.path());
        temp.keep();
        CHECK(fs::status(path).permissions() == wanted);
    }
}

TEST_CASE("text for a terminal: nothing that steers it") {
    const std::string plain = "plain B\xc3\xbcro \xe2\x82\xac \xf0\x9f\x98\x80";
    CHECK(base::printable(plain) == plain);
    CHECK(base::printable("\033]0;x\007\r\n\t\177") == "?]0;x?????");
    CHECK(base::printable("\xc2\x9b"
                          "31m") == "??31m");                          // U+009B begins a sequence, too
    CHECK(base::printable("\x9b\xff\xc3") == "???");                   // no UTF-8
    CHECK(base::printable("\xed\xa0\x80 \xe0\x80\xaf") == "??? ???");  // surrogates, overlong
    CHECK(base::excerpt("12345", 3) == "123...");
}

TEST_CASE("work: one budget, spent once") {
    base::WorkBudget work(10);
    work.spend(4, "a");
    CHECK(work.spend(6));
    CHECK_FALSE(work.spend(1));
    base::WorkBudget other(10);
    CHECK_FALSE(other.spend(11));
    CHECK_FALSE(other.spend(1));  // and nothing is left of what did not do
    CHECK_THROWS_AS(other.fail("room.rad:1"), base::Error);
}

TEST_CASE("hash: nothing is told from one nothing more, and may be at no address") {
    base::Hash a, b;
    a.add_all(std::vector<float>());
    b.add_all(std::vector<float>());
    CHECK(a.text() == b.text());
    b.add_all(std::string());
    CHECK(a.text() != b.text());
}

TEST_CASE("exit statuses") {
    CHECK(base::run("test", [] { return 4; }) == 4);
    CHECK(base::run("test", []() -> int { base::fail("place", "fact"); }) == 1);
    CHECK(base::run("test", []() -> int { base::fail_system("place", "fact"); }) == 2);
    CHECK(base::run("test", []() -> int { throw base::ClosedPipe{}; }) == 0);
    CHECK(base::run("test", []() -> int { throw std::bad_alloc(); }) == 2);
}

TEST_CASE("threads: the first exception of a body leaves on_threads once all bodies have ended") {
    std::atomic<int> started{0}, ended{0};
    const auto failing = [&]() -> int {
        base::on_threads(3, [&] {
            const bool fails = started++ == 0;
            if (fails) throw std::bad_alloc();
            ended++;
        });
        return 0;
    };
    CHECK_THROWS_AS(failing(), std::bad_alloc);
    CHECK(ended == started - 1);
    started = 0;
    CHECK(base::run("test", failing) == 2);
}

TEST_CASE("threads: no further share begins after an exception") {
    std::atomic<int> shares{0};
    CHECK_THROWS_AS(base::in_shares(1000, 1, 3,
                                    [&](size_t, size_t) {
                                        shares++;
                                        base::fail("place", "fact");
                                    }),
                    base::Error);
    CHECK(shares <= 3);
}

TEST_CASE("processors: the least limit of a process's control groups and those above them, rounded up") {
    namespace fs = std::filesystem;
    TempFolder folder;
    const std::string mount = folder.name("groups");
    fs::create_directories(mount + "/job/step");
    fs::create_directories(mount + "/cpu/old");
    std::ofstream(mount + "/cpu.max") << "max 100000\n";
    CHECK(base::control_group_limit("0::/job/step\n", mount) == 0);
    std::ofstream(mount + "/job/step/cpu.max") << "700000 100000\n";
    CHECK(base::control_group_limit("0::/job/step\n", mount) == 7);
    std::ofstream(mount + "/job/cpu.max") << "250000 100000\n";
    CHECK(base::control_group_limit("0::/job/step\n", mount) == 3);
    CHECK(base::control_group_limit("0::/\n", mount) == 0);
    std::ofstream(mount + "/cpu/old/cpu.cfs_quota_us") << "150000\n";
    std::ofstream(mount + "/cpu/old/cpu.cfs_period_us") << "100000\n";
    CHECK(base::control_group_limit("5:memory:/old\n4:cpu,cpuacct:/old/gone\n", mount) == 2);
    std::ofstream(mount + "/cpu/old/cpu.cfs_quota_us") << "-1\n";
    CHECK(base::control_group_limit("4:cpu,cpuacct:/old\n", mount) == 0);
    CHECK(base::control_group_limit("no groups here", mount) == 0);
}

TEST_CASE("processors: the instructions that Linux names in /proc/cpuinfo are found") {
    std::set<std::string> flags;
#if defined(__x86_64__)  // an emulator shows the file of the machine below it
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("flags", 0) != 0) continue;
        std::istringstream words(line);
        for (std::string word; words >> word;) flags.insert(word);
        break;
    }
#endif
    if (flags.empty()) return;  // another processor, another system
    CHECK(base::has_avx2() == (flags.count("avx2") == 1));
    CHECK(base::has_avx512() ==
          (flags.count("avx512f") + flags.count("avx512vl") + flags.count("avx512dq") + flags.count("avx512bw") == 4));
}

TEST_CASE("hypot: the true value to .501 units in the last place, whatever the exponents") {
    if (std::numeric_limits<long double>::digits < 64) return;  // nothing to compare with
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> mantissa(-1, 1);
    std::uniform_int_distribution<int> exponent(-1020, 1022), apart(0, 60);
    double worst = 0;
    bool even = true;
    for (int i = 0; i < 300000; ++i) {
        const int e = exponent(random);
        const double a = std::ldexp(mantissa(random), e),
                     b = std::ldexp(mantissa(random), std::max(-1020, e - apart(random)));
        const double h = base::hypot(a, b);
        const long double exact = std::sqrt((long double)(a)*a + (long double)(b)*b);
        if (h > 1e-290) worst = std::max(worst, double(std::fabs(h - exact) / (std::nextafter(h, INFINITY) - h)));
        even = even && base::hypot(-b, a) == h;
    }
    CHECK(even);
    CHECK(worst < .501);
    CHECK(base::hypot(3, 4) == 5);
    CHECK(base::hypot(0, -0.) == 0);
    CHECK(base::hypot(3e-310, 4e-310) == doctest::Approx(5e-310));
    CHECK(base::hypot(1e-320, 0) == 1e-320);
    CHECK(std::isinf(base::hypot(1.7e308, 1.7e308)));
    CHECK(std::isinf(base::hypot(-INFINITY, NAN)));
    CHECK(std::isnan(base::hypot(NAN, 0)));
    CHECK(std::isnan(base::hypot(1, NAN)));
}
