#include "device/device_choice.h"

#include "device/backends.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <exception>
#include <iterator>
#include <optional>
#include <string>

namespace zonegrid::device {

namespace {

void append_backend(DeviceList (*list)(), DeviceList& all) {
    try {
        const DeviceList found = list();
        all.devices.insert(all.devices.end(), found.devices.begin(), found.devices.end());
        all.missing.insert(all.missing.end(), found.missing.begin(), found.missing.end());
    } catch (const std::exception& error) {
        all.missing.emplace_back(error.what());
    }
}

/// "opencl:1" -> "opencl" and 1; "opencl" -> no index. Nothing if it is neither.
struct DeviceName {
    std::string_view backend;
    std::optional<std::uint32_t> index;
};

std::optional<DeviceName> parse_name(std::string_view name) {
    DeviceName parsed;
    const auto colon = name.find(':');
    parsed.backend = name.substr(0, colon);
    if (parsed.backend != "opencl" && parsed.backend != "vulkan") {
        return std::nullopt;
    }
    if (colon != std::string_view::npos) {
        const auto digits = name.substr(colon + 1);
        std::uint32_t index = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc{} || end != digits.data() + digits.size()) {
            return std::nullopt;
        }
        parsed.index = index;
    }
    return parsed;
}

void require_usable(const DeviceInfo& info) {
    if (!info.refusal.empty()) {
        throw DeviceError(info.id(),
                          info.name + " (" + info.driver + ") is refused: " + info.refusal,
                          "choose another device");
    }
}

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return small;
}

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The devices that have `wanted` in their names; where it is the whole name of some, only those.
std::vector<DeviceInfo> with_name(const std::vector<DeviceInfo>& devices, std::string_view wanted) {
    const std::string part = in_small_letters(wanted);
    std::vector<DeviceInfo> found;
    std::ranges::copy_if(devices, std::back_inserter(found), [&](const DeviceInfo& info) {
        return in_small_letters(info.name).find(part) != std::string::npos;
    });
    std::vector<DeviceInfo> whole;
    std::ranges::copy_if(found, std::back_inserter(whole), [&](const DeviceInfo& info) {
        return in_small_letters(info.name) == part;
    });
    return whole.empty() ? found : whole;
}

int rank_of(const DeviceInfo& info) {
    if (info.type == "discrete GPU") {
        return 0;
    }
    return info.type.ends_with("GPU") ? 1 : 2;
}

} // namespace

DeviceList list_devices() {
    DeviceList all;
    append_backend(&list_opencl_devices, all);
    append_backend(&list_vulkan_devices, all);
    return all;
}

DeviceList list_devices(std::string_view backend) {
    DeviceList list;
    append_backend(backend == "opencl" ? &list_opencl_devices : &list_vulkan_devices, list);
    return list;
}

std::string describe_devices(const DeviceList& list) {
    std::vector<std::string> found;
    found.reserve(list.devices.size() + list.missing.size());
    for (const auto& info : list.devices) {
        found.push_back(fmt::format("{} ({}, {}{})", info.id(), info.name, info.driver,
                                    info.refusal.empty() ? "" : ", refused: " + info.refusal));
    }
    found.insert(found.end(), list.missing.begin(), list.missing.end());
    return found.empty() ? "nothing" : fmt::format("{}", fmt::join(found, "; "));
}

DeviceInfo find_device(std::string_view name) {
    const auto wanted = parse_name(name);
    if (!wanted) {
        throw UsageError(
            fmt::format("device \"{}\": name a backend, opencl or vulkan, and, if you "
                        "like, which of its devices: opencl:1",
                        name));
    }
    const DeviceList list = list_devices(wanted->backend);
    const auto chosen = std::ranges::find_if(list.devices, [&](const DeviceInfo& info) {
        return wanted->index ? info.index == *wanted->index : info.refusal.empty();
    });
    if (chosen == list.devices.end()) {
        throw DeviceError(std::string(name), "there is no such device, or none that can be used",
                          "found: " + describe_devices(list));
    }
    require_usable(*chosen);
    return *chosen;
}

DeviceInfo choose_device(const DeviceList& list, std::string_view backend,
                         std::string_view wanted) {
    DeviceList offered{{}, list.missing};
    std::ranges::copy_if(
        list.devices, std::back_inserter(offered.devices),
        [&](const DeviceInfo& info) { return backend.empty() || info.backend == backend; });
    std::string id(wanted);
    if (is_number(wanted)) {
        if (backend.empty()) {
            throw UsageError(fmt::format(
                "device {0}: a number counts within a backend; give the backend too, as "
                "in opencl:{0}; found: {1}",
                wanted, describe_devices(offered)));
        }
        id = fmt::format("{}:{}", backend, wanted);
    }
    const auto with_id = std::ranges::find(offered.devices, id, &DeviceInfo::id);
    auto found = with_id == offered.devices.end() ? with_name(offered.devices, id)
                                                  : std::vector<DeviceInfo>{*with_id};
    if (found.empty()) {
        throw DeviceError(fmt::format("device {}", id),
                          "there is none with this number, id or part of its name",
                          "found: " + describe_devices(offered));
    }
    std::ranges::stable_partition(found,
                                  [](const DeviceInfo& info) { return info.refusal.empty(); });
    require_usable(found.front());
    if (found.size() > 1 && found[1].refusal.empty()) {
        std::erase_if(found, [](const DeviceInfo& info) { return !info.refusal.empty(); });
        throw UsageError(
            fmt::format("device {}: several have this in their names; give more of the "
                        "name, the backend, or the id; found: {}",
                        wanted, describe_devices({found, {}})));
    }
    return found.front();
}

std::vector<DeviceInfo> usable_devices(const DeviceList& list) {
    std::vector<DeviceInfo> usable;
    std::ranges::copy_if(list.devices, std::back_inserter(usable),
                         [](const DeviceInfo& info) { return info.refusal.empty(); });
    std::ranges::stable_sort(usable, {}, rank_of);
    return usable;
}

} // namespace zonegrid::device
