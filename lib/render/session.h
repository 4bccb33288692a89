// SPDX-License-Identifier: BSD-3-Clause
// A scene that is rendered from edit to edit (docs/decisions/0034-edits.md).  An edit repeats only the work that it
// affects: a view or most options none of the scene's, files all except the tree of unchanged surfaces.  After any
// edits the frames are those of a separate run.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "render/progressive.h"
#include "scene/extent.h"

namespace render {

// Scene files and rendering options.
struct Setup {
    RenderView view;
    RenderOptions options;
    scene::ReadOptions reading;
};

// A preview: at most 128 pixels along its longer side, two direct samples, no noisy pixels or focus.
Setup preview_of(Setup setup);

class Session {
public:
    // scene: without its sky, as read from these files, which edits read again.
    Session(std::unique_ptr<Renderer> renderer, scene::Scene scene, std::vector<std::string> files);
    enum class Next { nothing, views, skies_or_edits };
    // Loads the scene with this sky (a file; empty: none).  next: what may follow.
    void load(const std::string& sky, Setup setup, Next next);
    // Selects the view of the calls below.
    void select(const Setup& setup);
    // Applies an edit.  With `read` it reads the files again; read_view() reads those of the view.  Returns true if the
    // picture changes and begins anew.  Throws Error and leaves all unchanged.
    using ReadView = std::function<void(RenderView& view)>;
    bool edit(Setup next, bool read, const ReadView& read_view = {});

    Renderer& renderer() const { return *renderer_; }
    const scene::Scene& scene() const { return with_sky_.scene; }  // empty unless kept
    const RenderView& view() const { return setup_.view; }
    bool may_have_light() const { return may_have_light_; }
    const std::vector<std::string>& history() const { return history_; }  // edits of the scene

private:
    // A scene with its sky, and what is known of it without.
    struct WithSky {
        scene::Scene scene;
        scene::Extent room;     // where the sky begins
        std::string room_text;  // hash of the surfaces before the sky; empty: nothing follows that could use it
    };
    WithSky read_again(Setup& setup, const ReadView& read_view) const;
    void load_into_renderer(const WithSky& with_sky, const Setup& setup, const scene::ReadOptions& how) const;

    std::unique_ptr<Renderer> renderer_;
    std::vector<std::string> files_, history_;
    std::string sky_;
    WithSky with_sky_;
    Next next_ = Next::nothing;
    bool may_have_light_ = true;
    Setup setup_;
};

}  // namespace render
