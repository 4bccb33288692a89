// SPDX-License-Identifier: BSD-3-Clause
// Factors of hours are kept in half precision: what is lost.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "render/hour_factors.h"

namespace {

// Paths that see suns as told, a list each.
class Told : public device::Device {
public:
    explicit Told(std::vector<float> responses) : responses_(std::move(responses)) {}
    std::string name() const override { return "told"; }
    void upload(std::shared_ptr<const flatten::FlatScene>) override {}
    void run(const device::Params&, std::vector<float>&) override {}
    void splat(const device::Params&, const std::vector<device::SplatRay>&, std::vector<float>&) override {}
    void pilot(const device::Params&, const std::vector<device::PilotRay>&, std::vector<device::PilotEnd>&) override {}
    uint32_t preferred_batch_size() const override { return 1; }
    void run_hours(const device::Params&, device::HourPaths& out) override {
        out = {};
        device::FoundSuns found;
        for (size_t i = 0; i < responses_.size(); i++) {
            const float rgb[3] = {responses_[i], responses_[i] / 2, 0};
            found.add(uint32_t(i), 7, rgb, 1);
        }
        found.sort(uint32_t(responses_.size()), out);
    }

private:
    std::vector<float> responses_;
};

constexpr double solid_angle = 6.8e-5;

// Of each list the sum of its factors, red and green.
std::vector<std::array<double, 2>> kept(const std::vector<double>& responses_per_sr) {
    std::vector<float> responses;
    for (const double r : responses_per_sr) responses.push_back(float(r * solid_angle));
    Told told(responses);
    kernels::ViewTables tables;
    tables.suns.resize(8);
    for (kernels::Source& sun : tables.suns) sun.area = float(solid_angle);
    device::Params par = device::with_view({}, std::move(tables));
    par.suns_count = 8;
    const render::PathFactors factors = render::draw_factors(told, par, 1, {0, 1, 2, 3, 4, 5, 6, 7});
    std::vector<std::array<double, 2>> sums(responses.size());
    for (size_t list = 0; list < sums.size(); list++)
        for (uint64_t i = factors.suns_at[list]; i < factors.suns_at[list + 1]; i++) {
            float rgb[3];
            render::unpack(factors.suns[i], rgb);
            CHECK(factors.suns[i].of == 7);
            sums[list][0] += double(rgb[0]), sums[list][1] += double(rgb[1]);
        }
    return sums;
}

}  // namespace

TEST_CASE("a response keeps its value to .05 %, also that of a highlight whose ray counts for many") {
    const std::vector<double> responses = {.001, .3, 1, 900, 65000, 65520, 7e4, 4e5, 3e6};
    const auto sums = kept(responses);
    for (size_t i = 0; i < responses.size(); i++) {
        CAPTURE(responses[i]);
        CHECK(sums[i][0] == doctest::Approx(responses[i]).epsilon(.0006));
        CHECK(sums[i][1] == doctest::Approx(responses[i] / 2).epsilon(.0006));
    }
}

TEST_CASE("a response that is no number is none") {
    const auto sums = kept({1, double(NAN), double(INFINITY), 2});
    CHECK(sums[0][0] == doctest::Approx(1).epsilon(.0006));
    CHECK(sums[1][0] == 0);
    CHECK(sums[2][0] == 0);
    CHECK(sums[3][0] == doctest::Approx(2).epsilon(.0006));
}
