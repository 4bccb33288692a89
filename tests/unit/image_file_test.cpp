// SPDX-License-Identifier: BSD-3-Clause
// Files: OpenEXR in its variants, masks, and writing whole or not at all.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cmath>

#include "base/warnings.h"
#include "image/exr.h"
#include "image/exr_file.h"
#include "image/grey.h"
#include "image/masks.h"
#include "image/stream.h"
#include "image_pictures.h"
#include "temp_folder.h"

using image::Picture;

TEST_CASE("OpenEXR: every compression, scanlines and tiles, float and half") {
    TempFolder temp;
    Picture p = small_picture(70, 67);
    for (float& v : p.rgb) v = std::fmod(v, 100.f);
    for (const char* compression : {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"})
        for (const bool tiled : {false, true})
            for (const bool half : {false, true}) {
                CAPTURE(compression);
                CAPTURE(tiled);
                CAPTURE(half);
                image::ExrOptions o;
                o.half = half;
                o.tiled = tiled;
                o.compression = compression;
                const std::string path = temp.name("a.exr");
                image::write_exr(path, p, o);
                const Picture q = image::read_file(path);
                const std::string c = compression;
                const bool lossy = c[0] == 'b' || c[0] == 'd' || (c == "pxr24" && !half);
                double worst = 0;
                for (size_t i = 0; i < p.rgb.size(); ++i)
                    worst = std::max(worst, double(std::fabs(q.rgb[i] - p.rgb[i])));
                if (!half && (c == "pxr24")) CHECK(worst < 100 * std::ldexp(1., -15));
                else if (!lossy && !half) CHECK(worst == 0);
                else if (!lossy) CHECK(worst <= 100 * std::ldexp(1., -11));
                CHECK(q.rgb.size() == p.rgb.size());
                CHECK(*q.header.view == *p.header.view);
                CHECK(q.header.seed == p.header.seed);
                CHECK(q.header.ranges == p.header.ranges);
                CHECK(q.header.lines[1] == p.header.lines[1]);
            }
}

TEST_CASE("OpenEXR keeps frame 0 beside the sum") {
    TempFolder temp;
    Picture p = small_picture(4, 4);
    p.frame0.assign(48, 2.5f);
    const std::string path = temp.name("a.exr");
    image::write_file(path, p);
    CHECK(image::read_file(path).frame0 == p.frame0);
}

TEST_CASE("OpenEXR keeps moments, but not with half floats, nor those of other pixels") {
    TempFolder temp;
    Picture p = small_picture(4, 4);
    p.moments = moments_of(p);
    const std::string path = temp.name("a.exr");
    image::write_file(path, p);
    REQUIRE(image::read_file(path).moments);
    CHECK(*image::read_file(path).moments == *p.moments);
    image::WriteOptions half;
    half.exr.half = true;
    image::write_file(path, p, half);
    CHECK(!image::read_file(path).moments);

    // another program has changed a pixel
    std::vector<image::ExrChannel> channels;
    const char* names[] = {"variance", "difference", "right", "up"};
    for (int c = 0; c < 3; ++c) channels.push_back({std::string(1, "RGB"[c]), p.rgb.data() + c, 3});
    for (int k = 0; k < 4; ++k) channels.push_back({std::string("moments.") + names[k], p.moments->data() + k, 4});
    std::string warned;
    base::set_warning_sink([&](const std::string& text) { warned += text; });
    image::write_exr_channels(path, 4, 4, channels, p.header, {{"moments", "0123456789abcdef"}}, {});
    CHECK(!image::read_file(path).moments);
    CHECK(warned.find("another program has changed its pixels") != std::string::npos);
    base::set_warning_sink({});
}

TEST_CASE("OpenEXR keeps the parts of a sum, but not with half floats") {
    TempFolder temp;
    Picture p = small_picture(4, 4);
    p.header.frames = 9;
    p.parts = {{5, std::vector<float>(16, 2.f), {{7, {{1, 2}, {9, 9}}}, {8, {{1, 2}}}}},
               {4, std::vector<float>(16, 3.f), {{7, {{3, 6}}}}}};
    const std::string path = temp.name("a.exr");
    image::write_file(path, p);
    const Picture q = image::read_file(path);
    REQUIRE(q.parts.size() == 2);
    for (size_t k = 0; k < 2; ++k) {
        CHECK(q.parts[k].frames == p.parts[k].frames);
        CHECK(q.parts[k].grey == p.parts[k].grey);
        CHECK(q.parts[k].from == p.parts[k].from);
    }
    image::WriteOptions half;
    half.exr.half = true;
    image::write_file(path, p, half);
    CHECK(image::read_file(path).parts.empty());
}

TEST_CASE("parts that nobody asked for are kept to a sixteenth of their noise, and their mean is the picture") {
    TempFolder temp;
    Picture p = small_picture(4, 4);
    p.header.frames = 9;
    const std::vector<float> mean = image::grey_of(p.rgb);
    p.parts = {{5, mean, {{7, {{1, 5}}}}}, {4, mean, {{7, {{6, 9}}}}}};
    std::vector<float> noise(16);
    for (size_t i = 0; i < 16; ++i) {  // a bright pixel among dark ones
        noise[i] = 1e-3f * std::fabs(mean[i]) * (i == 5 ? 1e6f : float(i + 1));
        p.parts[0].grey[i] += 4 * noise[i], p.parts[1].grey[i] -= 5 * noise[i];
    }
    image::WriteOptions coarse;
    coarse.exr.coarse_parts = true;
    image::write_file(temp.name("a.exr"), p, coarse);
    const Picture q = image::read_file(temp.name("a.exr"));
    REQUIRE(q.parts.size() == 2);
    CHECK(q.parts[1].from == p.parts[1].from);
    for (size_t i = 0; i < 16; ++i) {
        const double first = double(q.parts[0].grey[i]), second = double(q.parts[1].grey[i]),
                     rounding = 1e-6 * std::fabs(first);
        CHECK(std::fabs(first - double(p.parts[0].grey[i])) <= 4 * double(noise[i]) / 16 + rounding);
        CHECK(std::fabs((5 * first + 4 * second) / 9 - double(mean[i])) <= rounding);
    }
}

TEST_CASE("parts that no picture can have are told in a line") {
    TempFolder temp;
    const std::string path = temp.name("a.exr");
    Picture p = small_picture(2, 2);
    p.header.frames = 20;
    p.parts = {{7, {1, 2, 3, NAN}, {{1, {{1, 7}}}}}};
    image::write_file(path, p);
    CHECK(error_text([&] { image::read_file(path); }) == path + ": its parts hold 7 frames, its header says 20");
    p.header.frames = 7;
    image::write_file(path, p);
    CHECK(image::read_file(path).parts[0].grey == std::vector<float>{1, 2, 3, 0});
    p.parts[0].from.clear();
    image::write_file(path, p);
    CHECK(error_text([&] { image::read_file(path); }) == path + ": does not say which frames part0.Y holds");
    p.parts.resize(17, {1, std::vector<float>(4), {}});
    image::write_file(path, p);
    CHECK(error_text([&] { image::read_file(path); }) == path + ": holds more than 16 layers part<n>.Y");
}

// mean<n>.Y of L'(n) = n: frames 1 to 2 are 2 on average, and 3 to 5 (25 - 4)/3 = 7.
TEST_CASE("means of earlier versions are read as ranges") {
    TempFolder temp;
    const std::string path = temp.name("a.exr");
    const std::vector<float> rgb(12, 9), two(4, 2), five(4, 5);
    image::Header header;
    header.frames = 9;
    header.ranges = {{0, 9}};
    image::write_exr_channels(path, 2, 2,
                              {{"R", rgb.data(), 3},
                               {"G", rgb.data(), 3},
                               {"B", rgb.data(), 3},
                               {"mean2.Y", two.data(), 1},
                               {"mean5.Y", five.data(), 1}},
                              header, {}, {});
    const Picture p = image::read_file(path);
    REQUIRE(p.parts.size() == 3);
    CHECK(p.parts[0].frames == 2);
    CHECK(p.parts[0].grey[0] == doctest::Approx(2));
    CHECK(p.parts[1].frames == 3);
    CHECK(p.parts[1].grey[0] == doctest::Approx(7));
    CHECK(p.parts[2].frames == 4);
    CHECK(p.parts[2].grey[0] == doctest::Approx((81 - 25) / 4.));
}

TEST_CASE("half floats are cut at 65504 with a warning") {
    TempFolder temp;
    Picture p = small_picture(2, 2);
    p.rgb[0] = 1e6f;
    image::ExrOptions o;
    o.half = true;
    const std::string path = temp.name("a.exr");
    base::take_warnings();
    image::write_exr(path, p, o);
    CHECK(base::take_warnings().size() == 1);
    CHECK(image::read_file(path).rgb[0] == 65504);
}

namespace {
// An EXR of another program: luminance only, data window smaller than and apart from the display window.
void write_foreign(const std::string& path, const char* channel, Imath::V2i at = {11, 11}) {
    Imf::Header h(Imath::Box2i({10, 10}, {13, 12}), Imath::Box2i(at, at + Imath::V2i(1, 1)));
    h.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    h.insert("VIEW", Imf::StringAttribute("-vtv -vh 33 -vv 22"));
    Imf::addWhiteLuminance(h, 358);  // twice ours
    const float data[4] = {1, 2, 3, 4};
    Imf::OutputFile file(path.c_str(), h);
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, data, h.dataWindow(), 4, 8));
    file.setFrameBuffer(frame);
    file.writePixels(2);
}
}  // namespace

