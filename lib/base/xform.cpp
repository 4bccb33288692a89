// SPDX-License-Identifier: BSD-3-Clause
// Transform options to matrices.
#include "base/angle.h"
#include "base/xform.h"
#include <cmath>
#include "base/error.h"
#include "base/number.h"

namespace base {

Vec3 point(const Xform& x, Vec3 p) { return vector(x, p) + Vec3{x.m[3][0], x.m[3][1], x.m[3][2]}; }

Vec3 vector(const Xform& x, Vec3 v) {
    Vec3 r;
    for (int j = 0; j < 3; j++) r[j] = v.x * x.m[0][j] + v.y * x.m[1][j] + v.z * x.m[2][j];
    return r;
}

Xform multiply(const Xform& a, const Xform& b) {
    Xform r;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++) {
            r.m[i][j] = i == 3 ? b.m[3][j] : 0;
            for (int k = 0; k < 3; k++) r.m[i][j] += a.m[i][k] * b.m[k][j];
        }
    r.scale = a.scale * b.scale;
    return r;
}

// The 3x3 part is a rotation times a scale, so its inverse is its transpose over scale^2.
Xform inverse(const Xform& x) {
    Xform r;
    const double s2 = 1 / (x.scale * x.scale);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) r.m[i][j] = x.m[j][i] * s2;
    const Vec3 t = vector(r, {x.m[3][0], x.m[3][1], x.m[3][2]});
    for (int j = 0; j < 3; j++) r.m[3][j] = -t[j];
    r.scale = 1 / x.scale;
    return r;
}

bool is_xform_option(const std::string& w) {
    return w == "-t" || w == "-s" || w == "-i" ||
           (w.size() == 3 && w[0] == '-' && (w[1] == 'r' || w[1] == 'm') && w[2] >= 'x' && w[2] <= 'z');
}

static Xform rotation(int axis, double degrees) {
    const double a = degrees * degree, c = std::cos(a), s = std::sin(a);
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Xform r;
    r.m[i][i] = r.m[j][j] = c;
    r.m[i][j] = s;
    r.m[j][i] = -s;
    return r;
}

// x^n by squaring: "-i 1000000000" must not take a second.
static Xform power(Xform x, long long n) {
    Xform r;
    for (; n > 0; n >>= 1) {
        if (n & 1) r = multiply(r, x);
        if (n > 1) x = multiply(x, x);
    }
    return r;
}

int parse_xform(const Span<std::string>& words, size_t at, Xform& result, const std::string& place) {
    Xform done, current;  // options before the last -i; options since
    long long repeat = 1;
    size_t i = at;
    auto number = [&](const std::string& option) {
        double v;
        if (++i >= words.size()) fail(place, "transform option " + option + " lacks a number");
        if (!parse_real(words[i], v))
            fail(place, "transform option " + option + ": \"" + words[i] + "\" is not a number");
        return v;
    };
    for (; i < words.size() && is_xform_option(words[i]); i++) {
        const std::string w = words[i];
        Xform step;
        if (w == "-t") {
            for (int j = 0; j < 3; j++) step.m[3][j] = number(w);
        } else if (w == "-s") {
            step.scale = number(w);
            if (step.scale == 0) fail(place, "transform option -s: a scale of 0");
            for (int j = 0; j < 3; j++) step.m[j][j] = step.scale;
        } else if (w == "-i") {
            done = multiply(done, power(current, repeat));
            current = Xform();
            if (++i >= words.size() || !parse_integer(words[i], repeat))
                fail(place, "transform option -i needs an integer");
        } else if (w[1] == 'r') {
            step = rotation(w[2] - 'x', number(w));
        } else {
            step.m[w[2] - 'x'][w[2] - 'x'] = -1;
            step.scale = -1;
        }
        current = multiply(current, step);
    }
    result = multiply(done, power(current, repeat));
    for (const auto& row : result.m)
        for (double v : row)
            if (!std::isfinite(v)) fail(place, "the transform is not finite");
    return int(i - at);
}

}  // namespace base
