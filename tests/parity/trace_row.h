// SPDX-License-Identifier: BSD-3-Clause
// One row of the table on one device: rtrace's arguments read as ptrace's, the ray traced until its mean is known to
// 2e-4 of its brightest channel or the limit of samples is reached.
#pragma once
#include <memory>
#include <string>
#include "parity/vectors.h"
#include "flatten/host_tracer.h"
#include "unit/renderer.h"

namespace parity {

struct Value {
    std::vector<double> mean;
    double error[3] = {0, 0, 0};
    long samples = 0;
};

class RowTracer {
public:
    // A ray that takes one of several ways may not show its rarest, a reflection of 0.4 %, before 4096 samples.
    // least: the least chance of each way, for rarer ones (kernels/integrator/sample_bsdf.h).
    RowTracer(std::string device, long most_samples, long fewest_samples = 4096, double least = 0)
        : device_(std::move(device)), most_(most_samples), fewest_(fewest_samples), least_(least) {}
    Value trace(const Row& row);  // throws Error for what ptrace does not support
private:
    Value geometry(const Row& row);
    std::string device_;
    long most_, fewest_;
    double least_;
    std::string key_;  // scene and arguments of the renderer at hand
    std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace parity
