// SPDX-License-Identifier: BSD-3-Clause
// Embree 3 or 4, whichever CMake found; the few calls that differ are guarded by RTC_VERSION_MAJOR where they are made.
#pragma once
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <memory>
#include <string>
#include "base/error.h"

namespace trace {

// An Embree device that turns Embree's errors into ours: call check() after builds.
class EmbreeDevice {
public:
    EmbreeDevice() : device_(rtcNewDevice(nullptr)) {
        if (!device_) throw base::Error(base::Kind::system, "Embree", "no device");
        rtcSetDeviceErrorFunction(device_, [](void* self, RTCError, const char* text) {
            static_cast<EmbreeDevice*>(self)->error_ = text && *text ? text : "unknown error";
        }, this);
    }
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;
    ~EmbreeDevice() { rtcReleaseDevice(device_); }
    operator RTCDevice() const { return device_; }
    void check() const {
        if (!error_.empty()) throw base::Error(base::Kind::system, "Embree", error_);
    }
private:
    RTCDevice device_;
    std::string error_;
};

}  // namespace trace
