// SPDX-License-Identifier: BSD-3-Clause
// PNG by libpng, composed in memory.
#include <png.h>

#include <csetjmp>

#include "base/error.h"
#include "display/file.h"

namespace display {
namespace {

void append(png_structp png, png_bytep data, png_size_t n) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), n);
}
void no_flush(png_structp) {}

[[noreturn]] void on_error(png_structp, png_const_charp text) { throw base::Error(base::Kind::system, "png", text); }
void on_warning(png_structp, png_const_charp) {}

}  // namespace

std::string png_bytes(const Image8& image, const std::string& comment) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info) base::fail_system("png", "not enough memory");
    struct Guard {
        png_structp* png;
        png_infop* info;
        ~Guard() { png_destroy_write_struct(png, info); }
    } guard{&png, &info};
    png_set_write_fn(png, &bytes, append, no_flush);
    png_set_IHDR(png, info, png_uint_32(image.width), png_uint_32(image.height), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    std::string text_of = comment;
    char key[] = "Comment";
    png_text text = {};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key;
    text.text = &text_of[0];
    text.text_length = text_of.size();
    if (!comment.empty()) png_set_text(png, info, &text, 1);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) png_write_row(png, image.at(0, y));
    png_write_end(png, nullptr);
    return bytes;
}

}  // namespace display
