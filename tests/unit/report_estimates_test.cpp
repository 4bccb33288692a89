// SPDX-License-Identifier: BSD-3-Clause
// Estimates of columns, of streams whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "base/error.h"
#include "image/exr.h"
#include "report/sum.h"
#include "report/until.h"
#include "report_study.h"
#include "temp_folder.h"
#include "uncertainty/stopping.h"

using namespace glare;
using namespace report;
using uncertainty::Estimate;

namespace {

constexpr int side = 12;

// A stream of sums: every pixel of frame k > 0 is its mean times a sample of mean 1, and frame 0 a share of the mean
// times the mean of 8 samples, of which frames up to 8 show one half or the other and which frames above 8 correct
// (paper section 7).  What is bright is seen exactly.
class Stream {
public:
    using Sample = std::function<double(std::mt19937&)>;
    Stream(std::vector<double> mean, Sample sample, uint32_t seed, double exact_above = 5000, double direct = .1)
        : mean_(std::move(mean)),
          sample_(std::move(sample)),
          exact_above_(exact_above),
          direct_(direct),
          random_(seed),
          frame0_(mean_.size()),
          half_off_(mean_.size()),
          sum_(mean_.size()) {
        for (size_t i = 0; i < mean_.size(); ++i)
            for (int k = 0; k < image::direct_samples; ++k) {
                const double own = exact(i) ? mean_[i] / image::direct_samples
                                            : direct_ * mean_[i] * sample_(random_) / image::direct_samples;
                frame0_[i] += own, half_off_[i] += 2 * k < image::direct_samples ? own : -own;
            }
    }
    std::vector<double> frame0() const { return frame0_; }
    std::vector<double> next() {
        ++n_;
        std::vector<double> out;
        for (size_t i = 0; i < mean_.size(); ++i) {
            if (!exact(i) && direct_ < 1) sum_[i] += (1 - direct_) * mean_[i] * sample_(random_);
            if (n_ <= image::direct_samples) sum_[i] += image::in_first_half(n_) ? half_off_[i] : -half_off_[i];
            else if (!exact(i)) sum_[i] += direct_ * mean_[i] * sample_(random_) - frame0_[i];
            out.push_back(frame0_[i] + sum_[i] / double(n_));
        }
        return last_ = out;
    }
    std::vector<double> last() const { return last_; }
    int64_t frames() const { return n_; }

private:
    bool exact(size_t i) const { return mean_[i] > exact_above_; }
    std::vector<double> mean_;
    Sample sample_;
    double exact_above_, direct_;
    std::mt19937 random_;
    std::vector<double> frame0_, half_off_, sum_, last_;
    int64_t n_ = 0;
};

double gaussian(std::mt19937& random) { return std::normal_distribution<double>(1, 1)(random); }
double quiet(std::mt19937&) { return 1; }

// Mean 1, standard deviation 4, skewness 76: a few samples make most of a sum.
double heavy(std::mt19937& random) {
    const double variance = std::log(17.);
    return std::lognormal_distribution<double>(-variance / 2, std::sqrt(variance))(random);
}

// Mean 1, deviation 3.2, skewness 4.7: one sample in five is not 0, as of a small region that few paths light.
double skew(std::mt19937& random) {
    return std::uniform_real_distribution<double>(0, 1)(random) < 0.2
               ? std::exponential_distribution<double>(0.2)(random)
               : 0;
}

// A room: a window of 8000 cd/m2, walls that fall off to the right, and two regions of a screen.
std::vector<double> room() {
    std::vector<double> mean;
    for (int r = 0; r < side; ++r)
        for (int x = 0; x < side; ++x) {
            const bool window = r >= 3 && r < 6 && x >= 3 && x < 6;
            mean.push_back(window ? 8000 : r >= 7 && x >= 8 ? (x >= 10 ? 200 : 40) : 800 - 15 * x);
        }
    return mean;
}

image::MaskSet screen() {
    image::MaskSet set;
    set.width = set.height = side;
    set.masks = {{"low", std::vector<float>(side * side, 0)}, {"high", std::vector<float>(side * side, 0)}};
    for (int r = 7; r < 10; ++r) {
        for (int x = 8; x < 10; ++x) set.masks[0].coverage[size_t(r * side + x)] = 1;
        for (int x = 10; x < 12; ++x) set.masks[1].coverage[size_t(r * side + x)] = 1;
    }
    return set;
}

struct Room {
    Settings settings;
    Requirements requirements;
    std::vector<Column> columns;
    SharedPlan plan;
    std::vector<double> truth;
    explicit Room(const std::vector<std::string>& names, DgpForm form = DgpForm::merged,
                  std::vector<double> exact_cdm2 = ::room(), const Settings& others = {}) {
        settings = others;
        settings.dgp_form = form;
        const int width = int(std::sqrt(double(exact_cdm2.size())));
        const bool regions = width == side;
        ColumnChoice choice;
        choice.names = names;
        if (regions) choice.regions = {"low", "high"}, choice.pairs = {{"low", "high", "screen"}};
        columns = choose_columns(choice, settings, requirements);
        plan = make_plan({settings, requirements, regions ? std::optional(screen()) : std::nullopt});
        image::Picture exact = fisheye_of(exact_cdm2, width);
        const Measurement m = measure(read(plan, exact, "room"));
        for (const Column& c : columns) truth.push_back(c.value(m));
    }
    // Looks at a stream until done(sum) or so many frames.
    Sum watch(
        Stream& stream, int64_t most, const std::function<bool(const Sum&)>& done = [](auto&) { return false; }) {
        const int width = int(std::sqrt(double(stream.frame0().size())));
        // Pixels without structure: columns NAMEf exist, and follow noise as others do.
        const auto even =
            std::make_shared<const std::vector<float>>(image::moment_numbers * size_t(width) * size_t(width), 0.f);
        Reading reading;
        Sum sum;
        while (stream.frames() < most) {
            image::Picture p = fisheye_of(stream.next(), width);
            as_sum(p, stream.frames());
            p.moments = even;
            reading = read(plan, p, "sum", {}, std::move(reading));
            sum = add(std::move(sum), p, reading, "sum", true);
            sum = look(std::move(sum), reading, measure(reading), columns, 0);
            if (sum.looked && done(sum)) break;
        }
        return sum;
    }
};

bool holds(const Estimate& e, double truth) {
    const uncertainty::Interval off = e.around(uncertainty::alpha, e.frames);
    return e.value + off.low <= truth && truth <= e.value + off.high;
}

// With a band, zones, and the picture of the room as a mask.
Settings settings_of_all_columns(TempFolder& temp) {
    Settings out;
    out.band_rad = .5;
    out.zones = Zones{{5, 5, 1.5}, 3.};
    out.mask_file = temp.name("mask.exr");
    image::write_exr(*out.mask_file, fisheye_of(room(), side));
    return out;
}

// All names that -metrics takes, NAMEu and NAMEf too.  NAME.px has the error of moments (glare_filled_test).
std::vector<std::string> all_names(const Settings& settings) {
    std::vector<std::string> out;
    ColumnChoice choice;
    choice.regions = {"low", "high"}, choice.pairs = {{"low", "high", "screen"}};
    std::istringstream in(column_names());
    for (std::string name; in >> name;)
        for (const char* ending : {"", "u", "f"}) {
            Requirements unused;
            choice.names = {name + ending};
            try {
                choose_columns(choice, settings, unused);
                out.push_back(name + ending);
            } catch (const base::Error&) {  // the words "(of regions)", and endings that a name does not have
            }
        }
    return out;
}

}  // namespace

