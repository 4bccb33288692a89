// SPDX-License-Identifier: BSD-3-Clause
// Embree 3 or 4, whichever CMake found; the few calls that differ are guarded by RTC_VERSION_MAJOR where they are made.
#pragma once
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <new>
#include <string>
#include "base/error.h"
#include "base/processors.h"
#include "base/threads.h"

namespace bvh {

// An Embree device that turns Embree's errors into ours: call check() after builds.
class EmbreeDevice {
public:
    EmbreeDevice() : device_(rtcNewDevice(threads().c_str())) {
        const RTCError why = device_ ? RTC_ERROR_NONE : rtcGetDeviceError(nullptr);
        if (why == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
        if (why == RTC_ERROR_UNSUPPORTED_CPU)
            throw base::Error(base::Kind::system, "Embree", "does not know this processor");
        if (!device_) throw base::Error(base::Kind::system, "Embree", "does not start");
        rtcSetDeviceErrorFunction(
            device_,
            [](void* self, RTCError, const char* text) {
                static_cast<EmbreeDevice*>(self)->error_ = text && *text ? text : "unknown error";
            },
            this);
    }
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;
    ~EmbreeDevice() { rtcReleaseDevice(device_); }
    operator RTCDevice() const { return device_; }
    void check() const {
        if (!error_.empty()) throw base::Error(base::Kind::system, "Embree", error_);
    }

private:
    // Embree ends the program where a thread cannot be started; so it is asked for no more than there can be.
    static std::string threads() { return "threads=" + std::to_string(base::available_threads(base::processors())); }
    RTCDevice device_;
    std::string error_;
};

}  // namespace bvh
