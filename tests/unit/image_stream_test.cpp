// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE pictures as a stream: headers, orientations, exposures, and everything cut or bent.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "image/header.h"
#include "image/rgbe.h"
#include "image/stream.h"
#include "image_bytes.h"
#include "image_pictures.h"
#include "temp_folder.h"

using image::Format;
using image::Picture;
using image::StreamReader;

TEST_CASE("float pictures come back bit for bit, with their header") {
    TempFolder temp;
    const Picture p = small_picture(5, 4);
    const std::string path = temp.holding("a.hdr", image::picture_bytes(p, Format::flt));
    const Picture q = image::read_file(path);
    CHECK(q.width == 5);
    CHECK(q.height == 4);
    CHECK(q.rgb == p.rgb);
    CHECK(*q.header.view == *p.header.view);
    CHECK(q.header.seed == p.header.seed);
    CHECK(q.header.frames == 9);
    CHECK(q.header.ranges == p.header.ranges);
    CHECK(q.header.lines[0] == p.header.lines[0]);
    CHECK(q.header.lines[1] == p.header.lines[1]);
    // and again: nothing grows
    CHECK(image::picture_bytes(q, Format::flt) == image::picture_bytes(p, Format::flt));
}

TEST_CASE("which pictures have their paths in common is read, passed on, and no history") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    p.header.shared_paths = "0123456789abcdef";
    const std::string bytes = image::picture_bytes(p, Format::flt);
    CHECK(bytes.find("\nSHARED_PATHS=0123456789abcdef\n") != std::string::npos);
    const Picture q = image::read_file(temp.holding("a.hdr", bytes));
    CHECK(q.header.shared_paths == p.header.shared_paths);
    CHECK(image::picture_bytes(q, Format::flt) == bytes);
    CHECK(image::read_file(temp.holding("b.hdr", image::picture_bytes(small_picture(3, 2), Format::flt)))
              .header.shared_paths.empty());
}

TEST_CASE("which hour of a run a picture is, is read, passed on, and no history") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    p.header.hour = {163, 2600};
    const std::string bytes = image::picture_bytes(p, Format::flt);
    CHECK(bytes.find("\nHOUR=163/2600\n") != std::string::npos);
    const Picture q = image::read_file(temp.holding("a.hdr", bytes));
    CHECK(q.header.hour == p.header.hour);
    CHECK(image::picture_bytes(q, Format::flt) == bytes);
    for (const char* wrong : {"HOUR=5/4", "HOUR=0/4", "HOUR=4", "HOUR=4/x", "HOUR=1/99999999999"}) {
        std::string broken = bytes;
        broken.replace(broken.find("HOUR=163/2600"), 13, wrong);
        CHECK_THROWS_AS(image::read_file(temp.holding("b.hdr", broken)), base::Error);
    }
}

TEST_CASE("what weights the light of a picture is read, passed on, part of its label, and no history") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    p.header.view_name = "desk";
    p.header.action = {"mel", 9, "lx"};
    CHECK(image::label(p.header) == "desk_mel");
    const std::string bytes = image::picture_bytes(p, Format::flt);
    CHECK(bytes.find("\nACTION=mel 9 lx\n") != std::string::npos);
    const Picture q = image::read_file(temp.holding("a.hdr", bytes));
    CHECK(q.header.action == p.header.action);
    CHECK(image::picture_bytes(q, Format::flt) == bytes);
    const std::string exr = temp.name("a.exr");
    image::write_file(exr, p);
    CHECK(image::read_file(exr).header.action == p.header.action);
    for (const char* wrong : {"ACTION=mel", "ACTION=mel 0 lx", "ACTION=mel x lx", "ACTION=mel 9", "ACTION=mel 9 cd",
                              "ACTION=a/b 9 lx", "ACTION=mel 9 lx more", "ACTION=mel 99999999999999999999 lx"}) {
        std::string broken = bytes;
        broken.replace(broken.find("ACTION=mel 9 lx"), 15, wrong);
        CHECK_THROWS_AS(image::read_file(temp.holding("b.hdr", broken)), base::Error);
    }
}

