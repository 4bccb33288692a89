// SPDX-License-Identifier: BSD-3-Clause
// BSDF files to the tables of kernels/material/bsdf.h: subtracts the Lambertian part, perturbs values as RADIANCE does
// (spec: RADIANCE shading 3.16; equal cells become different), sums for sampling, integrates over the hemisphere.  One
// set of tables per file.
#include "flatten/bsdf.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "flatten/band_colours.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace kernels {
#include "kernels/sampling/sampler.h"
#include "kernels/material/bsdf.h"
}  // namespace kernels

namespace flatten {
namespace {
using namespace kernels;
using scene::BsdfBasis;
using scene::BsdfTree;

using base::pi;
constexpr uint32_t MAX_GRID = 128;  // cells per side of the grid of hemispherical values
constexpr double MIN_LAMBERTIAN = .01 / pi, MAX_LAMBERTIAN = 1.5 / pi;

double fraction(double x) { return x - std::floor(x); }

class BsdfWriter {
public:
    BsdfWriter(const scene::Bsdf& b, const BandColours* bands, BsdfRecords& out, cal::Code& code,
               const std::string& place)
        : b_(b), bands_(bands), out_(out), code_(code), place_(place) {}

    uint32_t write() {
        for (const BsdfBasis& basis : b_.bases) rings_at_.push_back(add_basis(basis));
        const uint32_t at = uint32_t(out_.components.size());
        for (size_t side = 0; side < 2; side++) {
            add_component(b_.reflection[side], false);
            const scene::BsdfTable& own = b_.transmission[side];
            if (own.present) add_component(own, false);
            else add_component(b_.transmission[1 - side], true);  // reciprocity
        }
        return at;
    }

private:
    uint32_t add_floats(const std::vector<float>& v) {
        if (code_.floats.size() + v.size() > 0x7fffffffu) base::fail(place_, "BSDF tables above 8 GB");
        const uint32_t at = uint32_t(code_.floats.size());
        code_.floats.insert(code_.floats.end(), v.begin(), v.end());
        return at;
    }

    uint32_t add_words(const std::vector<uint32_t>& v) {
        if (code_.words.size() + v.size() > 0x7fffffffu) base::fail(place_, "BSDF tables above 8 GB");
        const uint32_t at = uint32_t(code_.words.size());
        code_.words.insert(code_.words.end(), v.begin(), v.end());
        return at;
    }

    uint32_t add_basis(const BsdfBasis& basis) {
        const uint32_t at = uint32_t(out_.rings.size());
        uint32_t first = 0;
        for (size_t k = 0; k < basis.count.size(); k++) {
            const auto cosine = [&](double deg) { return deg >= 90 ? 0.0f : float(std::cos(deg * pi / 180)); };
            out_.rings.push_back({cosine(basis.theta[k]), cosine(basis.theta[k + 1]), basis.count[k], first});
            first += basis.count[k];
        }
        return at;
    }

    static std::vector<float> psa_of(const BsdfBasis& basis) {
        std::vector<float> psa;
        for (size_t k = 0; k < basis.count.size(); k++) {
            const double c0 = std::cos(basis.theta[k] * pi / 180), c1 = std::cos(basis.theta[k + 1] * pi / 180);
            psa.insert(psa.end(), basis.count[k], float(pi * (c0 * c0 - c1 * c1) / basis.count[k]));
        }
        return psa;
    }

    void add_component(const scene::BsdfTable& t, bool swap) {
        BsdfComponent component = {NONE, 0};
        if (t.present) {
            double diffuse = 0;
            const BsdfTable table = t.tree.dims ? tree_table(t, swap, diffuse) : matrix_table(t, swap, diffuse);
            component = {uint32_t(out_.tables.size()), float(diffuse)};
            out_.tables.push_back(table);
        }
        out_.components.push_back(component);
    }

