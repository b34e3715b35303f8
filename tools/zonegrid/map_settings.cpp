#include "map_settings.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace zonegrid {
namespace {

// With samples up to this long after an image at hand, the mapper, which keeps 10 s of them, still
// has those this long before it.
constexpr double longest_gap_s = 5.0;

/// "A:B", "A:" or ":B", frames A ... B - 1.
std::optional<FrameSpan> parse_span(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
        return std::nullopt;
    }
    FrameSpan span;
    const auto read = [](std::string_view digits, std::size_t& value) {
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return digits.empty() || (error == std::errc{} && stop == digits.data() + digits.size());
    };
    if (!read(text.substr(0, colon), span.first) || !read(text.substr(colon + 1), span.last) ||
        span.first >= span.last) {
        return std::nullopt;
    }
    return span;
}

Rule<double> length_rule(const char* words) {
    return finite_where([](double value) { return value > 0.0; }, words);
}

Rule<int> whole_rule(int low, int high, std::string words) {
    return {[low, high](int value) { return value >= low && value <= high; }, std::move(words)};
}

void add_grid_settings(SettingTable& table, MapSettings& settings) {
    MapperOptions& mapper = settings.mapper;
    table.start_group("Grid");
    table.add(bind_setting("cell", "M", "edge of a cell, metres", mapper.cell_m,
                           length_rule("a length above 0 in metres")));
    table.add(bind_setting("range", "M",
                           "distance along the ray up to which images say something, metres",
                           mapper.range_m, length_rule("a distance above 0 in metres")));
    table.add(bind_setting(
        "zone", "CELLS", "edge of a zone, the unit of memory: 8, 16 or 32 cells", mapper.zone,
        {[](int value) { return value == 8 || value == 16 || value == 32; }, "8, 16 or 32 cells"}));
    table.add(bind_setting(
        "model", "NAME",
        "line: a pixel is its axis; span: its pyramid, obstacles spread over the stereo noise",
        settings.model, one_of({"line", "span"})));
    table.add(bind_setting(
        "span-sigmas", "N", "spread of an obstacle in standard deviations, span model only",
        mapper.span_sigmas,
        finite_where([](double value) { return value >= 0.0; }, "a number, 0 or more")));
}

void add_backend_settings(SettingTable& table, MapSettings& settings) {
    table.start_group("Backend");
    table.add(bind_setting(
        "backend", "NAME",
        "how to compute: reference, opencl, vulkan, one device such as opencl:0, or auto: the "
        "first "
        "device that passes a self-test, GPUs first, else the reference",
        settings.mapper.backend,
        {[](const std::string& name) { return name == "auto" || is_backend_name(name); },
         "reference, opencl, vulkan, auto, or one device, such as opencl:0"}));
    table.add(bind_setting(
        "device", "NAME",
        "which device: its number with --backend opencl or vulkan, its id, or a part of its name; "
        "zonegrid devices lists them",
        settings.device,
        {[](const std::string& text) { return !text.empty(); },
         "a device's number, id or a part of its name"}));
    table.add(bind_setting(
        "device-memory", "MB", "most memory of the device to take, megabytes (2^20 bytes)",
        settings.device_memory,
        finite_where([](double value) { return value > 0.0 && value < 0x1.0p40; },
                     "a number of megabytes above 0")));
    table.add(switch_setting("copy-memory",
                             "copy to and from a device that shares the processor's memory, where "
                             "its driver shares it wrongly",
                             settings.copy_memory));
}

void add_fusion_settings(SettingTable& table, MapSettings& settings) {
    constexpr int most = 127;
    MapperOptions& mapper = settings.mapper;
    const std::string in_limit = "a whole number from 1 to limit";
    table.start_group("Fusion");
    table.add(bind_setting("hit", "N", "added to a cell that an image says is occupied", mapper.hit,
                           whole_rule(1, most, in_limit)));
    table.add(bind_setting("miss", "N", "taken from a cell that an image says is free", mapper.miss,
                           whole_rule(1, most, in_limit)));
    table.add(bind_setting("limit", "N", "cells saturate at -limit and +limit", mapper.limit,
                           whole_rule(1, most, "a whole number from 1 to 127")));
    table.add(bind_setting("threshold", "N", "a cell is occupied from this value on",
                           mapper.threshold, whole_rule(1, most, in_limit)));
}

void add_replay_settings(SettingTable& table, MapSettings& settings) {
    table.start_group("Replay");
    table.add(bind_setting("frames", "A:B",
                           "map only frames A to B - 1, counted from 0; either may be left out",
                           settings.frames,
                           {[](const std::string& text) { return parse_span(text).has_value(); },
                            "A:B with whole numbers and A below B, such as 0:100"}));
    table.add(max_gap_setting(settings.mapper.max_gap_s));
}

void add_output_settings(SettingTable& table, MapSettings& settings) {
    table.start_group("Output");
    Setting output = bind_setting(
        "output", "DIR", "folder to make for the map", settings.output,
        {[](const std::string& text) { return !text.empty(); }, "the name of the folder to make"});
    output.short_name = "o";
    table.add(std::move(output));
    table.add(switch_setting("history",
                             "also write history.zgrid: what was last known of every cell ever in "
                             "the window, and since when",
                             settings.history));
    table.add(switch_setting("overwrite", "replace DIR if it holds a map", settings.overwrite));
    table.add(bind_setting("cut-height", "M",
                           "leave cells higher than this above the origin out of the pictures, "
                           "metres",
                           settings.cut_height,
                           finite_where([](double) { return true; }, "a height in metres")));
    table.add(switch_setting("json", "print the report in place of the summary", settings.json));
    table.add(switch_setting("quiet", "print neither summary nor progress", settings.quiet));
}

} // namespace

MapSettings::MapSettings() {
    mapper.cell_m = 0.1;
    mapper.range_m = 40.0;
}

void add_mapping_settings(SettingTable& table, MapSettings& settings) {
    add_recording_settings(table, settings.source);
    add_grid_settings(table, settings);
    add_backend_settings(table, settings);
    add_fusion_settings(table, settings);
    add_replay_settings(table, settings);
}

void add_map_settings(SettingTable& table, MapSettings& settings) {
    add_mapping_settings(table, settings);
    add_output_settings(table, settings);
}

Setting max_gap_setting(double& max_gap_s) {
    return bind_setting(
        "max-gap", "S", "greatest time between an image and navigation, seconds", max_gap_s,
        finite_where([](double value) { return value >= 0.0 && value <= longest_gap_s; },
                     "a time from 0 to 5 seconds"));
}

MapperOptions mapper_options(const MapSettings& settings) {
    MapperOptions options = settings.mapper;
    options.model = settings.model == "span" ? SensorModel::span : SensorModel::line;
    options.device_shared_memory = !settings.copy_memory;
    if (settings.device_memory) {
        options.device_memory_bytes =
            static_cast<std::uint64_t>(std::max(*settings.device_memory * 0x1.0p20, 1.0));
    }
    options.backend = "reference"; // until the devices are looked at
    check_options(options);
    return options;
}

FrameSpan frame_span(const MapSettings& settings, std::size_t count) {
    FrameSpan span;
    span.last = count;
    if (settings.frames) {
        const FrameSpan asked = *parse_span(*settings.frames);
        const bool open = settings.frames->ends_with(':');
        if (asked.first >= count || (!open && asked.last > count)) {
            throw UsageError(fmt::format("--frames is {}: the recording has frames 0:{}",
                                         *settings.frames, count));
        }
        span.first = asked.first;
        span.last = open ? count : asked.last;
    }
    return span;
}

} // namespace zonegrid
