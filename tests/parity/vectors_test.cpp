// SPDX-License-Identifier: BSD-3-Clause
// vectors_test DEVICE [-n SAMPLES] [ID ...] - RADIANCE's values of single rays against ours, all of them or those
// named. A row agrees if every channel is within 1e-3 of its value, or within 4 standard errors of both means together.
// exceptions.tsv names the rows that differ knowingly; any other failure fails the test, and so does a listed row that
// agrees.  Prints one line a row: id, verdict, expected, got, standard error.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/run.h"
#include "parity/trace_row.h"
#include "device/device.h"

namespace {

std::string list(const std::vector<double>& values) {
    std::string text;
    for (double v : values) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", v);
    return text;
}

bool agrees(const parity::Row& row, const parity::Value& value) {
    if (row.output.size() != value.mean.size()) return false;
    for (size_t c = 0; c < row.output.size(); ++c) {
        const double error = c < 3 ? std::hypot(row.error[c], value.error[c]) : 0;
        const double tolerance = std::max(1e-3 * std::abs(row.output[c]) + 1e-6, 4 * error);
        if (!(std::abs(row.output[c] - value.mean[c]) <= tolerance)) return false;
    }
    return true;
}

// The row with the integral itself in place of RADIANCE's quadrature.
parity::Row with_exact(parity::Row row) {
    for (double& v : row.output) v = *row.exact;
    std::fill(row.error, row.error + 3, 0.0);
    return row;
}

const char* verdict(bool ok, bool listed, bool exact_ok, const std::string& message) {
    if (ok) return listed ? "LISTED BUT AGREES" : "ok";
    if (listed) return exact_ok ? "listed" : "NOT EXACT";
    return message.empty() ? "WRONG" : "UNSUPPORTED";
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("vectors_test", [&] {
        if (argc < 2) base::fail("", "usage: vectors_test device [-n samples] [id ...]");
        const std::string device = argv[1];
        if (device.rfind("opencl", 0) == 0 && device::opencl_devices().empty()) {
            fmt::print("skipped: no OpenCL device here\n");
            return 77;
        }
        long samples = 1 << 14;
        std::vector<std::string> ids(argv + 2, argv + argc);
        if (ids.size() > 1 && ids[0] == "-n") {
            samples = std::atol(ids[1].c_str());
            ids.erase(ids.begin(), ids.begin() + 2);
        }
        if (chdir(LUXPIPE_TESTS "/golden/vectors") != 0) base::fail_system("golden/vectors", "no such folder");
        auto rows = parity::read_rays("vectors.tsv");
        for (const auto& row : parity::read_rays("found.tsv")) rows.push_back(row);
        std::map<std::string, std::string> reasons;
        for (const auto& e : parity::read_exceptions("../../parity/exceptions.tsv")) reasons[e.id] = e.reason;
        parity::RowTracer tracer(device, samples);
        int agreeing = 0, excepted = 0, wrong = 0, total = 0;
        for (const auto& row : rows) {
            if (!ids.empty() && std::find(ids.begin(), ids.end(), row.id) == ids.end()) continue;
            const bool listed = reasons.count(row.id) != 0;
            parity::Value value;
            std::string message;
            bool ok = false;
            try {
                value = tracer.trace(row);
                ok = agrees(row, value);
            } catch (const base::Error& e) {
                message = e.what();
            }
            total++;
            if (ok) agreeing++;
            const bool exact_ok = !listed || !row.exact || agrees(with_exact(row), value);
            if (ok != listed && exact_ok) excepted += listed;
            else wrong++;
            fmt::print("{}\t{}\t{}\t{}\t{}\t{}{}\n", row.id, verdict(ok, listed, exact_ok, message), list(row.output),
                       list(value.mean), list({value.error[0], value.error[1], value.error[2]}), value.samples,
                       message.empty() ? "" : "\t" + message);
            std::fflush(stdout);
        }
        fmt::print("{} rows on {}: {} agree, {} differ as listed, {} wrong\n", total, device, agreeing, excepted,
                   wrong);
        return wrong ? 1 : 0;
    });
}
