// SPDX-License-Identifier: BSD-3-Clause
// Random programs of whole numbers, where float is exact: sharing, branches, registers and jumps of the compiler must
// give what plain evaluation in double gives.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <random>
#include "cal/eval.h"
#include "unit/cal_golden.h"

namespace {

class Writer {  // of expressions over Px Py Pz, earlier variables and functions
public:
    explicit Writer(unsigned seed) : random_(seed) {}
    int below(int n) { return int(random_() % unsigned(n)); }
    std::string expression(int depth, int variables) {
        const int kind = depth <= 0 ? below(5) : below(16);
        auto sub = [&] { return expression(depth - 1, variables); };
        switch (kind) {
        case 0: return std::to_string(below(4));
        case 1: return "Px";
        case 2: return "Py";
        case 3: return "Pz";
        case 4: return variables ? "v" + std::to_string(below(variables)) : "1";
        case 5:
        case 6: return "(" + sub() + "+" + sub() + ")";
        case 7: return "(" + sub() + "-" + sub() + ")";
        case 8: return "frac7(" + sub() + "*" + sub() + ")";
        case 9: return "max(" + sub() + "," + sub() + ")";
        case 10: return "min(" + sub() + "," + sub() + ",2)";
        case 11: return "bound(-3," + sub() + ",3)";
        case 12: return "-" + std::string("(") + sub() + ")";
        case 13: return "select(bound(1," + sub() + ",3)," + sub() + "," + sub() + "," + sub() + ")";
        default: return "if(" + sub() + "," + sub() + "," + sub() + ")";
        }
    }

private:
    std::mt19937 random_;
};

}  // namespace

TEST_CASE("compiled programs agree with plain evaluation") {
    int agreed = 0;
    for (unsigned seed = 0; seed < 1500; seed++) {
        Writer writer(seed);
        // frac7: a number mod 7, so that products stay small
        std::string definitions = "frac7(x) = x - 7*floor(x/7);";
        const int variables = writer.below(7);
        for (int i = 0; i < variables; i++)
            definitions += "v" + std::to_string(i) + " = " + writer.expression(3, i) + ";";
        const std::string text = writer.expression(4, variables);
        cal::Library library({});
        library.define(definitions, "random");
        cal::Code code;
        const uint32_t entry = compile_one(library, text, code);
        for (int k = 0; k < 4; k++) {
            const int at[3] = {writer.below(9) - 4, writer.below(9) - 4, writer.below(9) - 4};
            const float p[3] = {float(at[0]), float(at[1]), float(at[2])};
            cal::Evaluator plain({});
            plain.define("Px = " + std::to_string(at[0]) + "; Py = " + std::to_string(at[1]) +
                             "; Pz = " + std::to_string(at[2]) + ";" + definitions,
                         "random");
            const double want = plain.value(text, "random");
            const float got = run_one(code, entry, golden_vars(p));
            CHECK_MESSAGE(std::fabs(double(got) - want) < 1e-3, "seed ", seed, ": ", got, " not ", want);
            agreed += std::fabs(double(got) - want) < 1e-3;
        }
    }
    CHECK(agreed == 6000);
}
