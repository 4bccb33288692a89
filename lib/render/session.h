// SPDX-License-Identifier: BSD-3-Clause
// A scene that is rendered from edit to edit (docs/decisions/0034-edits.md).  An edit repeats only the work that it
// affects: a view or most options none of the scene's, files all except the tree of unchanged surfaces.  After any
// edits the frames are those of a separate run.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "render/progressive.h"
#include "scene/object.h"

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
    // files: those of the scene, as edits may have read them again.
    Session(std::unique_ptr<Renderer> renderer, std::vector<std::string> files);
    // Reads the scene from these files, with that sky (a file; empty: none).  keep: edits or other views may follow.
    void load(scene::Scene scene, const std::string& sky, const Setup& setup, bool keep);
    // Selects the view of the calls below.
    void select(const Setup& setup);
    // Applies an edit; read: reads the files, too.  Returns true if the picture changes and begins anew.  Throws Error
    // and leaves all unchanged.
    bool edit(const Setup& next, bool read);

    Renderer& renderer() const { return *renderer_; }
    const scene::Scene& scene() const { return scene_; }  // empty unless kept
    const RenderView& view() const { return setup_.view; }
    const std::vector<std::string>& history() const { return history_; }  // edits of the scene

private:
    scene::Scene read_again(scene::ReadOptions how) const;

    std::unique_ptr<Renderer> renderer_;
    std::vector<std::string> files_, history_;
    std::string sky_;
    scene::Scene scene_;  // with its sky
    Setup setup_;
};

}  // namespace render