// Each bright pixel by itself is a source here, so that the squares of noisy pixels are too large by their variance.
TEST_CASE("DGP without the bias of squares") {
    Room room({"DGP"}, DgpForm::pixel);
    const int seeds = 600, frames = 16;
    double unbiased = 0, squares = 0, taken_off = 0, squares_off = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Stream stream(::room(), gaussian, uint32_t(seed), 1e9);
        const Look seen = room.watch(stream, frames).look;
        image::Picture p = fisheye_of(stream.last(), side);
        const double value = seen.estimate(0).value, off = measure(read(room.plan, p, "sum")).dgp - value;
        unbiased += value / seeds, squares += value * value / seeds;
        taken_off += off / seeds, squares_off += off * off / seeds;
    }
    const double error = std::sqrt((squares - unbiased * unbiased) / seeds);
    CHECK(std::fabs(unbiased - room.truth[0]) < 3 * error);
    CHECK(taken_off > 5 * std::sqrt((squares_off - taken_off * taken_off) / seeds));
}

// With -G and -I, which measure other pixels than the picture has.
TEST_CASE("each stage gives the same numbers when it is called twice, and changes nothing") {
    Settings settings;
    settings.field_cut = 3, settings.fill = Fill{9, 1};
    Room room({"DGP", "DGPu", "Ev", "UGR", "low.mean", "screen.CR", "RAMMG", "Lmed"}, DgpForm::merged, ::room(),
              settings);
    Stream stream(::room(), gaussian, 3);
    Reading reading;
    Sum sum;
    while (stream.frames() < 8) {
        image::Picture p = fisheye_of(stream.next(), side);
        as_sum(p, stream.frames());
        reading = read(room.plan, p, "sum", {}, std::move(reading));
        const std::vector<float> pixels(reading.lum.grey, reading.lum.grey + reading.lum.size());
        const Measurement m = measure(reading), again = measure(reading);
        const Sum once = add(sum, p, reading, "sum", true), twice = add(sum, p, reading, "sum", true);
        const Sum looked = look(once, reading, m, room.columns, 0),
                  other = look(twice, reading, again, room.columns, 0);
        for (size_t c = 0; c < room.columns.size(); ++c) {
            CHECK(room.columns[c].value(m) == room.columns[c].value(again));
            const Estimate &a = looked.look.estimate(c), &b = other.look.estimate(c);
            CHECK((a.value == b.value || (std::isnan(a.value) && std::isnan(b.value))));
            CHECK((a.error == b.error || (std::isnan(a.error) && std::isnan(b.error))));
        }
        CHECK(std::equal(pixels.begin(), pixels.end(), reading.lum.grey));
        sum = looked;
    }
    CHECK(sum.look.replicates.count() == 8);
}

