// SPDX-License-Identifier: BSD-3-Clause
// gensurf material name x(s,t) y(s,t) z(s,t) m n [-s] [-i]: a grid of m x n cells over s, t = 0..1, each one
// quadrilateral if it is flat, else two triangles.  A coordinate may be a file of (m+1)(n+1) values at the grid's
// points or m n values at the middles of its cells, s fastest.  Where valid(s,t) is defined, only points with valid > 0
// exist.  -i: inside out. -s smooths: the texture surf.cal adds (normal of the surface - normal of the polygon),
// bilinear in two coordinates (u, v) from the four corners of the cell.
#include <algorithm>
#include <array>
#include <cmath>
#include "base/error.h"
#include "base/file_status.h"
#include "base/find_file.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/text_reader.h"
#include "generators/functions.h"

namespace generators {

namespace {

using base::Vec3;

// A coordinate as data.
struct Data {
    std::vector<double> v;
    int nx = 0, ny = 0;
    bool cells = false;  // values at the middles of the cells

    double at(int i, int j) const {  // of grid point i, j
        if (!cells) return v[size_t(j) * nx + i];
        auto place = [](int k, int n, int& low) {  // between the cells k-1 and k; extrapolated at the rim
            low = n < 2 ? 0 : k - 1 < 0 ? 0 : k - 1 > n - 2 ? n - 2 : k - 1;
            return n < 2 ? 0. : k - .5 - low;
        };
        int i0, j0;
        const double x = place(i, nx, i0), y = place(j, ny, j0);
        const int i1 = nx < 2 ? i0 : i0 + 1, j1 = ny < 2 ? j0 : j0 + 1;
        auto row = [&](int jj) { return v[size_t(jj) * nx + i0] * (1 - x) + v[size_t(jj) * nx + i1] * x; };
        return row(j0) * (1 - y) + row(j1) * y;
    }
};

struct Point {
    Vec3 p, normal;  // normal: unit, 0 if there is none
    bool valid = false;
};

const char* const names[] = {"surf_x", "surf_y", "surf_z"};

Vec3 area_vector(const std::vector<Vec3>& v) {
    Vec3 n;
    for (size_t i = 1; i + 1 < v.size(); i++) n = n + cross(v[i] - v[0], v[i + 1] - v[0]);
    return n;
}

class Surface {
public:
    Surface(const Call& call, std::string& out) : call_(call), out_(out), f_(call) {}
    void run() {
        material_ = call_.word(1, "the material");
        name_ = call_.word(2, "the name");
        m_ = int(call_.integer(6, "m", 1, call_.most));
        n_ = int(call_.integer(7, "n", 1, call_.most));
        if (double(m_) * n_ > double(call_.most)) call_.fail("more than " + std::to_string(call_.most) + " cells");
        for (size_t i = 8; call_.has(i); i++) {
            const std::string& w = call_.words[i];
            if (w == "-s") smooth_ = true;
            else if (w == "-i") inside_out_ = true;
            else if (w == "-o") call_.fail("-o writes a Wavefront file, which a scene cannot contain");
            else if (!f_.option(i)) call_.fail("unknown option " + w);
        }
        for (int k = 0; k < 3; k++) read_coordinate(k, call_.word(3 + k, "x(s,t) y(s,t) z(s,t)"));
        grid_.resize(size_t(m_ + 3) * (n_ + 3));
        const int rim = smooth_ ? 1 : 0;
        for (int i = -rim; i <= m_ + rim; i++)
            for (int j = -rim; j <= n_ + rim; j++) point(i, j) = evaluate(i, j);
        if (smooth_)
            for (int i = 0; i <= m_; i++)
                for (int j = 0; j <= n_; j++) find_normal(i, j);
        for (int i = 0; i < m_; i++)
            for (int j = 0; j < n_; j++)
                cell({&point(i, j), &point(i + 1, j), &point(i, j + 1), &point(i + 1, j + 1)}, j);
    }

private:
    void read_coordinate(int k, const std::string& word) {
        const std::string path = base::beside(word, call_.place);
        const bool expression = word == "s" || word == "t" || !base::status_of(path).is_ordinary();
        if (expression) return f_.define(names[k], "s,t", word);
        base::TextReader in = base::TextReader::from_file(path, call_.options.opener(call_.place));
        Data& d = data_[k];
        double value;
        const size_t points = size_t(m_ + 1) * (n_ + 1), cells = size_t(m_) * n_;
        for (std::string_view w; in.word(w);) {
            if (!base::parse_real(w, value)) call_.fail(in.place() + ": \"" + base::excerpt(w) + "\" is not a number");
            d.v.push_back(value);
            if (d.v.size() > points) break;
        }
        d.cells = d.v.size() == cells;
        if (!d.cells && d.v.size() != points)
            call_.fail("\"" + word + "\" must hold " + std::to_string(points) + " or " + std::to_string(cells) +
                       " values");
        d.nx = m_ + !d.cells;
        d.ny = n_ + !d.cells;
    }
    Point evaluate(int i, int j) {
        Point q;
        const std::vector<double> st{double(i) / m_, double(j) / n_};
        const bool outside = i < 0 || j < 0 || i > m_ || j > n_;
        q.valid = !f_.has("valid") || f_("valid", st) > 0;
        for (int k = 0; k < 3; k++) {
            if (data_[k].nx && outside) q.valid = false;
            else q.p[k] = data_[k].nx ? data_[k].at(i, j) : f_(names[k], st);
        }
        return q;
    }
    // From the neighbours on both sides, or on one where the other does not exist.
    void find_normal(int i, int j) {
        Point& here = point(i, j);
        if (!here.valid) return;
        auto slope = [&](const Point& before, const Point& after) {
            return (after.valid ? after.p : here.p) - (before.valid ? before.p : here.p);
        };
        const Vec3 n = cross(slope(point(i - 1, j), point(i + 1, j)), slope(point(i, j - 1), point(i, j + 1)));
        here.normal = unit(n) * (inside_out_ ? -1 : 1);
    }
    Point& point(int i, int j) { return grid_[size_t(i + 1) * (n_ + 3) + (j + 1)]; }
    // Corners in the order s: 0 1 0 1, t: 0 0 1 1.
    void cell(const std::array<const Point*, 4>& c, int j) {
        const Vec3 &p00 = c[0]->p, &p10 = c[1]->p, &p01 = c[2]->p, &p11 = c[3]->p;
        const int valid = c[0]->valid + c[1]->valid + c[2]->valid + c[3]->valid;
        if (valid < 3) return;
        if (!c[0]->valid) return face(c, {p01, p10, p11});
        if (!c[1]->valid) return face(c, {p00, p11, p01});
        if (!c[2]->valid) return face(c, {p10, p11, p00});
        if (!c[3]->valid) return face(c, {p00, p10, p01});
        const Vec3 n = cross(p11 - p10, p00 - p10);
        const double area = length(n);
        if (area > 0 && std::fabs(dot(n, p01 - p10)) < .99e-6 * area * std::sqrt(area)) {
            if (j % 2 == 0) return face(c, {p10, p11, p01, p00});
            return face(c, {p00, p10, p11, p01});
        }
        if (j % 2 == 0) {
            face(c, {p10, p11, p00});
            face(c, {p00, p11, p01});
        } else {
            face(c, {p00, p10, p01});
            face(c, {p01, p10, p11});
        }
    }
    void face(const std::array<const Point*, 4>& cell, const std::vector<Vec3>& corners) {
        std::vector<Vec3> v = corners;
        if (inside_out_) std::reverse(v.begin() + 1, v.end());
        const Vec3 n = area_vector(v);
        double longest = 0;
        for (const Vec3& p : v) longest = std::fmax(longest, dot(p - v[0], p - v[0]));
        if (length(n) <= 1e-12 * longest || longest == 0) return;
        v.erase(std::unique(v.begin(), v.end()), v.end());  // a side may be a point
        if (v.front() == v.back()) v.pop_back();
        const bool textured = smooth_ && texture(cell, unit(n));
        write_polygon(out_, textured ? "Phong" : material_, name_ + "." + std::to_string(++faces_), v);
    }
    // Coefficients c of f = c0 uv + c1 u + c2 v + c3 through the cell's corners, for each component of the
    // displacement.
    bool texture(const std::array<const Point*, 4>& cell, Vec3 normal) {
        Vec3 sum = cell[0]->normal;
        for (int k = 1; k < 4; k++) {  // RADIANCE does without the normal of the first corner
            if (length(cell[k]->normal) == 0) return false;
            sum = sum + cell[k]->normal;
        }
        int axis = 0;
        for (int k = 1; k < 3; k++)
            if (std::fabs(sum[k]) > std::fabs(sum[axis])) axis = k;
        double a[4][7];
        for (int k = 0; k < 4; k++) {
            const double u = cell[k]->p[(axis + 1) % 3], v = cell[k]->p[(axis + 2) % 3];
            const Vec3 d = cell[k]->normal - normal;
            const double row[7] = {u * v, u, v, 1, d.x, d.y, d.z};
            for (int c = 0; c < 7; c++) a[k][c] = row[c];
        }
        for (int c = 0; c < 4; c++) {  // Gauss-Jordan with row pivots
            int pivot = c;
            for (int k = c + 1; k < 4; k++)
                if (std::fabs(a[k][c]) > std::fabs(a[pivot][c])) pivot = k;
            if (std::fabs(a[pivot][c]) < 1e-10) return false;
            std::swap(a[c], a[pivot]);
            for (int k = 0; k < 4; k++) {
                if (k == c) continue;
                const double factor = a[k][c] / a[c][c];
                for (int x = c; x < 7; x++) a[k][x] -= factor * a[c][x];
            }
        }
        out_ += "\n" + quoted(material_) + " texfunc Phong\n4 surf_dx surf_dy surf_dz surf.cal\n0\n13\t" +
                std::to_string(axis) + "\n";
        for (int c = 0; c < 4; c++) {
            for (int x = 4; x < 7; x++) out_ += "\t" + number(a[c][x] / a[c][c]);
            out_ += "\n";
        }
        return true;
    }

    const Call& call_;
    std::string& out_;
    Functions f_;
    std::string material_, name_;
    int m_ = 0, n_ = 0, faces_ = 0;
    bool smooth_ = false, inside_out_ = false;
    Data data_[3];
    std::vector<Point> grid_;  // one more row on every side: slopes at the rim need it
};

}  // namespace

void gensurf(const Call& call, std::string& out) { Surface(call, out).run(); }

}  // namespace generators