TEST_CASE("OpenEXR of other programs: luminance only, windows, white luminance, a VIEW attribute") {
    TempFolder temp;
    const std::string path = temp.name("y.exr");
    write_foreign(path, "Y");
    base::take_warnings();
    const Picture p = image::read_file(path);
    CHECK(p.width == 4);
    CHECK(p.height == 3);
    CHECK(p.at(0, 0)[0] == 0);
    CHECK(p.at(1, 1)[2] == 2);
    CHECK(p.at(2, 1)[0] == 4);
    CHECK(p.at(2, 2)[1] == 8);
    CHECK(p.at(3, 2)[1] == 0);
    CHECK(p.header.view->vh == 33);
    write_foreign(path, "depth");
    CHECK(error_text([&] { image::read_file(path); }) ==
          path + ": has neither the channels R G B nor Y: it is not a picture");
}

TEST_CASE("OpenEXR of other programs: primaries are Rec. 709 where none are stated") {
    TempFolder temp;
    const std::string path = temp.name("c.exr");
    const auto green = [&](const std::optional<Imf::Chromaticities>& stated, const char* attribute, const char* text) {
        Imf::Header h(1, 1);
        for (const char* c : {"R", "G", "B"}) h.channels().insert(c, Imf::Channel(Imf::FLOAT));
        if (stated) Imf::addChromaticities(h, *stated);
        h.insert(attribute, Imf::StringAttribute(text));
        const float rgb[3] = {0, 1, 0};
        Imf::FrameBuffer frame;
        for (int c = 0; c < 3; ++c)
            frame.insert(&"R\0G\0B"[2 * c], Imf::Slice::Make(Imf::FLOAT, rgb + c, h.dataWindow(), 12, 12));
        Imf::OutputFile file(path.c_str(), h);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    };
    const auto read = [&] { return image::read_file(path); };
    const auto luminance = [&] { return image::luminance(read().at(0, 0)) / image::lumens_per_watt; };
    const std::optional<Imf::Chromaticities> none;
    green(none, "Software", "Blender 4.2");
    CHECK(luminance() == doctest::Approx(.7152).epsilon(2e-4));  // Rec. 709: 0.2126 R + 0.7152 G + 0.0722 B
    using Imath::V2f;
    green(Imf::Chromaticities(V2f(.64f, .33f), V2f(.29f, .6f), V2f(.15f, .06f), V2f(.3333f, .3333f)), "a", "b");
    CHECK(luminance() == doctest::Approx(.670115).epsilon(1e-5));
    green(none, "radianceHeader", "#?RADIANCE\nSOFTWARE=luxpipe 0.1.0\n");  // ours, gone through another program
    CHECK(luminance() == doctest::Approx(.670115).epsilon(1e-5));
    green(Imf::Chromaticities(V2f(.7347f, .2653f), V2f(0, 1), V2f(.0001f, -.077f), V2f(.32168f, .33767f)), "a", "ACES");
    CHECK(luminance() == doctest::Approx(.7281661).epsilon(1e-4));  // SMPTE ST 2065-1
    const V2f o(0, 0), p(.3f, .3f);
    green(Imf::Chromaticities(o, o, o, o), "a", "b");
    CHECK(luminance() == doctest::Approx(.7152).epsilon(2e-4));
    green(Imf::Chromaticities(p, p, p, p), "a", "b");
    CHECK(error_text([&] { read(); }) == path + ": its chromaticities are not those of three primaries");

    // attributes are texts of any program: a view is taken where it is one
    for (const char* name : {"view", "VIEW", "FRAME", "SEED", "EXPOSURE", "RANGE", "NCOMP", "VIEWNAME"}) {
        green(none, name, "left ../eye");
        CHECK_MESSAGE(error_text([&] { read(); }).empty(), name);
        CHECK_FALSE(read().header.view);
    }
    green(none, "FRAME", "12");
    CHECK_FALSE(read().header.frame);
}

