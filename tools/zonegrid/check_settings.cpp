#include "check_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace zonegrid {
namespace {

constexpr std::array<std::string_view, 2> only_generated{"cases", "output"};
constexpr std::array<std::string_view, 6> also_generated{"generated", "cases",  "output",
                                                         "backend",   "device", "against"};

bool is_seed(const std::string& text) {
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed);
    return error == std::errc{} && stop == end;
}

Rule<int> from_one(const char* words) {
    return {[](int value) { return value >= 1; }, words};
}

} // namespace

void add_check_settings(SettingTable& table, CheckSettings& settings) {
    add_mapping_settings(table, settings.map);
    table.start_group("Check");
    table.add(bind_setting(
        "against", "NAME", "backend whose map is expected: reference, opencl:0, ...",
        settings.against, {is_backend_name, "reference, opencl, vulkan, or one device"}));
    table.add(bind_setting("every", "N",
                           "compare cells, objects and profile after every N-th image and the last",
                           settings.every, from_one("a number of images, 1 or more")));
    table.add(bind_setting("generated", "SEED",
                           "in place of a recording: random flights from this whole number",
                           settings.seed, {is_seed, "a whole number, 0 or more"}));
    table.add(bind_setting("cases", "N", "how many generated flights", settings.cases,
                           from_one("a number of flights, 1 or more")));
    Setting output = bind_setting(
        "output", "DIR",
        "folder for the first generated flight that differs, else zonegrid-case-SEED-NUMBER",
        settings.output,
        {[](const std::string& text) { return !text.empty(); }, "the name of the folder to make"});
    output.short_name = "o";
    table.add(std::move(output));
}

void require_consistent(const CheckSettings& settings, const std::vector<std::string>& given) {
    for (const std::string& name : given) {
        if (settings.seed && name == "recording") {
            throw UsageError("RECORDING and --generated exclude each other: give one of them");
        }
        if (settings.seed && std::ranges::find(also_generated, name) == also_generated.end()) {
            throw UsageError(fmt::format(
                "--{} does not go with --generated: each flight brings its own; leave it out",
                name));
        }
        if (!settings.seed && std::ranges::find(only_generated, name) != only_generated.end()) {
            throw UsageError(
                fmt::format("--{} goes with --generated SEED only: leave it out", name));
        }
    }
    if (!settings.seed && !settings.map.source.recording) {
        throw UsageError("RECORDING is missing: name a folder, or give --generated SEED");
    }
}

std::string expected_map(const CheckSettings& settings) {
    return settings.against == "reference" ? "the reference's map"
                                           : "the map of " + settings.against;
}

} // namespace zonegrid
