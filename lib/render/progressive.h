// SPDX-License-Identifier: BSD-3-Clause
// The progressive loop: frame k of a scene, view and size, on a device (paper Eq. 7 and its section on frame noise).
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "scene/object.h"
#include "render/focus.h"
#include "render/options.h"
#include "view/view.h"

namespace render {

// A picture of the scene.  Its frames have the same bits whatever other pictures are rendered.
struct RenderView {
    view::View view;
    int nx = 0, ny = 0;
    Focus focus = {};
};

// Throws Error (system) if this machine cannot hold its frames.
void require_memory(const RenderView& v);

class Renderer {
public:
    // A device, for scenes one after another.  Throws Error if there is no such device.
    explicit Renderer(const std::string& device);
    // The same with a scene and one picture of it.
    Renderer(const scene::Scene& scene, const view::View& view, int nx, int ny, const RenderOptions& options,
             const std::string& device, const scene::ReadOptions& files);
    ~Renderer();
    // Flattens the scene and uploads it; call select_view() next.  Throws Error (unsupported input with file:line), and
    // keeps the previous scene.
    void load(const scene::Scene& scene, RenderOptions options, const scene::ReadOptions& files);
    // Returns false if the scene must be loaded again, with options.eye = the view's, for the view's frames not to
    // depend on earlier views: its eye is far from the origin of the tables.
    bool is_near(const RenderView& v) const;
    // Selects the view and options of the calls below; the options must equal those of load() in what changes
    // the scene's tables.
    void select_view(const RenderView& v, const RenderOptions& options);
    // While *asked is true, the current frame is discarded: frames() and moments() return early, and continue when
    // called again.
    void cancel_when(const std::atomic<bool>* asked);
    std::string device_name() const;
    std::string fingerprint() const;  // of the present picture (fingerprint.h)
    // Frame k: 3 floats a pixel, row 0 = top, W/(sr m2).  Depends on (seed, k, pixel) alone.
    void frame(int64_t k, std::vector<float>& rgb);
    // Moments of the light within the pixels (image/picture.h).
    image::Moments moments();
    // Frames k .. k+count-1 together where that is faster (GPUs); calls give() in order until it returns false.
    void frames(int64_t k, int count, const std::function<bool(int64_t, const std::vector<float>&)>& give);
    // Mean and standard error of n samples of one ray, all classes (tests compare them with rtrace).
    struct RayValue {
        double mean[3], error[3];
    };
    RayValue trace_ray(const double origin[3], const double dir[3], int64_t samples);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace render
