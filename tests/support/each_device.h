#pragma once

#include "device/device.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid {

/// The usable devices of a backend.
[[nodiscard]] std::vector<device::DeviceInfo> usable_devices(const std::string& backend);

/// Runs once a backend. Where the machine has no device of it, the test fails, unless the build
/// allows missing devices (-D ZONEGRID_ALLOW_MISSING_DEVICES=ON); then it says that it is skipped.
class EachDevice : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override;

    /// Calls `body(std::unique_ptr<device::Device>)` with each usable device in turn, opened twice
    /// if it shares its memory with the host: once as it is, once as if it did not.
    template <class Body>
    void for_each_device(const Body& body, bool timestamps = false) const {
        for (const auto& info : devices_) {
            for (const bool unified_memory : {true, false}) {
                SCOPED_TRACE(describe(info) + (unified_memory ? "" : ", with copies"));
                if (unified_memory || info.limits.unified_memory) {
                    body(device::open_device(info.id(), {timestamps, unified_memory}));
                }
            }
        }
    }

    [[nodiscard]] const std::vector<device::DeviceInfo>& devices() const { return devices_; }

    /// "opencl:0, NAME, DRIVER".
    static std::string describe(const device::DeviceInfo& info);

private:
    std::vector<device::DeviceInfo> devices_;
};

/// Names a test after its backend.
inline std::string backend_name(const testing::TestParamInfo<const char*>& info) {
    return info.param;
}

} // namespace zonegrid