TEST_CASE("a stream is pictures one after another") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    std::string bytes;
    for (int k = 0; k < 5; ++k) {
        p.header.frame = k;
        p.rgb[0] = float(k);
        bytes += image::picture_bytes(p, k % 2 ? Format::rgbe : Format::flt);
    }
    StreamReader in(temp.holding("s.hdr", bytes));
    Picture q;
    for (int k = 0; k < 5; ++k) {
        CHECK(in.next(q));
        CHECK(q.header.frame == k);
    }
    CHECK_FALSE(in.next(q));
    CHECK(in.pictures() == 5);
}

TEST_CASE("moments come behind the picture that they belong to, and hold for the sums that follow") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    const image::Moments own = moments_of(p);
    const auto sum = [&](int64_t n, const image::Moments& moments) {
        p.header.frames = n;
        p.header.ranges = {{0, n}};
        p.moments = moments;
        return image::picture_bytes(p, Format::flt);
    };
    const std::string first = sum(0, own), second = sum(1, nullptr), other = sum(0, nullptr), last = sum(2, nullptr);
    StreamReader in(temp.holding("s.hdr", first + second + other + last));
    Picture q;
    for (int k = 0; k < 4; ++k) {
        CHECK(in.next(q));
        CHECK(bool(q.moments) == (k < 2));
        if (q.moments) CHECK(*q.moments == *own);
        CHECK(q.rgb == p.rgb);
    }
    CHECK_FALSE(in.next(q));
    CHECK(in.pictures() == 4);
    // bytes of 8 bits keep none
    p.moments = own;
    CHECK(!image::read_file(temp.holding("b.hdr", image::picture_bytes(p, Format::rgbe))).moments);
}

TEST_CASE("moments that are not there, of another size or of no picture are told in a line") {
    TempFolder temp;
    Picture p = small_picture(3, 2);
    p.moments = moments_of(p);
    const std::string bytes = image::picture_bytes(p, Format::flt), of_another = [&] {
        Picture big = small_picture(4, 2);
        big.moments = moments_of(big);
        return image::picture_bytes(big, Format::flt);
    }();
    const auto layer = [](const std::string& s) { return s.rfind("#?RADIANCE"); };
    const auto error = [&](const std::string& s) {
        return error_text([&] { image::read_file(temp.holding("m.hdr", s)); });
    };
    const std::string picture = bytes.substr(0, layer(bytes));
    CHECK(error(picture).find("input ends inside the header") != std::string::npos);
    CHECK(error(bytes.substr(0, bytes.size() - 1)).find("input ends inside the picture") != std::string::npos);
    CHECK(error(bytes.substr(layer(bytes))).find("LAYER=moments) without its picture before it") != std::string::npos);
    CHECK(error(picture + picture).find("but they do not") != std::string::npos);
    CHECK(error(picture + of_another.substr(layer(of_another))).find("its moments have 4 x 2 pixels, it has 3 x 2") !=
          std::string::npos);
}

TEST_CASE("moments that no light has are 0") {
    std::vector<float> m = {-1, NAN, 2, -.5f, INFINITY, 3, NAN, .5f};
    image::clean_moments(m);
    CHECK(m == std::vector<float>{0, 0, 0, -.5f, 0, 3, 0, .5f});
}

TEST_CASE("all eight orientations show the same picture") {
    // Pixel value = 10 x + y, x from the left, y from the TOP, 3 wide, 2 high.
    const auto value = [](int x, int y) { return float(10 * x + y); };
    for (const bool x_major : {false, true})
        for (const bool x_down : {false, true})
            for (const bool y_up : {false, true}) {
                std::vector<float> data;
                for (int s = 0; s < (x_major ? 3 : 2); ++s)
                    for (int f = 0; f < (x_major ? 2 : 3); ++f) {
                        const int i = x_major ? s : f, j = x_major ? f : s;
                        for (int c = 0; c < 3; ++c) data.push_back(value(x_down ? 2 - i : i, y_up ? 1 - j : j));
                    }
                const std::string x = std::string(x_down ? "-" : "+") + "X 3",
                                  y = std::string(y_up ? "+" : "-") + "Y 2";
                const Picture p = read("#?RADIANCE\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n" +
                                       (x_major ? x + " " + y : y + " " + x) + "\n" + floats(data));
                CAPTURE(x + y);
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 2; ++j) CHECK(p.at(i, j)[1] == value(i, j));
            }
}