    BsdfTable matrix_table(const scene::BsdfTable& t, bool swap, double& diffuse) {
        const BsdfBasis &in = b_.bases[t.incident], &out = b_.bases[t.exit];
        const size_t ni = in.cells(), no = out.cells();
        std::vector<double> noise(ni * no);
        for (size_t i = 0; i < ni; i++)
            for (size_t o = 0; o < no; o++)
                noise[i * no + o] = 1 + 6e-4 * (fraction(2.0 * double(ni) / (double(i) + .22545) +
                                                         4.0 * double(no) / (double(o) + .70281)) -
                                                .5);
        double least = 1e30;
        for (size_t k = 0; k < ni * no; k++) least = std::min(least, t.y[k] * noise[k]);
        if (least <= MIN_LAMBERTIAN) least = 0;
        diffuse = pi * least;

        // rows by v, columns by l
        const size_t nv = swap ? no : ni, nl = swap ? ni : no;
        const std::vector<float> psa_v = psa_of(swap ? out : in), psa_l = psa_of(swap ? in : out);
        std::vector<float> values(nv * nl), sums(nv * nl), hemi(nv), rgb;
        if (!t.x.empty()) rgb.resize(3 * nv * nl);
        for (size_t v = 0; v < nv; v++) {
            double sum = 0;
            for (size_t l = 0; l < nl; l++) {
                const size_t from = swap ? l * no + v : v * no + l, to = v * nl + l;
                values[to] = float(std::max(0.0, t.y[from] - least) * noise[from]);
                sum += double(values[to]) * psa_l[l];
                sums[to] = float(sum);
                if (!rgb.empty()) put_rgb(t.x[from], t.y[from], t.z[from], &rgb[3 * to]);
            }
            hemi[v] = sums[v * nl + nl - 1];
        }
        for (size_t i = 0; bands_ && i < rgb.size(); i += 3) {
            const auto c = colour_of_surface(bands_->bands, spectrum::Colour{rgb[i], rgb[i + 1], rgb[i + 2]});
            std::copy(c.begin(), c.end(), rgb.begin() + long(i));
        }

        BsdfTable table{};
        table.kind = BSDF_MATRIX;
        table.swap = swap;
        table.min_psa =
            std::min(*std::min_element(psa_v.begin(), psa_v.end()), *std::min_element(psa_l.begin(), psa_l.end()));
        table.v_rings_at = rings_at_[swap ? t.exit : t.incident];
        table.v_rings = uint32_t((swap ? out : in).count.size());
        table.l_rings_at = rings_at_[swap ? t.incident : t.exit];
        table.l_rings = uint32_t((swap ? in : out).count.size());
        table.l_cells = uint32_t(nl);
        table.values = add_floats(values);
        table.sums = add_floats(sums);
        table.hemi = add_floats(hemi);
        table.v_psa = add_floats(psa_v);
        table.l_psa = add_floats(psa_l);
        table.rgb = rgb.empty() ? NONE : add_floats(rgb);
        return table;
    }

    // XYZ -> RADIANCE's RGB for Y = 1
    static void put_rgb(float X, float Y, float Z, float* rgb) {
        const double x = Y > 0 ? X / Y : 1, z = Y > 0 ? Z / Y : 1;
        rgb[0] = float(std::max(0.0, 2.56531284 * x - 1.16684962 - .39846323 * z));
        rgb[1] = float(std::max(0.0, -1.02210817 * x + 1.97828662 + .04382156 * z));
        rgb[2] = float(std::max(0.0, .07472438 * x - .25193957 + 1.17721519 * z));
    }

    // ---- trees.  visit(leaf, lower corner, width) for each leaf; at most scene's MAX_DEPTH levels deep
    template <class F>
    static void leaves(const BsdfTree& t, uint32_t node, const double* low, double width, const F& visit) {
        if (t.child[node] == BsdfTree::LEAF) {
            visit(node, low, width);
            return;
        }
        for (uint32_t c = 0; c < 1u << t.dims; c++) {
            double corner[4] = {0, 0, 0, 0};
            for (int k = 0; k < t.dims; k++) corner[k] = low[k] + (c >> k & 1 ? width / 2 : 0);
            leaves(t, t.child[node] + c, corner, width / 2, visit);
        }
    }

    template <class F>
    static void leaves(const BsdfTree& t, const F& visit) {
        const double origin[4] = {0, 0, 0, 0};
        leaves(t, 0, origin, 1, visit);
    }

    static float set_means(const BsdfTree& t, std::vector<float>& value, uint32_t node) {
        if (t.child[node] == BsdfTree::LEAF) return value[node];
        double sum = 0;
        for (uint32_t c = 0; c < 1u << t.dims; c++) sum += double(set_means(t, value, t.child[node] + c));
        return value[node] = float(sum / (1u << t.dims));
    }

