// SPDX-License-Identifier: BSD-3-Clause
// The self-test of a device that is not OpenCL: the processor under another name, with right and with wrong numbers.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/warnings.h"
#include "device/device.h"
#include "render/self_test.h"
#include "temp_folder.h"

namespace kernels {
#include "kernels/cal/cal_noise.h"
#include "kernels/self_test.h"
}  // namespace kernels

namespace {

using device::Params;

class MadeUp : public device::Device {
public:
    explicit MadeUp(float factor) : factor_(factor) {}
    std::string name() const override { return "made-up"; }
    void upload(std::shared_ptr<const flatten::FlatScene> scene) override { cpu_->upload(std::move(scene)); }
    void run(const Params& par, std::vector<float>& rgb) override {
        passes++;
        cpu_->run(par, rgb);
    }
    void splat(const Params& par, const std::vector<device::SplatRay>& rays, std::vector<float>& rgb) override {
        cpu_->splat(par, rays, rgb);
    }
    void pilot(const Params& par, const std::vector<device::PilotRay>& rays,
               std::vector<device::PilotEnd>& ends) override {
        cpu_->pilot(par, rays, ends);
    }
    uint32_t preferred_batch_size() const override { return cpu_->preferred_batch_size(); }
    std::string identity() override { return "made-up"; }
    std::vector<float> self_test_numbers(uint32_t n) override {
        std::vector<float> out(n);
        for (uint32_t i = 0; i < n; i++)
            out[i] = factor_ * kernels::self_test_value(i / SELF_TEST_VALUES, i % SELF_TEST_VALUES);
        return out;
    }

    int passes = 0;

private:
    float factor_;
    std::unique_ptr<device::Device> cpu_ = device::make_cpu_device("cpu");
};

// Own bits of a device whose numbers are the processor's times factor; passes: how often it ran.
std::string own_bits(float factor, const std::string& folder, int passes) {
    MadeUp device(factor);
    const std::string bits = render::self_test(device, folder);
    CHECK(device.passes == passes);
    return bits;
}

}  // namespace

TEST_CASE("a device is tested without a folder, at each start") {
    unsetenv("POCL_CACHE_DIR");
    CHECK(own_bits(1, "", 2).empty());
    CHECK(own_bits(1, "", 2).empty());
}

TEST_CASE("a device with other bits has a name for them, a wrong one is refused") {
    base::take_warnings();
    CHECK(own_bits(1.000001f, "", 2).size() == 16);
    CHECK(base::take_warnings().size() == 1);
    CHECK_THROWS_AS(own_bits(1.1f, "", 2), base::Error);
}

TEST_CASE("what a folder remembers is not tested again") {
    TempFolder folder;
    const std::string here = folder.name(""), bits = own_bits(1.000001f, here, 2);
    folder.name("luxpipe_" + bits);
    CHECK(own_bits(1, here, 0) == bits);
    base::take_warnings();
}