// A row of the table that says nothing of noise has no interval, and fails here until it is listed; one that claims an
// interval fails unless the interval follows noise.
TEST_CASE("each column has an interval that moves when noise moves, or is listed as having none") {
    const std::vector<std::string> without{
        "class",     "RAMMG",         "RAMMGu",     "classf",    "VCP",        "VCPu",      "VCPf",
        "PGSV",      "DGR",           "DGRu",       "PGSVcon",   "PGSVsat",    "Lmax",      "threshold",
        "Lmed",      "LmedPos",       "LmedPos2",   "n_sources", "n_sourcesf", "L_sources", "pixels",
        "omega",     "omega_sources", "not_finite", "negative",  "low.median", "low.min",   "low.max",
        "low.share", "high.median",   "high.min",   "high.max",  "high.share"};
    const std::vector<std::string> of_sets{"omega", "median", "std", "p75", "p95", "min", "max"};
    const auto listed = [&](const std::string& name) {
        const size_t dot = name.find('.');
        const bool of_set = name.find("band.") == 0 || name.find("mask.") == 0 || name.find("zone") == 0;
        const auto& list = of_set ? of_sets : without;
        return std::find(list.begin(), list.end(), of_set ? name.substr(dot + 1) : name) != list.end();
    };
    TempFolder temp;
    const Settings settings = settings_of_all_columns(temp);
    Room room(all_names(settings), DgpForm::merged, ::room(), settings);
    REQUIRE(room.columns.size() > 100);
    const auto noisy = [](double times) {
        return [times](std::mt19937& random) { return 1 + times * (gaussian(random) - 1); };
    };
    std::vector<double> width[2];
    for (const int k : {0, 1}) {
        Stream stream(::room(), noisy(k ? .08 : .02), 7, 1e9);
        const Look seen = room.watch(stream, 23).look;
        for (size_t c = 0; c < room.columns.size(); ++c)
            width[k].push_back(seen.estimate(c).half_width(uncertainty::alpha, 23));
    }
    for (size_t c = 0; c < room.columns.size(); ++c) {
        INFO(room.columns[c].name << ": " << width[0][c] << ", with more noise " << width[1][c]);
        const bool none = listed(room.columns[c].name);
        CHECK(room.columns[c].has_interval() == !none);
        if (none) CHECK(std::isnan(width[0][c]));
        else CHECK(width[1][c] > 1.5 * width[0][c]);
    }
}

TEST_CASE("without noise the de-biased metrics are the plain ones, and intervals have no width") {
    Room room({"DGP", "Ev", "low.TAL", "screen.CR"});
    Stream stream(::room(), quiet, 1);
    const Look seen = room.watch(stream, 40).look;
    for (size_t c = 0; c < room.columns.size(); ++c) {
        CHECK(seen.estimate(c).value == doctest::Approx(room.truth[c]).epsilon(1e-5));
        CHECK(seen.estimate(c).half_width(0.05, 40) < 1e-5 * room.truth[c]);
        CHECK(UntilRule(room.columns[c].name + " 0.01%").holds({seen.estimate(c)}, {}));
    }
}