TEST_CASE("float pictures of other programs: byte order, one channel, NROWS and NCOLS instead of a resolution line") {
    const std::vector<float> v{1, 2.5f, -3, 1e30f, 5, 6};
    CHECK(read("#?RADIANCE\nNCOMP=3\nBigEndian=1\nFORMAT=float   \n\n-Y 1 +X 2\n" + floats(v, true)).rgb == v);
    CHECK(read("#?RADIANCE\nNROWS=1\nNCOLS=2\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n" + floats(v)).rgb == v);
    const Picture grey = read("#?RADIANCE\nNCOMP=1\nBigEndian=0\nFORMAT=float\n\n-Y       2 +X       3\n" + floats(v));
    CHECK(grey.at(0, 1)[0] == 1e30f);
    CHECK(grey.at(0, 1)[2] == 1e30f);
    CHECK(grey.at(2, 0)[1] == -3);
}

TEST_CASE("exposure, colour correction and pixel aspect multiply; indented lines do not count") {
    const Picture p = read(
        "#?RADIANCE\nEXPOSURE=2\nEXPOSURE= 4e0\n\tEXPOSURE=100\nCOLORCORR= 1 2 "
        "4\nPIXASPECT=.5\nPIXASPECT=3\nBigEndian=0\n"
        "FORMAT=float\nNCOMP=3\n\n-Y 1 +X 1\n" +
        floats({8, 8, 8}));
    CHECK(p.rgb == std::vector<float>{1, .5f, .25f});
    CHECK(p.header.exposure == 8);
    CHECK(p.header.pixel_aspect == 1.5);
    CHECK(p.header.tabbed_exposure);
    CHECK(why("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n") == "header line \"EXPOSURE=0\" is not above 0");
    CHECK(why("#?RADIANCE\nCOLORCORR=1 1\n\n-Y 1 +X 1\n") == "header line \"COLORCORR=1 1\" is malformed");
    CHECK(why("#?RADIANCE\nEXPOSURE=1e20\nEXPOSURE=1e20\n\n-Y 1 +X 1\n") ==
          "header line \"EXPOSURE=1e20\": 1e+40 is not within 1e-30 to 1e30");
    for (const char* line : {"EXPOSURE=1e308\nEXPOSURE=1e308", "EXPOSURE=1e-200\nEXPOSURE=1e-200", "PIXASPECT=1e99",
                             "COLORCORR=1 1 1e308"})
        CHECK(why("#?RADIANCE\n" + std::string(line) + "\n\n-Y 1 +X 1\n").find("1e-30 to 1e30") != std::string::npos);
}

// Radiances in memory, exposed pixels in the file: whatever the encoding, reading gives the radiances again.
TEST_CASE("a picture is written with its exposure, and read without") {
    for (double exposure : {4., .3, 1.}) {
        for (Format format : {Format::flt, Format::rgbe, Format::xyze}) {
            Picture p = small_picture(33, 2);
            for (float& v : p.rgb) v = std::fabs(v);
            p.header.exposure = exposure;
            const std::string bytes = image::picture_bytes(p, format);
            const size_t line = bytes.find("\nEXPOSURE=");
            CHECK((line == std::string::npos) == (exposure == 1));
            CHECK((line == std::string::npos || bytes.find("\nEXPOSURE=", line + 1) == std::string::npos));
            const Picture back = read(bytes);
            CHECK(back.header.exposure == exposure);
            REQUIRE(back.rgb.size() == p.rgb.size());
            const double error = format == Format::flt ? 2e-7 : .02;
            for (size_t i = 0; i < p.rgb.size(); i += 3) {
                const double most = std::max({p.rgb[i], p.rgb[i + 1], p.rgb[i + 2]});
                for (size_t k = i; k < i + 3; k++) REQUIRE(std::fabs(back.rgb[k] - p.rgb[k]) <= error * most);
            }
            if (format != Format::flt) continue;
            float first;  // what a viewer sees
            std::memcpy(&first, &bytes[bytes.size() - 4 * p.rgb.size()], 4);
            CHECK(first == doctest::Approx(p.rgb[0] * exposure));
        }
    }
}

