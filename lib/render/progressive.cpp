// SPDX-License-Identifier: BSD-3-Clause
// Frames of Eq. 7.  L(0) = exact part (splatted emitters) + S0, the mean of m samples of the direct class; frames 1..m
// carry the diffuse class; frame k > m adds S(k) - S0, so that for n >= m both classes are plain means of n samples and
// frame 0's own noise averages out (docs/spec/paper.md 7, docs/decisions/0002-frame-zero.md).  Half of the frames 1..m
// have the mean of the first half of frame 0's samples in place of S0, the other half that of the second half.  In
// noisy pixels, which have several samples in each frame, all frames k >= 1 add S(k) - S0.
#include "render/progressive.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fmt/core.h>
#include <future>

#include "base/error.h"
#include "base/memory.h"
#include "device/device.h"
#include "render/beyond_limit.h"
#include "render/drawn_sources.h"
#include "render/eye_on_surface.h"
#include "render/fingerprint.h"
#include "render/frame_zero.h"
#include "render/make_device.h"
#include "render/noisy.h"
#include "render/pixel_moments.h"
#include "render/samples.h"
#include "render/scene_params.h"
#include "render/view_params.h"
#include "sampling/mixture_weights.h"
#include "sampling/smooth_planes.h"
#include "sampling/suns.h"
#include "sampling/targets.h"

namespace render {
using namespace kernels;

// In small pictures frame 0 costs little, and a single noisy pixel holds much of the light: each of its m samples is
// the mean of two or four, up to half a million in all.
uint32_t samples_for_one(size_t pixels) {
    constexpr size_t enough = 256 * 256;
    return 4 * pixels <= enough ? 4 : 2 * pixels <= enough ? 2 : 1;
}

constexpr float RAY_REST = 0.3f;  // light from other directions, over portals': a single ray does not repay pilots

struct Renderer::State {
    std::unique_ptr<device::Device> device;
    std::shared_ptr<flatten::FlatScene> flat;  // the device's
    base::Hash geometry;                       // of the fingerprint
    Focus focus;                               // of the view, as all below
    std::string fingerprint;
    DrawnSources drawn;
    sampling::SmoothSurfaces smooth;  // of the scene, if it has a sun
    Params base{};
    view::View view;
    int told_limit = no_limit;      // of bounces: the last one that warn_of_limit() was called for
    uint32_t nx, ny, m, of_frame0;  // samples of the direct class in frame 0
    FrameZero zero;
    image::Moments moments;
    double noisy_share = 0;
    bool seeks_noisy = false;     // the noisy pixels are not known yet
    std::vector<uint32_t> noisy;  // pixels with several samples in each frame, not those of a focus
    std::vector<float> unshared;  // records of portals, then of highlights, until their weights are known
    Samples sampler;

