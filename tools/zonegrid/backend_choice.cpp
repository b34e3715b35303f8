#include "backend_choice.h"

#include "device/device_choice.h"
#include "io/device_check.h"

#include <fmt/format.h>

namespace zonegrid {
namespace {

BackendChoice choose_automatically() {
    BackendChoice choice;
    const device::DeviceList list = device::list_devices();
    for (const auto& info : device::usable_devices(list)) {
        const SelfTest test = test_backend(info.id());
        if (test.passed()) {
            choice.backend = info.id();
            choice.device = info;
            choice.reason += fmt::format("{} ({}, {}) makes the reference's map in the self-test",
                                         info.id(), info.name, info.type);
            return choice;
        }
        choice.reason +=
            fmt::format("{} ({}) fails the self-test: {}; ", info.id(), info.name, test.problem);
    }
    choice.reason += fmt::format("no device passes, so the reference computes; found: {}",
                                 device::describe_devices(list));
    return choice;
}

device::DeviceInfo find_wanted(const std::string& backend, const std::string& wanted) {
    if (backend == "auto") {
        throw UsageError(
            "--backend auto chooses the device itself: leave out --device, or name a "
            "backend");
    }
    if (backend.find(':') != std::string::npos) {
        throw UsageError(fmt::format(
            "--backend {} names a device already: leave out --device, or the number", backend));
    }
    if (backend == "reference") { // the default, which needs no device: any backend will do
        return device::choose_device(device::list_devices(), "", wanted);
    }
    return device::choose_device(device::list_devices(backend), backend, wanted);
}

} // namespace

BackendChoice choose_backend(const MapSettings& settings) {
    const std::string& backend = settings.mapper.backend;
    BackendChoice choice;
    if (settings.device) {
        choice.device = find_wanted(backend, *settings.device);
    } else if (backend == "auto") {
        choice = choose_automatically();
    } else if (backend != "reference") {
        choice.device = device::find_device(backend);
    }
    if (choice.device) {
        choice.backend = choice.device->id();
    }
    choice.asked =
        settings.device ? fmt::format("{}, device {}", backend, *settings.device) : backend;
    return choice;
}

nlohmann::ordered_json backend_json(const BackendChoice& choice) {
    nlohmann::ordered_json json;
    json["asked"] = choice.asked;
    json["used"] = choice.backend;
    json["reason"] = choice.reason;
    json["device"] = nullptr;
    if (choice.device) {
        json["device"] = {{"name", choice.device->name},
                          {"type", choice.device->type},
                          {"driver", choice.device->driver},
                          {"api", choice.device->api}};
    }
    return json;
}

} // namespace zonegrid