TEST_CASE("XYZE is cd/m2, and other primaries keep luminance") {
    const double y_of[3] = {0.265074126, 0.670114631, 0.064811243};
    const image::Matrix3 m = image::rgb_from_xyz(), back = image::xyz_from_radiance_rgb();
    for (int c = 0; c < 3; ++c) CHECK(back[size_t(3 + c)] == doctest::Approx(y_of[c]).epsilon(1e-6));
    // The white point (1,1,1) is Y = 1.
    CHECK(m[0] * .3333 / .3333 + m[1] + m[2] * (.3334 / .3333) == doctest::Approx(1).epsilon(1e-9));

    Picture p = small_picture(20, 2);
    for (size_t i = 0; i < p.rgb.size(); ++i) p.rgb[i] = float(1 + i % 5);
    const Picture q = read(image::picture_bytes(p, Format::xyze));
    for (int x = 0; x < 20; ++x) {
        const auto lum = [&](const float* c) { return y_of[0] * c[0] + y_of[1] * c[1] + y_of[2] * c[2]; };
        CHECK(lum(q.at(x, 1)) == doctest::Approx(lum(p.at(x, 1))).epsilon(.01));
    }
    // sRGB's green alone has luminance .7152 (D65), whatever the target space.
    const Picture srgb = read(
        "#?RADIANCE\nPRIMARIES= .64 .33 .30 .60 .15 .06 .3127 .3290\nBigEndian=0\nNCOMP=3\nFORMAT=float\n\n-Y 1 +X "
        "1\n" +
        floats({0, 1, 0}));
    CHECK(y_of[0] * srgb.rgb[0] + y_of[1] * srgb.rgb[1] + y_of[2] * srgb.rgb[2] ==
          doctest::Approx(.7152).epsilon(1e-3));
}

