#include "map_run.h"
#include "text_lines.h"

#include <algorithm>
#include <cmath>

namespace zonegrid {
namespace {

constexpr std::size_t most_listed = 5;

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t place = 0; place < digits.size(); ++place) {
        if (place > 0 && (digits.size() - place) % 3 == 0) {
            text.push_back(',');
        }
        text.push_back(digits[place]);
    }
    return text;
}

/// In centimetres' steps and never -0.
double rounded(double length_m) {
    return std::round(length_m * 100.0) / 100.0 + 0.0;
}

std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string recording_lines(const MapRun& run) {
    const Recording& recording = run.recording;
    const std::string sensor =
        recording.camera() ? fmt::format("depth images of {} x {}", recording.camera()->width_px,
                                         recording.camera()->height_px)
                           : std::string("laser scans");
    std::string text = labelled(
        "recording",
        fmt::format("{} ({} layout, {})", recording.path().string(), recording.layout(), sensor));
    for (const RecordingWarning& warning : recording.warnings()) {
        text += labelled("", fmt::format("{}: {}", warning.where, warning.problem));
    }
    return text;
}

std::string image_lines(const MapRun& run) {
    const ReplaySummary& replay = run.replay;
    std::string text = fmt::format("{} of {} mapped", replay.integrated, replay.images);
    if (replay.images < run.recording.frames().size()) {
        text += fmt::format(" (frames {}:{} of {})", run.span.first, run.span.last,
                            run.recording.frames().size());
    }
    for (std::size_t reason = 0; reason < skip_reasons; ++reason) {
        if (replay.skipped[reason] > 0) {
            text += fmt::format("; {} skipped: {}", replay.skipped[reason],
                                spaced(name_of(static_cast<SkipReason>(reason))));
        }
    }
    std::string lines = labelled("images", text);
    for (std::size_t i = 0; i < std::min(most_listed, replay.skipped_first.size()); ++i) {
        const auto& skipped = replay.skipped_first[i];
        const bool named = skipped.problem.starts_with(skipped.where);
        lines += labelled(
            "", named ? skipped.problem : fmt::format("{}: {}", skipped.where, skipped.problem));
    }
    return lines;
}

std::string map_lines(const MapRun& run) {
    const MapperOptions& options = run.options;
    const MapStatistics& map = run.statistics;
    std::string text = labelled(
        "map", fmt::format("cells of {} m, range {} m, {} model; window of {} cells ({:.4g} m) "
                           "an axis",
                           options.cell_m, options.range_m, run.settings.model, map.window_cells,
                           map.window_cells * options.cell_m));
    text += labelled("cells", fmt::format("{} occupied, {} free", grouped(map.cells_occupied),
                                          grouped(map.cells_free)));
    text += labelled("zones", fmt::format("{} held ({} at most), {} remembered outside the window",
                                          grouped(map.zones_held), grouped(map.zones_held_most),
                                          grouped(map.zones_remembered)));
    return text;
}

std::string object_lines(const MapRun& run) {
    const double cell_m = run.options.cell_m;
    std::vector<const Object*> largest;
    for (const Object& object : run.contents.objects) {
        largest.push_back(&object);
    }
    std::ranges::stable_sort(largest, std::ranges::greater{}, &Object::cell_count);
    const std::size_t listed = std::min(most_listed, largest.size());
    std::string text = labelled(
        "objects", grouped(largest.size()) + (largest.size() > listed ? ", the largest:" : ""));
    for (std::size_t i = 0; i < listed; ++i) {
        const Object& object = *largest[i];
        const Eigen::Vector3d centre_m = object.centre_m(cell_m);
        text += labelled(
            "", fmt::format("{:>9} cells, {:.2f} x {:.2f} x {:.2f} m, centre {:.2f} m "
                            "north, {:.2f} m east, {:.2f} m up",
                            grouped(object.cell_count),
                            (object.box_max.x - object.box_min.x + 1) * cell_m,
                            (object.box_max.y - object.box_min.y + 1) * cell_m,
                            (object.box_max.z - object.box_min.z + 1) * cell_m,
                            rounded(centre_m.x()), rounded(centre_m.y()), rounded(-centre_m.z())));
    }
    return text;
}

std::string time_lines(const MapRun& run) {
    constexpr double ms_per_s = 1e3;
    const ReplaySummary& replay = run.replay;
    const auto stage = [](std::string_view name, const StageTimes& times) {
        return fmt::format("{:<14}  {:<14}{:>10.2f}{:>10.2f}\n", "", name,
                           times.percentile_s(0.5) * ms_per_s, times.percentile_s(0.95) * ms_per_s);
    };
    const auto rate = [](const StageTimes& times) {
        return static_cast<double>(times.seconds.size()) / std::max(times.total_s(), 1e-9);
    };
    std::string text =
        fmt::format("{:<14}{:<16}{:>10}{:>10}\n", "time", "ms an image", "median", "95 %");
    text += stage("read", replay.read) + stage("prepare", replay.prepare) +
            stage("window", replay.window) + stage("integrate", replay.integrate) +
            stage("fuse", replay.fuse) + stage("in all", replay.image);
    text += labelled("", fmt::format("{:.1f} images/s; {:.1f} images/s without reading files",
                                     rate(replay.image), rate(replay.map)));
    text += labelled(
        "", fmt::format("afterwards {:.2f} s for objects, {:.2f} s for cells, {:.2f} s for "
                        "pictures",
                        run.contents.objects_s, run.contents.cells_s, run.contents.pictures_s));
    return text;
}

} // namespace

std::string summary_of(const MapRun& run, const std::filesystem::path& folder) {
    constexpr double bytes_per_mib = 1024.0 * 1024.0;
    std::string text = recording_lines(run) + image_lines(run) + map_lines(run) +
                       object_lines(run) + time_lines(run);
    text +=
        labelled("memory", fmt::format("{:.0f} MiB at most",
                                       static_cast<double>(run.memory_most_bytes) / bytes_per_mib));
    if (const auto& device = run.backend.device) {
        text += labelled("computed on", fmt::format("{} ({})", device->id(), device->name));
    }
    text += labelled("pictures", (folder / profile_name).string());
    text += labelled("", (folder / profile3d_name).string());
    text += labelled("map in", folder.string());
    return text;
}

} // namespace zonegrid
