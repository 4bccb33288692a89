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

// A picture of the scene: frames of it have the same bits whatever other pictures are made beside it.
struct RenderView {
    view::View view;
    int nx = 0, ny = 0;
    Focus focus = {};
};

// Does a change of options change the scene's tables?
bool needs_load(const RenderOptions& before, const RenderOptions& after);

// Throws Error (system) if its frames alone cannot be held by this machine.
void require_memory(const RenderView& v);

class Renderer {
public:
    // A device, for scenes one after another.  Throws Error where there is no such device.
    explicit Renderer(const std::string& device);
    // The same with a scene and one picture of it.
    Renderer(const scene::Scene& scene, const view::View& view, int nx, int ny, const RenderOptions& options,
             const std::string& device, const scene::ReadOptions& files);
    ~Renderer();
    // Flattens the scene and uploads it; a view is selected next.  Throws Error (unsupported input with file:line), and
    // the scene that was loaded before stays.
    void load(const scene::Scene& scene, RenderOptions options, const scene::ReadOptions& files);
    // What follows is of this view, with these options, which must be those of load() as far as needs_load() asks.
    void select_view(const RenderView& v, const RenderOptions& options);
    // Is this asked for, a frame at hand is thrown away: frames() and moments() end early, and go on when called again.
    void cancel_when(const std::atomic<bool>* asked);
    std::string device_name() const;
    std::string fingerprint() const;  // of what it renders (fingerprint.h)
    // Frame k: 3 floats a pixel, row 0 = top, W/(sr m2).  Depends on (seed, k, pixel) alone.
    void frame(int64_t k, std::vector<float>& rgb);
    // Moments of the light inside of its pixels (image/picture.h).
    image::Moments moments();
    // Frames k .. k+count-1 together where that is faster (GPUs); give() is called in order; false ends them.
    void frames(int64_t k, int count, const std::function<bool(int64_t, const std::vector<float>&)>& give);
    // Mean and standard error of n samples of one ray, all classes (tests compare with rtrace).
    struct RayValue {
        double mean[3], error[3];
    };
    RayValue trace_ray(const double origin[3], const double dir[3], int64_t samples);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace render
