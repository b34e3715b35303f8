#include "command.h"
#include "device/device.h"
#include "io/json_text.h"
#include "standard_output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* description =
    "Lists the devices that maps can be made on: OpenCL's and Vulkan's, what each allows, why one "
    "is\n"
    "refused, and which loaders or drivers are missing.";

constexpr const char* help_footer =
    "The id in the first column is what zonegrid map --backend and --device take; --device also\n"
    "takes a part of the name beside it. The reference needs no device.\n"
    "\n"
    "Examples:\n"
    "  zonegrid devices\n"
    "  zonegrid map flight1 -o out/flight1 --backend vulkan:0\n"
    "\n";

std::string mebibytes(std::uint64_t bytes) {
    return fmt::format("{} MiB", bytes >> 20U);
}

std::string text_of(const device::DeviceInfo& info) {
    const auto& limits = info.limits;
    std::string text = fmt::format("{}  {} ({})\n    {}, {}\n", info.id(), info.name, info.type,
                                   info.api, info.driver);
    text += fmt::format(
        "    memory {}{}, largest buffer {}, work-groups up to {} items with {} "
        "KiB, {} buffers a kernel{}\n",
        mebibytes(limits.memory_bytes), limits.unified_memory ? " shared with the host" : "",
        mebibytes(limits.buffer_bytes), limits.group_items, limits.local_bytes >> 10U,
        limits.kernel_buffers, limits.timestamps ? "" : ", no timestamps");
    if (!info.refusal.empty()) {
        text += fmt::format("    refused: {}\n", info.refusal);
    }
    return text;
}

std::string text_of(const device::DeviceList& list) {
    std::string text;
    for (const auto& info : list.devices) {
        text += text_of(info);
    }
    for (const auto& sentence : list.missing) {
        text += fmt::format("missing: {}\n", sentence);
    }
    return text.empty() ? "no devices; the reference backend needs none\n" : text;
}

Json json_of(const device::DeviceInfo& info) {
    const auto& limits = info.limits;
    Json json;
    json["id"] = info.id();
    json["name"] = info.name;
    json["type"] = info.type;
    json["driver"] = info.driver;
    json["api"] = info.api;
    json["usable"] = info.refusal.empty();
    json["refusal"] = info.refusal;
    json["memory_bytes"] = limits.memory_bytes;
    json["unified_memory"] = limits.unified_memory;
    json["buffer_bytes"] = limits.buffer_bytes;
    json["group_items"] = limits.group_items;
    json["local_bytes"] = limits.local_bytes;
    json["kernel_buffers"] = limits.kernel_buffers;
    json["timestamps"] = limits.timestamps;
    return json;
}

Json json_of(const device::DeviceList& list) {
    Json json;
    json["devices"] = Json::array();
    for (const auto& info : list.devices) {
        json["devices"].push_back(json_of(info));
    }
    json["missing"] = list.missing;
    return json;
}

} // namespace

void add_devices_command(CLI::App& app) {
    const auto as_json = std::make_shared<bool>(false);
    CLI::App* const devices_app = app.add_subcommand("devices", description);
    devices_app->add_flag("--json", *as_json, "print JSON");
    devices_app->footer(std::string(help_footer) + exit_codes);
    devices_app->callback([as_json] {
        const auto list = device::list_devices();
        write_standard_output(*as_json ? json_text(json_of(list)) : text_of(list));
    });
}

} // namespace zonegrid