TEST_CASE("OpenEXR: pixels outside the data window are told of, windows that do not meet and further parts, too") {
    TempFolder temp;
    const std::string path = temp.name("y.exr");
    write_foreign(path, "Y");
    base::take_warnings();
    CHECK(image::read_file(path).at(0, 0)[0] == 0);
    const auto told = base::take_warnings();
    REQUIRE(told.size() == 1);
    CHECK(told[0].first == "8 of its 12 pixels are outside its data window: they are black");
    for (const Imath::V2i& at : {Imath::V2i(14, 11), Imath::V2i(11, 13), Imath::V2i(7, 11)}) {
        write_foreign(path, "Y", at);
        CHECK_THROWS_WITH_AS(image::read_file(path),
                             (path + ": its data window holds nothing of its display window").c_str(), base::Error);
    }

    std::vector<Imf::Header> heads(2, Imf::Header(1, 1));
    for (size_t k = 0; k < 2; ++k) {
        heads[k].setName(k == 0 ? "left" : "right");
        heads[k].setType(Imf::SCANLINEIMAGE);
        heads[k].channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file(path.c_str(), heads.data(), 2);
        for (int k = 0; k < 2; ++k) {
            const float value = float(k + 3);
            Imf::FrameBuffer frame;
            frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, &value, heads[size_t(k)].dataWindow(), 4, 4));
            Imf::OutputPart part(file, k);
            part.setFrameBuffer(frame);
            part.writePixels(1);
        }
    }
    CHECK(image::read_file(path).at(0, 0)[0] == 3);
    const auto parts = base::take_warnings();
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].first == "holds 2 parts: the first one is read");
}

