// SPDX-License-Identifier: BSD-3-Clause
// Reading: see exr_file.h.
#include "image/exr_file.h"

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <sstream>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/open_file.h"
#include "image/exr_parts.h"
#include "image/header.h"

namespace image {

// A file by its descriptor, so that it is opened once and by base::open_file().
class DescriptorIn : public Imf::IStream {
public:
    DescriptorIn(const std::string& path, const base::Opener& by)
        : Imf::IStream(path.c_str()), fd_(base::open_file(path, by)) {}
    ~DescriptorIn() override { base::close_descriptor(fd_); }
    bool read(char to[], int n) override {
        for (int done = 0; done < n;) {
            const ssize_t got = base::read_at(fd_, to + done, size_t(n - done), at_);
            if (got < 0) base::fail_system(fileName(), "cannot be read");
            if (got == 0) throw Iex::InputExc("the file ends too early");
            done += int(got), at_ += uint64_t(got);
        }
        return true;  // there may be more
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t pos) override { at_ = pos; }
    uint64_t size() const {
        const base::FileStatus info = base::status_of(fd_);
        if (info.kind == base::FileKind::none) base::fail_system(fileName(), "cannot be read");
        return info.stamp.size;
    }

private:
    int fd_;
    uint64_t at_ = 0;
};

struct ExrInput::File {
    DescriptorIn bytes;
    Imf::MultiPartInputFile parts;  // reads headers only
    Imf::InputPart in;
    File(const std::string& path, const base::Opener& by)
        : bytes(path, by), parts(checked(bytes, path)), in((check_blocks(parts.header(0), path), parts), 0) {}

private:
    static Imf::IStream& checked(DescriptorIn& bytes, const std::string& path) {
        check_attributes(bytes, bytes.size(), path);
        bytes.seekg(0);
        return bytes;
    }
};

ExrInput::ExrInput(const std::string& path, const base::Opener& by) : path_(path) {
    Imf::Header::setMaxImageSize(most_side, most_side);  // before OpenEXR reserves anything
    Imf::Header::setMaxTileSize(most_side, most_side);
    try {
        file_.reset(new File(path, by));
        const Imath::Box2i shown = file_->in.header().displayWindow();
        const int64_t w = int64_t(shown.max.x) - shown.min.x + 1, h = int64_t(shown.max.y) - shown.min.y + 1;
        if (w < 1 || h < 1 || w > most_side || h > most_side)
            base::fail(path, "picture size is not within 1.." + std::to_string(most_side));
        width_ = int(w);
        height_ = int(h);
        check_windows(file_->in.header(), path);
        if (file_->parts.parts() > 1)
            base::warn(path, "holds " + std::to_string(file_->parts.parts()) + " parts: the first one is read");
    } catch (const base::Error&) {
        throw;
    } catch (const std::exception& e) {
        base::fail(path, "is not a readable OpenEXR file: " + one_line(e.what()));
    }
}

ExrInput::~ExrInput() = default;

std::vector<std::string> ExrInput::channels() const {
    std::vector<std::string> names;
    const Imf::ChannelList& list = file_->in.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) names.push_back(c.name());
    return names;
}

bool ExrInput::has(const std::string& channel) const {
    return file_->in.header().channels().findChannel(channel) != nullptr;
}

