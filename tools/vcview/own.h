// SPDX-License-Identifier: BSD-3-Clause
// A scene whose programs vcview starts itself, and what both ways of showing share.
#pragma once
#include <optional>
#include "live/browser.h"
#include "options.h"

// Waits until a signal comes, or call() from any thread.
class Wake {
public:
    Wake();
    void call() const;
    void wait() const;

private:
    int ends_[2];
};

// The address is said, and shown in a browser.
class Shown {
public:
    Shown(const live::Server& server, bool open);

private:
    std::optional<live::BrowserPage> browser_;
};

int show_scene(Options options);