    BsdfTable tree_table(const scene::BsdfTable& file, bool swap, double& diffuse) {
        const BsdfTree& t = file.tree;
        double least = 1e30, narrow = 1;
        leaves(t, [&](uint32_t n, const double* low, double width) {
            if (t.dims == 3 && low[0] >= .5) return;
            least = std::min(least, double(t.value[n]));
            narrow = std::min(narrow, width);
        });
        if (!(least > MIN_LAMBERTIAN && least < MAX_LAMBERTIAN)) least = 0;
        diffuse = pi * least;
        std::vector<float> values = t.value;
        leaves(t, [&](uint32_t n, const double* low, double) {
            double noise = 0;
            for (int k = 0; k < t.dims; k++) noise += fraction(double(2u << k) / (low[k] + .01687)) - .5;
            values[n] = float(std::max(0.0, t.value[n] - least) * (1 + 1e-4 * noise));
        });
        set_means(t, values, 0);

        const uint32_t grid = std::min(MAX_GRID, 1u << std::max(t.dims == 3 && swap ? 7 : 1, t.depth));
        BsdfTable table{};
        table.kind = t.dims == 4 ? BSDF_TREE4 : BSDF_TREE3;
        table.swap = swap;
        table.min_psa = float(pi * narrow * narrow);
        table.v_grid = grid;
        table.dims = uint32_t(t.dims);
        table.values = add_floats(values);
        table.children = add_words(t.child);
        table.u_children = NONE;
        const bool coloured = file.u.dims == t.dims && file.v.dims == t.dims;
        if (coloured && bands_) base::warn(place_, "is taken as grey by -action: the colours of a tensor tree");
        if (coloured && !bands_) {
            table.u_values = add_floats(file.u.value), table.u_children = add_words(file.u.child);
            table.v_values = add_floats(file.v.value), table.v_children = add_words(file.v.child);
        }
        std::vector<float> hemi, psa;
        if (t.dims == 3 && swap) turned_tree(table, hemi, psa);
        else tree_grids(t, values, swap ? 2 : 0, grid, hemi, psa);
        table.hemi = add_floats(hemi);
        table.v_psa = add_floats(psa);
        return table;
    }

    // By cell of v's dimensions: pi * sum of f * area over l's square, and the smallest cell there.
    static void tree_grids(const BsdfTree& t, const std::vector<float>& values, int first, uint32_t n,
                           std::vector<float>& hemi, std::vector<float>& psa) {
        const int mine = t.dims == 4 ? 2 : 1;
        const size_t rows = mine == 2 ? n : 1;
        std::vector<double> sum(n * rows, 0.0);
        psa.assign(n * rows, float(pi));
        leaves(t, [&](uint32_t leaf, const double* low, double width) {
            const double x0 = low[first] * n, x1 = x0 + width * n;
            const double y0 = mine == 2 ? low[first + 1] * n : 0, y1 = mine == 2 ? y0 + width * n : 1;
            const double share = std::min(1.0, width * n) * (mine == 2 ? std::min(1.0, width * n) : 1.0);
            const double part = pi * values[leaf] * width * width * share;  // share: leaves finer than the grid
            for (size_t y = size_t(y0); double(y) < y1; y++)
                for (size_t x = size_t(x0); double(x) < x1; x++) {
                    sum[y * n + x] += part;
                    psa[y * n + x] = std::min(psa[y * n + x], float(pi * width * width));
                }
        });
        hemi.assign(sum.begin(), sum.end());
    }

    // An isotropic tree in the reverse direction: no dimension is v's, so by quadrature.
    void turned_tree(const BsdfTable& table, std::vector<float>& hemi, std::vector<float>& psa) {
        const uint32_t n = table.v_grid;
        SceneTables s = {};
        s.u = code_.words.data();
        s.f = code_.floats.data();
        hemi.assign(n, 0.0f);
        psa.assign(n, table.min_psa);
        const int steps = 64;
        for (uint32_t i = 0; i < n / 2; i++) {
            const float r = 1 - 2 * (float(i) + .5f) / float(n);
            const float3 v = F3(r, 0, bsdf_height(r, 0));
            double sum = 0;
            for (int k = 0; k < steps * steps; k++) {
                const float2 d = bsdf_disc((float(k % steps) + .5f) / steps, (float(k / steps) + .5f) / steps);
                float unused;
                sum += double(bsdf_value(&s, &table, v, F3(d.x, d.y, bsdf_height(d.x, d.y)), &unused));
            }
            hemi[i] = float(pi * sum / (steps * steps));
        }
    }

    const scene::Bsdf& b_;
    const BandColours* bands_;
    BsdfRecords& out_;
    cal::Code& code_;
    const std::string& place_;
    std::vector<uint32_t> rings_at_;  // of each basis
};

}  // namespace

uint32_t add_bsdf(const scene::Bsdf& bsdf, const BandColours* bands, BsdfRecords& records, cal::Code& code,
                  const std::string& place) {
    return BsdfWriter(bsdf, bands, records, code, place).write();
}

}  // namespace flatten