TEST_CASE("a broken OpenEXR file is an error in one line") {
    TempFolder temp;
    const std::string path = temp.name("a.exr");
    image::write_file(path, small_picture(40, 40));
    const std::string bytes = bytes_of(path);
    for (size_t n = 4; n < bytes.size() - 1; n += 1 + n / 40) {
        temp.holding("a.exr", bytes.substr(0, n));
        const std::string text = error_text([&] { image::read_file(path); });
        CHECK_MESSAGE(!text.empty(), n);
        CHECK(text.find('\n') == std::string::npos);
    }
    uint32_t state = 7;
    const auto next = [&] { return state = state * 1664525u + 1013904223u; };
    for (int i = 0; i < 500; ++i) {
        std::string bent = bytes;
        bent[4 + (next() >> 8) % 600] = char(next() >> 24);  // attributes and line table
        temp.holding("a.exr", bent);
        error_text([&] { image::read_file(path); });
    }
}

// OpenEXR reserves what these claim before it looks for it.
TEST_CASE("an OpenEXR header that claims more than there can be is refused before memory is taken") {
    TempFolder temp;
    const std::string path = temp.name("a.exr");
    image::ExrOptions o;
    o.tiled = true;
    image::write_exr(path, small_picture(40, 40), o);
    const std::string bytes = bytes_of(path);

    std::string bent = bytes;
    bent.insert(8, std::string("note\0string\0\xf0\xff\xff\x7f", 16));
    temp.holding("a.exr", bent);
    CHECK(error_text([&] { image::read_file(path); }) ==
          path + ": is not a readable OpenEXR file: attribute note is longer than the file");

    bent = bytes;
    bent[bent.find(std::string("chlist\0", 7)) + 7]++;  // what follows would be read one byte off
    temp.holding("a.exr", bent);
    CHECK(error_text([&] { image::read_file(path); }) ==
          path + ": is not a readable OpenEXR file: attribute channels does not have the length of its type");

    bent = bytes;
    const size_t at = bent.find(std::string("tiledesc\0", 9));
    REQUIRE(at != std::string::npos);
    bent.replace(at + 13, 8, "\0\x78\0\0\0\x78\0\0", 8);  // tiles of 30720 x 30720 pixels
    temp.holding("a.exr", bent);
    CHECK(error_text([&] { image::read_file(path); }) ==
          path + ": its tiles are too large: 30720 x 30720 pixels of 12 bytes");
}