    // Runs frames first .. first+count-1 and calls give(sample, pixel values) in order until it returns false.  The
    // first frames run one by one, later ones together where that is faster.  An asynchronous device has begun the next
    // ones during this call.
    template <class Give>
    void samples(int64_t first, int64_t count, Give&& give) {
        const int64_t most = std::max<int64_t>(1, device->preferred_batch_size() / sampler.path_count(base));
        const auto batch = [&](int64_t done) { return std::min({std::max<int64_t>(1, done), most, count - done}); };
        const auto begin = [&](int64_t done) {
            const Pass pass{MODE_FRAMES, first + done, uint32_t(batch(done)), 0, nx * ny};
            const auto when = device->is_async() ? std::launch::async | std::launch::deferred : std::launch::deferred;
            return std::async(when, [this, pass] {
                std::vector<float> rgb;
                run(pass, rgb);
                return rgb;
            });
        };
        std::future<std::vector<float>> next = begin(0);
        std::vector<float> one;
        for (int64_t done = 0, n; done < count; done += n) {
            const std::vector<float> rgb = next.get();
            n = batch(done);
            if (done + n < count) next = begin(done + n);
            for (int64_t i = 0; i < n; i++) {
                if (n > 1) take_sample(rgb, size_t(n), size_t(i), one);
                if (!give(first + done + i, n > 1 ? one.data() : rgb.data())) return;
            }
        }
    }
    void run(const Pass& pass, std::vector<float>& rgb) { sampler.run(*device, base, pass, rgb); }
    static void take_sample(const std::vector<float>& rgb, size_t n, size_t sample, std::vector<float>& one) {
        one.resize(rgb.size() / n);
        for (size_t pixel = 0; 3 * pixel < one.size(); pixel++)
            std::copy_n(&rgb[3 * (n * pixel + sample)], 3, &one[3 * pixel]);
    }
    void ensure_aim_shares() {
        if (unshared.empty()) return;
        sampling::optimise_mixture(*device, unshared, base);
        unshared.clear();
    }
    void ensure_zero() {
        if (!zero.mean.empty()) return;
        const std::vector<ImagePoint> images = drawn.draw_images(*device, base);
        zero = draw_frame_zero(*device, sampler, base, m, of_frame0, drawn.straight(), images);
    }
    // Chooses the pixels with several samples in each frame.
    void ensure_noisy() {
        if (!seeks_noisy) return;
        noisy = sampler.add_noisy(*device, spp_of_noisy(*device, base, noisy_share));
        seeks_noisy = false;
    }
    std::vector<float> records_of_aims() const {
        const auto portals = flat->f.begin() + long(flat->portals_at);
        std::vector<float> records(portals, portals + long(flat->portal_count) * PORTAL_FLOATS);
        const auto highlights = flat->f.begin() + long(flat->highlights_at);
        records.insert(records.end(), highlights, highlights + long(flat->highlight_count) * HIGHLIGHT_FLOATS);
        return records;
    }
    // Resets everything of the view, except what needs no samples.
    void begin() {
        sampler.set_focus(*device, focus);
        zero = {};
        moments.reset();
        noisy.clear();
        seeks_noisy = noisy_share > 0;
        unshared = records_of_aims();  // their weights depend on the eye point
        sampling::pick_all_portals(flat->portal_count, 0, 0, base);
        base.highlight_share = Params{}.highlight_share;
    }
    // Values of frame k from those of a sample.
    void make_frame(int64_t k, const float* v, std::vector<float>& out) const {
        if (k > m)
            for (size_t i = 0; i < out.size(); i++) out[i] = v[i] - zero.mean[i];
        else if (zero.half_off.empty()) std::copy(v, v + out.size(), out.begin());
        else
            for (size_t i = 0; i < out.size(); i++)
                out[i] = image::in_first_half(k) ? v[i] + zero.half_off[i] : v[i] - zero.half_off[i];
        for (size_t i = 0; k <= m && i < 3 * noisy.size(); i++) {
            const size_t at = 3 * size_t(noisy[i / 3]) + i % 3;
            out[at] = v[at] - zero.mean[at];
        }
    }
};

void require_memory(const RenderView& v) {
    constexpr uint64_t pixel = 60;  // bytes: frame 0's sums in double, a sample, a frame and its output buffer
    const uint64_t memory = base::machine_memory(), least = pixel * uint64_t(v.nx) * uint64_t(v.ny);
    if (memory == 0 || least <= memory) return;
    errno = 0;
    base::fail_system("-x, -y", fmt::format("{} x {} pixels need at least {:.1f} GB; this machine has {:.1f} GB", v.nx,
                                            v.ny, double(least) * 1e-9, double(memory) * 1e-9));
}

Renderer::Renderer(const std::string& device) : state_(std::make_unique<State>()) {
    state_->device = make_device(device);
}

Renderer::Renderer(const scene::Scene& scene, const view::View& view, int nx, int ny, const RenderOptions& options,
                   const std::string& device, const scene::ReadOptions& files)
    : Renderer(device) {
    load(scene, options, files);
    select_view({view, nx, ny}, options);
}

bool Renderer::is_near(const RenderView& v) const {
    const flatten::FlatScene& flat = *state_->flat;
    return flatten::centre_of(flat.boxes, &v.view.vp) == flat.centre;
}

void Renderer::load(const scene::Scene& scene, RenderOptions o, const scene::ReadOptions& files) {
    State& s = *state_;
    if (s.flat) o.known_tree = s.flat->tree_and_inputs();
    auto flat = std::make_shared<flatten::FlatScene>(flatten::flatten(scene, o, files));
    if (o.sampling != Sampling::plain) sampling::find_targets(*flat);
    s.smooth = sampling::suns_of(*flat).empty() ? sampling::SmoothSurfaces() : sampling::smooth_surfaces(*flat);
    flat->images_at = uint32_t(flat->f.size());
    flat->f.resize(flat->f.size() + (s.smooth.none() ? 0 : MOST_IMAGES * IMAGE_FLOATS));
    flat->host_tree();  // before its inputs are released
    flat->known_tree = {};
    const base::Hash geometry = hash_of_geometry(*flat);
    s.device->upload(flat);
    flat->keep_tables_only();
    flat->tell_tree = nullptr;  // its progress is no longer shown
    s.flat = std::move(flat);
    s.geometry = geometry;
    s.drawn = {};
}

void Renderer::select_view(const RenderView& v, const RenderOptions& o) {
    State& s = *state_;
    s.base = params_of(*s.flat, o);
    s.m = s.base.skip_direct_below;
    s.noisy_share = o.sampling == Sampling::reuse ? o.noisy_share : 0;
    s.sampler.set_path_reuse(o.sampling == Sampling::reuse && allows_path_reuse(s.base));
    s.nx = s.base.nx = uint32_t(v.nx);
    s.ny = s.base.ny = uint32_t(v.ny);
    s.of_frame0 = s.m * (o.more_if_small ? samples_for_one(size_t(v.nx) * size_t(v.ny)) : 1);
    s.view = v.view;
    set_view(s.base, v.view, s.flat->centre);
    s.focus = v.focus;

    const flatten::HostTracer tracer(*s.flat);
    const bool one_eye = v.view.type != 'l' && v.view.vo == 0 && o.pd <= 0;
    const bool on_surface = one_eye && eye_on_surface(*s.flat, tracer, v.view.vp);
    if (on_surface || !one_eye) s.base.flags |= PF_EYE_ON_SURFACE;  // its rays may begin on a surface
    // drawing needs one eye point, and straight rays no unattenuated path through glass
    const bool drawable = s.flat->source_count > 0 && o.pd <= 0 && o.dv && !o.i;
    s.drawn.select(*s.device, *s.flat, tracer, s.smooth, v.view, drawable && !on_surface, drawable, s.base);
    s.fingerprint = render::fingerprint(s.geometry, *s.flat, v.view, v.nx, v.ny, o, v.focus);
    s.begin();
}

void Renderer::cancel_when(const std::atomic<bool>* asked) { state_->device->cancel_when(asked); }

Renderer::~Renderer() = default;

std::string Renderer::fingerprint() const {
    const std::string bits = state_->device->own_bits();
    return state_->fingerprint + (bits.empty() ? "" : " device:" + bits);
}
std::string Renderer::device_name() const { return state_->device->name(); }

void Renderer::frames(int64_t k, int count, const std::function<bool(int64_t, const std::vector<float>&)>& give) {
    State& s = *state_;
    const int64_t end = k + count;
    const bool from_start = k == 0;
    std::vector<float> out(size_t(s.nx) * s.ny * 3);
    try {
        if (k == 0 || end - 1 > s.m || s.m % 2 == 0 || s.seeks_noisy) s.ensure_zero();
        if (k == 0) {
            out = s.zero.mean;
            for (size_t i = 0; i < s.zero.exact.size(); i++) out[i] += s.zero.exact[i];
            if (!give(0, out)) return;
            k = 1;
        }
        if (k >= end) return;
        s.ensure_aim_shares();
        if (from_start && std::exchange(s.told_limit, s.base.ab) != s.base.ab)
            warn_of_limit(*s.device, s.base, s.view, s.zero.exact);
        s.ensure_noisy();
        s.samples(k, end - k, [&](int64_t frame, const float* v) {
            s.make_frame(frame, v, out);
            return give(frame, out);
        });
    } catch (const device::Cancelled&) {
        s.begin();  // a pass over single pixels may have been cancelled
    }
}

image::Moments Renderer::moments() {
    State& s = *state_;
    s.ensure_zero();
    if (!s.moments) s.moments = pixel_moments(*s.device, s.sampler, s.base, s.zero);
    return s.moments;
}

void Renderer::frame(int64_t k, std::vector<float>& rgb) {
    frames(k, 1, [&](int64_t, const std::vector<float>& v) {
        rgb = v;
        return true;
    });
}

Renderer::RayValue Renderer::trace_ray(const double origin[3], const double dir[3], int64_t n) {
    State& s = *state_;
    Params p = s.base;
    p.mode = MODE_RAY;
    p.flags |= PF_EYE_ON_SURFACE;
    sampling::pick_all_portals(s.flat->portal_count, 1, RAY_REST, p);
    const base::Vec3 d = base::unit({dir[0], dir[1], dir[2]});
    p.ray_org = {float(origin[0] - p.centre.x), float(origin[1] - p.centre.y), float(origin[2] - p.centre.z), 0};
    p.ray_dir = {float(d.x), float(d.y), float(d.z), 0};
    double sum[3] = {}, square[3] = {};
    std::vector<float> rgb;
    for (int64_t done = 0; done < n;) {
        p.frame = uint32_t(done);
        p.first = 0;
        p.path_count = uint32_t(std::min<int64_t>(n - done, 1 << 16));
        s.device->run(p, rgb);
        s.sampler.scrub(rgb);
        for (size_t i = 0; i < rgb.size(); i++) {
            sum[i % 3] += rgb[i];
            square[i % 3] += double(rgb[i]) * rgb[i];
        }
        done += p.path_count;
    }
    RayValue v;
    for (int c = 0; c < 3; c++) {
        v.mean[c] = sum[c] / double(n);
        const double var = n > 1 ? (square[c] / double(n) - v.mean[c] * v.mean[c]) * double(n) / double(n - 1) : 0;
        v.error[c] = std::sqrt(std::max(0.0, var) / double(n));
    }
    return v;
}

}  // namespace render
