// SPDX-License-Identifier: BSD-3-Clause
// A scene that is rendered from edit to edit (docs/decisions/0034-edits.md).  An edit pays for what it changes: a view
// and most options nothing of the scene, other files all but a tree whose surfaces are the same.  After any edits the
// frames are those of a run of its own.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "render/progressive.h"
#include "scene/object.h"

namespace render {

// What of a scene is rendered, and how.
struct Setup {
    RenderView view;
    RenderOptions options;
    scene::ReadOptions reading;
};

// A rough picture, for who moves: 128 pixels at most along its longer side, two direct samples, none for noisy pixels
// or a focus.
Setup preview_of(Setup setup);

class Session {
public:
    // files: the scene's, which edits may have read again.
    Session(std::unique_ptr<Renderer> renderer, std::vector<std::string> files);
    // The scene as these files say it, with that sky (a file; empty: none).  keep: edits may come.
    void load(scene::Scene scene, const std::string& sky, const Setup& setup, bool keep);
    // What follows is of this view.
    void select(const Setup& setup);
    // An edit; read: of the files, too.  True: the picture is another one, and begins anew.  Throws Error with all as
    // it was before.
    bool edit(const Setup& next, bool read);

    Renderer& renderer() const { return *renderer_; }
    const RenderView& view() const { return setup_.view; }
    const std::string& sky() const { return sky_; }
    const std::vector<std::string>& history() const { return history_; }  // of the scene

private:
    scene::Scene read_again(scene::ReadOptions how) const;

    std::unique_ptr<Renderer> renderer_;
    std::vector<std::string> files_, history_;
    std::string sky_;
    scene::Scene scene_;  // with its sky
    Setup setup_;
};

}  // namespace render