TEST_CASE("masks keep names, order and coverage") {
    TempFolder temp;
    image::MaskSet set;
    set.width = 3;
    set.height = 2;
    set.masks = {{"screen-hi", {0, .25f, .5f, 1, 0, 0}}, {"desk", {1, 1, 1, 0, 0, 0}}, {"A_1", {0, 0, 0, 0, 0, 1}}};
    set.header = small_picture(1, 1).header;
    const std::string path = temp.name("m.exr");
    image::write_masks(path, set);
    const image::MaskSet back = image::read_masks(path);
    CHECK(back.width == 3);
    CHECK(back.height == 2);
    REQUIRE(back.masks.size() == 3);
    for (size_t i = 0; i < 3; ++i) {
        CHECK(back.masks[i].name == set.masks[i].name);
        CHECK(back.masks[i].coverage == set.masks[i].coverage);
    }
    CHECK(*back.header.view == *set.header.view);
    set.masks[0].name = "no good";
    CHECK_FALSE(error_text([&] { image::write_masks(path, set); }).empty());
    set.masks[0].name = "ok";
    set.masks[0].coverage[0] = 1.5f;
    image::write_masks(path, set);
    CHECK(error_text([&] { image::read_masks(path); }) == path + ": region \"ok\" has a coverage outside 0..1");
}

TEST_CASE("a file that cannot be written leaves nothing, one that exists is replaced whole") {
    TempFolder temp;
    const Picture p = small_picture(4, 4);
    CHECK(error_text([&] {
              image::write_file("/no/such/folder/a.exr", p);
          }).find("/no/such/folder/a.exr: cannot be written") == 0);
    CHECK_FALSE(error_text([&] { image::write_file("a.jpg", p); }).empty());
    const std::string path = temp.holding("a.hdr", "old");
    image::write_file(path, p);
    CHECK(image::read_file(path).width == 4);
}
