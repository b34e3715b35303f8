#include "support/each_device.h"

#include <iostream>

namespace zonegrid {

namespace {

#ifdef ZONEGRID_ALLOW_MISSING_DEVICES
constexpr bool allow_missing = true;
#else
constexpr bool allow_missing = false;
#endif

std::string explain_missing() {
    std::string text;
    const auto list = device::list_devices();
    for (const auto& info : list.devices) {
        text += info.refusal.empty() ? "" : info.id() + " is refused: " + info.refusal + "\n";
    }
    for (const auto& sentence : list.missing) {
        text += sentence + "\n";
    }
    return text;
}

} // namespace

std::vector<device::DeviceInfo> usable_devices(const std::string& backend) {
    std::vector<device::DeviceInfo> usable;
    for (auto& info : device::list_devices().devices) {
        if (info.backend == backend && info.refusal.empty()) {
            usable.push_back(std::move(info));
        }
    }
    return usable;
}

void EachDevice::SetUp() {
    devices_ = usable_devices(GetParam());
    if (devices_.empty() && allow_missing) {
        GTEST_SKIP() << "no device of " << GetParam() << "\n" << explain_missing();
    }
    ASSERT_FALSE(devices_.empty()) << "no device of " << GetParam() << "\n" << explain_missing();
    for (const auto& info : devices_) {
        std::cout << "on " << describe(info) << "\n";
    }
}

std::string EachDevice::describe(const device::DeviceInfo& info) {
    return info.id() + ", " + info.name + ", " + info.driver;
}

} // namespace zonegrid
