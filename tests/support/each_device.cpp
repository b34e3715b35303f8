#include "support/each_device.h"

#include <iostream>

#ifdef __SANITIZE_ADDRESS__
/// What drivers leak is not ours to mend: rusticl keeps 72 bytes when its platform is looked at.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libRusticlOpenCL\n";
}
#endif

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