// Each of 600 seeds is watched until the rule holds; the standard deviation of 95 % of these is .9 %.
TEST_CASE("intervals cover the truth when the rule stops, also with heavy tails") {
    struct Case {
        const char* rule;
        double (*sample)(std::mt19937&);
    };
    for (const Case& c : {Case{"Ev 0.6%", gaussian}, Case{"Ev 2.5%", heavy}, Case{"DGP 0.003", gaussian},
                          Case{"low.TAL 25%", skew}, Case{"screen.CR 35%", skew}}) {
        const std::string rule = c.rule;
        const std::string metric = rule.substr(0, rule.find(' '));
        Room room({metric});
        int stopped = 0, covered = 0;
        const int seeds = 600;
        for (int seed = 1; seed <= seeds; ++seed) {
            UntilRule until(rule);
            Stream stream(::room(), c.sample, uint32_t(1000 + seed));
            bool held = false;
            const Sum sum = room.watch(stream, 400, [&](const Sum& at) {
                const Estimate& e = at.look.estimate(0);
                return held = stream.frames() >= uncertainty::least_frames && until.holds({e}, e);
            });
            if (!held) continue;
            ++stopped;
            covered += holds(sum.look.estimate(0), room.truth[0]);
        }
        INFO(rule << ": " << covered << " of " << stopped);
        MESSAGE(rule << ": " << covered << " of " << stopped);
        CHECK(stopped > seeds / 2);
        CHECK(covered > 0.92 * stopped);
    }
}

// A sun on polished floor: the noise of few pixels, of which all comes from direct samples.
TEST_CASE("intervals know frame 0's own error") {
    constexpr int width = 32, seeds = 300;
    std::vector<double> mean(width * width, 300);
    for (int row = 22; row < 26; ++row)
        for (int x = 12; x < 18; ++x) mean[size_t(row * width + x)] = 4000;
    const auto rare = [](std::mt19937& random) {  // of mean 1
        return std::uniform_real_distribution<double>(0, 1)(random) < .25 ? 4. : 0.;
    };
    Room room({"Ev"}, DgpForm::merged, mean);
    for (const int frames : {8, 11, 16}) {
        int covered = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            Stream stream(mean, rare, uint32_t(seed), 1e9, 1);
            const Look seen = room.watch(stream, frames).look;
            covered += holds(seen.estimate(0), room.truth[0]);
        }
        INFO(frames << " frames: " << covered << " of " << seeds);
        MESSAGE(frames << " frames: " << covered << " of " << seeds);
        CHECK(covered > (.95 - 3 * .0126) * seeds);
    }
}

// Noise that is all of the contrast goes with the square root of the variance, so that a third of it is left: no
// interval is claimed.
TEST_CASE("most of RAMMG's bias is taken off, and it has no interval") {
    constexpr int wall_side = 24;
    const std::vector<double> wall(size_t(wall_side * wall_side), 1000);
    Study study{"RAMMG", {6, 8, 16, 33}, 100};
    study.run<Even>(wall, [&](uint32_t seed) { return Even(wall, {0, wall_side, 0, wall_side, 400}, seed); });
    for (size_t k = 0; k < study.looks.size(); ++k) {
        INFO(study.told(k));
        CHECK(study.known[k] == 0);
        CHECK(study.unbiased[k] < .4 * study.plain[k]);
    }
}

TEST_CASE("rules of widths and of the class") {
    CHECK_THROWS_AS(UntilRule(""), base::Error);
    CHECK_THROWS_AS(UntilRule("DGP"), base::Error);
    UntilRule rule("DGP 0.01, class");
    CHECK(rule.tolerances().size() == 1);
    CHECK(rule.class_of() == "DGP");
    CHECK(UntilRule("classf").class_of() == "DGPf");

    Estimate e{0.30, 0.003, 8, 0, false, 64};
    CHECK(rule.holds({e}, e));
    e.unreliable = true;
    CHECK(!rule.holds({e}, e));
    e = {0.349, 0.003, 8, 0, false, 64};  // crosses 0.35
    CHECK(!rule.holds({e}, e));
    e = {0.341, 0.003, 8, 0, false, 64};  // does so at the level of a look, though not at 95 %
    CHECK(!rule.holds({e}, e));
    CHECK(dgp_class(0.34) == 0);
    CHECK(dgp_class(0.35) == 1);
    CHECK(dgp_class(0.40) == 2);
    CHECK(dgp_class(0.45) == 2);
    CHECK(dgp_class(0.46) == 3);
}

