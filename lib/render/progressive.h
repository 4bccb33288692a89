// SPDX-License-Identifier: BSD-3-Clause
// The progressive loop: frames of a scene, view and size, on a device (paper Eq. 7 and its section on frame noise).
//   load_scene() -> plan_view() -> draw_frame_zero() -> pixel_moments()
//                              \-> learn() -> frames
// Each stage takes the values of those before it and changes none of them.
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "render/options.h"
#include "render/pixel_report.h"
#include "render/view_plan.h"
#include "scene/object.h"

namespace render {

// Receives frame k: 3 floats a pixel, row 0 = top, W/(sr m2), and with frame 0 the moments of the light within the
// pixels (image/picture.h), where they are wanted.  Returns false to end.
using GiveFrame = std::function<bool(int64_t k, const std::vector<float>& rgb, const image::Moments& moments)>;

// Frames first .. first + count - 1 of a picture, in order.  Frame k depends on (seed, k, pixel) alone.
void render_frames(device::Device& device, const ViewPlan& plan, int64_t first, int64_t count, bool moments,
                   const GiveFrame& give);

// A device, the scene that it holds, and the picture of it that is rendered.
class Renderer {
public:
    // Throws Error if there is no such device.
    explicit Renderer(const std::string& device);
    // The same with a scene and one picture of it.
    Renderer(const scene::Scene& scene, const RenderView& view, const RenderOptions& options, const std::string& device,
             const scene::ReadOptions& files);
    Renderer(const scene::Scene& scene, const view::View& view, int nx, int ny, const RenderOptions& options,
             const std::string& device, const scene::ReadOptions& files);
    ~Renderer();
    // Replaces the scene; call select_view() next.  Throws Error (unsupported input with file:line), and keeps the
    // previous one.
    void load(const scene::Scene& scene, RenderOptions options, const scene::ReadOptions& files);
    // Returns false if the scene must be loaded again, with options.eye = viewpoint_of(v), for the view's frames not to
    // depend on earlier views: its eye, or its points, are far from the origin of the tables.
    bool is_near(const RenderView& v) const;
    // Selects the view and options of the calls below; the options must equal those of load() in what changes the
    // scene's tables.
    void select_view(const RenderView& v, const RenderOptions& options);
    // While it says so, the current frame waits, or is discarded and frames() returns early.
    void heed(const std::atomic<device::Wish>* wish);
    std::string device_name() const;
    std::string fingerprint() const;                   // of the present picture (fingerprint.h)
    int64_t direct_frames() const { return plan_.m; }  // for which its frame 0 stands
    uint32_t samples_per_frame() const;                // of a point, at least
    void frames(int64_t first, int64_t count, const GiveFrame& give, bool moments = false);

    // explain_pixel() of the selected view; scene: that of load(), with options.names.
    void explain(const scene::Scene& scene, int x, int y, int64_t first, int64_t last, const GiveRow& give);
    std::string seen(const scene::Scene& scene, double x, double y) const;  // seen.h
    MomentReport explain_moments(const scene::Scene& scene, int x, int y);

    // For tests: one frame; the moments; its parts.
    void frame(int64_t k, std::vector<float>& rgb);
    image::Moments moments();
    device::Device& device() const { return *device_; }
    const ViewPlan& plan() const { return plan_; }

private:
    std::unique_ptr<device::Device> device_;
    LoadedScene scene_;
    ViewPlan plan_;
};

}  // namespace render