template <class T>
std::vector<T> ExrInput::read_as(const std::vector<std::string>& names) const {
    constexpr bool whole = std::is_same_v<T, uint32_t>;
    const size_t n = names.size();
    std::vector<T> out;
    try {
        const Imf::Header& header = file_->in.header();
        for (const std::string& name : names) {
            const Imf::Channel* c = header.channels().findChannel(name);
            if (!c) base::fail(path_, "has no channel " + name);
            if (c->xSampling != 1 || c->ySampling != 1)
                base::fail(path_, "channel " + name + " is subsampled: not read");
            if (whole && c->type != Imf::UINT) base::fail(path_, "channel " + name + " is not of whole numbers");
        }
        const Imath::Box2i shown = header.displayWindow(), data = header.dataWindow();
        const size_t data_width = size_t(data.max.x - data.min.x + 1);
        const int lines = int(
            std::clamp<int64_t>(most_block / int64_t(sizeof(T) * std::max<size_t>(n, 1) * data_width), 1, block_lines));
        std::vector<T> block(data_width * size_t(lines) * n);
        for (int y = data.min.y; y <= data.max.y; y += lines) {
            const int last = std::min(y + lines - 1, data.max.y);
            Imf::FrameBuffer frame;
            for (size_t c = 0; c < n; ++c) {
                // OpenEXR expects the address that pixel (0,0) would have
                char* origin = reinterpret_cast<char*>(block.data() + c) -
                               ptrdiff_t(sizeof(T) * n) * (data.min.x + ptrdiff_t(data_width) * y);
                frame.insert(names[c], Imf::Slice(whole ? Imf::UINT : Imf::FLOAT, origin, sizeof(T) * n,
                                                  sizeof(T) * n * data_width));
            }
            file_->in.setFrameBuffer(frame);
            file_->in.readPixels(y, last);
            const int top = std::max(y, shown.min.y), bottom = std::min(last, shown.max.y);
            const int left = std::max(data.min.x, shown.min.x), right = std::min(data.max.x, shown.max.x);
            for (int row = top; row <= bottom && left <= right; ++row) {
                const T* from = &block[n * (size_t(row - y) * data_width + size_t(left - data.min.x))];
                const size_t at = n * (size_t(row - shown.min.y) * width_ + size_t(left - shown.min.x));
                if (out.size() < at + n * width_) out.resize(at + n * width_);
                std::copy(from, from + n * size_t(right - left + 1), &out[at]);
            }
        }
        out.resize(n * width_ * size_t(height_));
    } catch (const base::Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        base::fail(path_, "is a broken OpenEXR file: " + one_line(e.what()));
    }
    return out;
}

std::vector<float> ExrInput::read(const std::vector<std::string>& names) const { return read_as<float>(names); }

std::vector<uint32_t> ExrInput::read_whole(const std::vector<std::string>& names) const {
    return read_as<uint32_t>(names);
}

std::map<std::string, std::string> ExrInput::texts() const {
    std::map<std::string, std::string> all;
    const Imf::Header& h = file_->in.header();
    for (auto a = h.begin(); a != h.end(); ++a)
        if (const auto* s = dynamic_cast<const Imf::StringAttribute*>(&a.attribute())) all[a.name()] = s->value();
    return all;
}

std::optional<std::string> ExrInput::text(const std::string& attribute) const {
    const auto all = texts();
    const auto found = all.find(attribute);
    if (found == all.end()) return std::nullopt;
    return found->second;
}

Header ExrInput::header() const {
    Header h;
    Encoding unused;
    if (const auto lines = text("radianceHeader")) {
        std::istringstream in(*lines);
        for (std::string line; std::getline(in, line);) parse_header_line(line, h, unused, path_);
    } else {
        for (const auto& [name, value] : texts()) {
            view::View v;
            if ((name == "VIEW" || name == "view") && view::parse_line(v, "VIEW=" + value)) h.view = v;
            else if (!name.empty() && value.find('\n') == std::string::npos) add_history(h, name + "=" + value);
        }
        h.pixel_aspect = 1 / std::max(1e-6f, file_->in.header().pixelAspectRatio());
    }
    h.exposure = 1;  // the pixels carry no exposure
    return h;
}

double ExrInput::white_luminance() const {
    const Imf::Header& h = file_->in.header();
    return Imf::hasWhiteLuminance(h) && Imf::whiteLuminance(h) > 0 ? Imf::whiteLuminance(h) : lumens_per_watt;
}

Primaries ExrInput::primaries() const {
    const Imf::Header& h = file_->in.header();
    if (!Imf::hasChromaticities(h) && text("radianceHeader")) return radiance_primaries;
    const auto of = [](const Imf::Chromaticities& c) {
        return Primaries{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y};
    };
    const Primaries rec709 = of(Imf::Chromaticities());  // as the documentation of OpenEXR has it
    const Primaries stated = Imf::hasChromaticities(h) ? of(Imf::chromaticities(h)) : rec709;
    if (stated == Primaries{}) return rec709;
    if (!are_primaries(stated)) base::fail(path_, "its chromaticities are not those of three primaries");
    return stated;
}

}  // namespace image
