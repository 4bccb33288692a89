// SPDX-License-Identifier: BSD-3-Clause
// The double evaluator of the generators: RADIANCE's values to the digits printed, user functions, errors as zeros.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include "cal/eval.h"
#include "unit/cal_golden.h"

TEST_CASE("rcalc's values to 9 digits") {
    cal::Evaluator evaluator({});
    int rows = 0;
    for (const Row& r : golden_rows()) {
        if (r.id.compare(0, 4, "cal_") != 0) continue;
        CHECK_MESSAGE(evaluator.value(r.text, "test") == doctest::Approx(r.value).epsilon(5e-9), r.text);
        rows++;
    }
    CHECK(rows == 22);
}

TEST_CASE("functions of numbers, as gensurf and genworm define them") {
    cal::Evaluator evaluator({});
    evaluator.define("w = 3; bump(s,t) = w*sin(PI*s)*sin(PI*t); valid(s,t) = s-t;", "-e");
    CHECK(evaluator.call("bump", {0.5, 0.25}, "test") == doctest::Approx(3 * std::sqrt(0.5)));
    CHECK(evaluator.has_function("valid"));
    CHECK_FALSE(evaluator.has_function("w"));
    CHECK_FALSE(evaluator.has_function("other"));
    evaluator.define("x(t) = hermite(0,1,0,0,t)", "-e");
    CHECK(evaluator.call("x", {0.5}, "test") == doctest::Approx(0.5));
    evaluator.define("sum(n) = if(n, n+sum(n-1), 0);", "-e");
    CHECK(evaluator.call("sum", {500}, "test") == 125250);
    CHECK(evaluator.value("j0(1)", "test") == doctest::Approx(0.765197686557967));
}

TEST_CASE("domain errors give 0 and are counted; unknown names are errors") {
    cal::Evaluator evaluator({});
    CHECK(evaluator.value("1+sqrt(-1)", "test") == 1);
    evaluator.define("f(x) = 1/x", "-e");
    CHECK(evaluator.call("f", {0}, "test") == 0);
    CHECK(evaluator.errors() == 2);
    CHECK_THROWS_AS(evaluator.value("nix", "test"), base::Error);
    CHECK_THROWS_AS(evaluator.value("Px+1", "test"), base::Error);
    CHECK_THROWS_AS(evaluator.call("f", {}, "test"), base::Error);
    evaluator.define("g(x) = g(x+1); h(n) = if(n, h(n-1)+h(n-1), 1)", "-e");
    CHECK_THROWS_AS(evaluator.call("g", {0}, "test"), base::Error);
    CHECK_THROWS_AS(evaluator.call("h", {60}, "test"), base::Error);
}
