// SPDX-License-Identifier: BSD-3-Clause
// Finds the pictures in a stream of bytes that pass by (man/luxpipe-stream.5) and copies them.  Only float pictures say
// how long they are; at the first other one it stops looking.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>
#include "image/picture.h"

namespace live {

class Framer {
public:
    explicit Framer(std::function<void(image::Picture)> taken) : taken_(std::move(taken)) {}
    void pass(const char* data, size_t bytes);
    // Why no further picture is taken; empty as long as they are.
    const std::string& stopped() const { return stopped_; }

private:
    size_t header(const char* data, size_t bytes);
    size_t pixels(const char* data, size_t bytes);
    void begin_pixels();
    void stop(std::string why) { stopped_ = std::move(why); }
    std::function<void(image::Picture)> taken_;
    std::string head_;
    bool resolution_ = false;  // the header has ended, its resolution line follows
    image::Picture picture_;
    std::vector<float> values_;
    size_t left_ = 0;     // bytes of pixels
    bool layer_ = false;  // what comes is a layer of the picture before it, and is passed over
    std::string stopped_;
};

}  // namespace live