TEST_CASE("headers as other programs write them") {
    const std::string pixels = "\n-Y 1 +X 1\n\x80\x90\xa0\x81";
    const std::vector<float> plain = read("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + pixels).rgb;
    for (const char* head :
         {// ImageMagick, Photoshop, Poly Haven: zeros state no primaries
          "#?RADIANCE\nSOFTWARE=ImageMagick\nGAMMA=0.454545\nPRIMARIES=0 0 0 0 0 0 0 0\nFORMAT=32-bit_rle_rgbe\n",
          "#?RADIANCE\n# Made with Adobe Photoshop\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\nFORMAT=32-bit_rle_rgbe\n",
          "#?RGBE\nGAMMA=1\nEXPOSURE=          1.0000000000000\n", "rpict -vta -vh 180 -vv 180 room.oct\n", "",
          "VIEW= -vtv -vh 60\r\nFORMAT=32-bit_rle_rgbe\r\n\r", "PRIMARIES= 0 0 0 0 0 0 0 0\n"})
        CHECK_MESSAGE(read(head + pixels).rgb == plain, head);
    CHECK(why("#?RADIANCE\nPRIMARIES=.64 .33 .3 .6 .15 .06 0 0\n" + pixels) ==
          "header line \"PRIMARIES=.64 .33 .3 .6 .15 .06 0 0\" is not a set of chromaticities");
    for (const char* one : {".3 .3 .3 .3 .3 .3 .3 .3", "0 0 0 0 0 0 .33 .33", ".1 .1 .2 .2 .3 .3 .33 .33"})
        CHECK_MESSAGE(
            why("#?RADIANCE\nPRIMARIES=" + std::string(one) + "\n" + pixels).find("is not a set") != std::string::npos,
            one);
    // a frame of an animation (rpict -S) is a picture by itself; a frame of ours has a seed
    const Picture third = read("#?RADIANCE\nFRAME=3\nVIEW= -vtv\nFORMAT=32-bit_rle_rgbe\n" + pixels);
    CHECK_FALSE(third.header.frame);
    CHECK(third.header.lines == std::vector<std::string>{"(FRAME=3)"});
    CHECK(read("#?RADIANCE\nSEED=1\nFRAME=3\nFORMAT=32-bit_rle_rgbe\n" + pixels).header.frame == 3);
}

TEST_CASE("views of a header: later lines override, inputs' lines do not count") {
    const Picture p = read(
        "#?RADIANCE\nrpict -vtv -vp 1 2 3 -vh 60\n\tVIEW= -vth\nVIEW= -vta -vh 180\n\n-Y 1 +X 1\n\x80\x80\x80\x80");
    CHECK(p.header.view->type == 'a');
    CHECK(p.header.view->vp == base::Vec3{1, 2, 3});
    CHECK(p.header.view->vh == 180);
    CHECK_FALSE(read("#?RADIANCE\nhello\n\n-Y 1 +X 1\n\x80\x80\x80\x80").header.view);
}

TEST_CASE("several seeds have their own ranges") {
    image::Header h;
    image::Encoding e;
    for (const char* line : {"SEED=1", "RANGE=0:9", "SEED=2", "RANGE=0:3", "RANGE=8:9"})
        image::parse_header_line(line, h, e, "x");
    CHECK(h.seed == 1);
    CHECK(h.ranges == image::Ranges{{0, 9}});
    CHECK(h.other_seeds.size() == 1);
    CHECK(h.other_seeds[0].second == image::Ranges{{0, 3}, {8, 9}});
    CHECK(why("#?RADIANCE\nRANGE=5:3\n\n") == "header line \"RANGE=5:3\" ends before it begins");
    CHECK(why("#?RADIANCE\nRANGE=0:9\nRANGE=0:9\n\n") ==
          "header line \"RANGE=0:9\": RANGE=0:9 before it holds such frames, too");
    CHECK(why("#?RADIANCE\nSEED=1\nRANGE=0:9\nSEED=2\nRANGE=0:9\nRANGE=4:4\n\n").find("RANGE=0:9 before it") !=
          std::string::npos);
    CHECK(why("#?RADIANCE\nSEED=1\nRANGE=0:9\nSEED=1\nRANGE=10:19\n\n") == "header line \"SEED=1\" comes twice");
    CHECK(why("#?RADIANCE\nFRAME=-1\n\n") == "header line \"FRAME=-1\" is not a whole number from 0");
    CHECK(why("#?RADIANCE\nSEED=12x\n\n") == "header line \"SEED=12x\" is not a whole number from 0");
}

TEST_CASE("header lines stay within RADIANCE's limit and are lines") {
    Picture p = small_picture(1, 1);
    p.header.lines = {"ptrace " + std::string(5000, 'a'), "two\nlines", ""};
    const std::string bytes = image::picture_bytes(p, Format::flt);
    size_t longest = 0, from = 0;
    for (size_t at; (at = bytes.find('\n', from)) != std::string::npos && at != from; from = at + 1)
        longest = std::max(longest, at - from);
    CHECK(longest < 2048);
    CHECK(image::read_file(TempFolder().holding("x", bytes)).width == 1);
    CHECK(bytes.find("two lines\n") != std::string::npos);
}

TEST_CASE("partial sums and single frames are no pictures") {
    Picture p = small_picture(1, 1);
    CHECK(error_text([&] { image::require_complete(p, "x"); }).empty());
    p.header.ranges = {{100, 199}};
    CHECK(error_text([&] { image::require_complete(p, "x"); }) ==
          "x: is a partial sum without frame 0 (RANGE=100:199): merge it with ptaccum first");
    p.header = image::Header();
    p.header.frame = 0;
    CHECK(error_text([&] { image::require_complete(p, "x"); }).empty());
    p.header.frame = 3;
    CHECK(error_text([&] { image::require_complete(p, "x"); }) ==
          "x: is single frame 3, not a picture of the scene: sum the frames with ptaccum first");
}

TEST_CASE("sizes are checked before memory is taken") {
    CHECK(why(rgbe_head + "-Y 32769 +X 1\n") == "picture size 32769 is not within 1..32768");
    CHECK(why(rgbe_head + "-Y 0 +X 1\n") == "picture size 0 is not within 1..32768");
    CHECK(why(rgbe_head + "-Y -5 +X 1\n") == "picture size -5 is not within 1..32768");
    // 32768 x 32768 floats would be 12 GiB; the file is 100 bytes.
    CHECK(why("#?RADIANCE\nFORMAT=float\nNCOMP=3\n\n-Y 32768 +X 32768\n" + std::string(100, 'x'))
              .find("input ends inside the picture") == 0);
    CHECK(why(rgbe_head + "-Y 32768 +X 32768\n" + std::string(200000, 'x')).find("input ends inside the picture") == 0);
    CHECK(why("#?RADIANCE\nNCOMP=99999999999\n\n") == "header line \"NCOMP=99999999999\" is out of range");
    CHECK(why("#?RADIANCE\nFORMAT=float\nNCOMP=24\n\n-Y 1 +X 1\n") == "NCOMP=24: float pictures have 1 or 3 channels");
}

TEST_CASE("input that is not a picture is reported as such") {
    CHECK(why("P6 5 5") == "is not a RADIANCE picture (it does not begin with #?)");
    CHECK(why("") == "holds no picture");
    CHECK(why("#?RADIANCE\nFORMAT=ascii\n\n").find("this pixel format is not read") != std::string::npos);
    CHECK(why(rgbe_head + "-Y 5 +Y 5\n") == "\"-Y 5 +Y 5\" is not a resolution line such as -Y 512 +X 512");
    CHECK(why(rgbe_head + "-Y 5 +X\n") == "\"-Y 5 +X\" is not a resolution line such as -Y 512 +X 512");
    CHECK(why("#?RADIANCE\n" + std::string(70000, 'a')) == "a header line is longer than 65536 characters");
    std::string endless = "#?RADIANCE\n";
    for (int i = 0; i < 30000; ++i) endless += std::string(50, 'a') + "\n";
    CHECK(why(endless) == "the header is longer than 1 MiB");
    const std::string good = image::picture_bytes(small_picture(2, 2), Format::flt);
    TempFolder temp;
    const std::string path = temp.holding("two.hdr", good + "rubbish");
    StreamReader in(path);
    Picture p;
    CHECK(in.next(p));
    CHECK(error_text([&] { in.next(p); }) ==
          path + ": picture 2: what follows is not a picture (it does not begin with #?)");
}

TEST_CASE("a picture cut anywhere is an error, never a picture") {
    Picture p = small_picture(20, 3);
    for (const Format f : {Format::flt, Format::rgbe}) {
        const std::string bytes = image::picture_bytes(p, f);
        TempFolder temp;
        for (size_t n = 1; n < bytes.size(); ++n) {
            const std::string text = error_text([&] { image::read_file(temp.holding("cut.hdr", bytes.substr(0, n))); });
            CHECK_MESSAGE(!text.empty(), n);
            if (text.empty()) break;
        }
    }
}

TEST_CASE("bent bytes give an error or a picture, never anything else") {
    const std::string bytes = image::picture_bytes(small_picture(20, 3), Format::rgbe);
    uint32_t state = 1;  // a fixed sequence (Numerical Recipes' LCG)
    const auto next = [&] { return state = state * 1664525u + 1013904223u; };
    TempFolder temp;
    const std::string path = temp.name("bent.hdr");
    for (int i = 0; i < 1000; ++i) {
        std::string bent = bytes;
        for (uint32_t k = 0; k <= next() >> 30; ++k) bent[(next() >> 8) % bent.size()] = char(next() >> 24);
        std::ofstream(path, std::ios::binary) << bent;
        Picture p;
        const std::string text = error_text([&] {
            StreamReader in(path);
            while (in.next(p)) {}
        });
        if (text.empty()) CHECK(p.rgb.size() == 3 * size_t(p.width) * size_t(p.height));
    }
}