TEST_CASE("the wider of two tolerances counts") {
    const UntilRule rule("Ev 1% or 0.1");
    const auto holds = [&](double value, double error) {
        return rule.holds({Estimate{value, error, 1e6, 0, false, 64}}, {});
    };
    CHECK(holds(1000, 4));  // 1.96 of these
    CHECK(!holds(1000, 6));
    CHECK(holds(.02, .04));
    CHECK(!holds(.02, .06));
    CHECK(holds(0, 0));
    CHECK(rule.tolerances()[0].text() == "1% or 0.1");
    for (const char* wrong : {"Ev 1% or", "Ev or 1%", "Ev 1% or 2%", "Ev 1 or 2", "Ev 1% or 2 or 3", "Ev 1% 2"})
        CHECK_THROWS_AS(UntilRule{wrong}, base::Error);
}

// Of DGPf the variance inside of pixels is known from frame 0 alone.
TEST_CASE("a rule below what pixels allow says so") {
    const UntilRule rule("DGPf 0.0003");
    const auto why = [&](const UntilRule& of, double lasting, int64_t frames) {
        const Estimate e{.354, 1.1 * lasting, 8, 0, false, frames, lasting};
        return of.out_of_reach({e}, e, {}, 64, 64);
    };
    CHECK(why(rule, .0005, 16) ==
          "at 64 x 64 pixels DGPf is known to +- 0.0012 however many frames there are, more than the 0.0003 of the "
          "rule; larger pictures have less");
    CHECK(why(rule, .00015, 16).empty());  // 1.15 times the tolerance, which may be an accident of few frames
    CHECK(!why(rule, .00015, 1024).empty());
    CHECK(why(rule, .0001, 1024).empty());
    CHECK(why(UntilRule("classf"), .002, 1024).find("DGPf is 0.354 +- 0.0046 however many frames") !=
          std::string::npos);
    CHECK(why(UntilRule("classf"), .0005, 1024).empty());
}

// The rule is of evalglare's DGP: what pixels do to it counts.
TEST_CASE("noise and pixels together must be inside of a tolerance, and of a class") {
    const UntilRule rule("DGP 0.01");
    const Estimate dgp{.34, .0005, 8, 0, false, 64};
    const auto pixels = [](double error) { return PixelErrors{{Estimate{error, .0005, 8, 0, false, 64}}, {}}; };
    CHECK(rule.holds({dgp}, dgp, pixels(.008)));
    CHECK(!rule.holds({dgp}, dgp, pixels(.0095)));
    CHECK(!rule.holds({dgp}, dgp, pixels(-.012)));
    CHECK(rule.reason({dgp}, dgp, pixels(.008)).find("of noise; at this size evalglare's definition reads 0.008 low") !=
          std::string::npos);
    CHECK(rule.out_of_reach({dgp}, dgp, pixels(.0105), 128, 128).empty());  // its interval reaches in
    CHECK(rule.out_of_reach({dgp}, dgp, {}, 128, 128).empty());
    const std::string why = rule.out_of_reach({dgp}, dgp, pixels(.0175), 128, 128);
    CHECK(why.find("at 128 x 128 pixels DGP reads 0.018 low, more than the 0.01 of the rule") == 0);
    CHECK(why.find("about 256 x 256 may do, and DGPf does not") != std::string::npos);

    const UntilRule rule_of_class("class");
    PixelErrors of_class{{}, Estimate{.005, .0005, 8, 0, false, 64}};
    CHECK(rule_of_class.holds({}, dgp, of_class));
    of_class.of_class->value = .015;
    CHECK(!rule_of_class.holds({}, dgp, of_class));
    CHECK(
        rule_of_class.out_of_reach({}, dgp, of_class, 128, 128).find("imperceptible by it, and perceptible by DGPf") !=
        std::string::npos);
    of_class.of_class->value = .0101;  // on the border: it may still be either
    CHECK(rule_of_class.out_of_reach({}, dgp, of_class, 128, 128).empty());
}
