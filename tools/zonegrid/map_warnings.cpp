#include "map_run.h"

#include <cmath>

namespace zonegrid {

std::string explain_no_image(const ReplaySummary& replay) {
    std::string counts;
    for (std::size_t reason = 0; reason < skip_reasons; ++reason) {
        if (replay.skipped[reason] > 0) {
            counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", replay.skipped[reason],
                                  name_of(static_cast<SkipReason>(reason)));
        }
    }
    const std::string first =
        replay.skipped_first.empty() ? "" : replay.skipped_first.front().problem;
    const auto most_are = [&](SkipReason reason) {
        return 2 * replay.skipped[static_cast<std::size_t>(reason)] >= replay.images;
    };
    std::string remedy = "run zonegrid inspect on the recording";
    if (most_are(SkipReason::no_navigation)) {
        remedy = "images and navigation may run on different clocks: " + remedy +
                 ", or give a larger --max-gap";
    }
    return fmt::format("none of {} images could be mapped ({}; the first: {}); {}", replay.images,
                       counts, first, remedy);
}

std::vector<std::string> find_map_warnings(const ReplaySummary& replay,
                                           const MapStatistics& statistics,
                                           const MapperOptions& options) {
    std::vector<std::string> warnings;
    if (replay.cells_changed == 0 && replay.rays == 0) {
        warnings.push_back(fmt::format(
            "no cell changed: all {} pixels of {} images are missing; usually the files hold no "
            "depth, or the value that means missing is wrong: run zonegrid inspect",
            replay.missing, replay.integrated));
    } else if (replay.cells_changed == 0) {
        warnings.push_back(fmt::format(
            "no cell changed although {} pixels of {} images have a distance ({} rays left the "
            "window); usually the poses are wrong: run zonegrid inspect",
            replay.rays, replay.integrated, replay.dropped));
    } else if (!(replay.least_distance_m <= options.range_m)) {
        warnings.push_back(
            std::isfinite(replay.least_distance_m)
                ? fmt::format("no obstacle: the nearest distance in any image is {:.4g} m, beyond "
                              "the range of {} m; usually the depth scale is wrong (--depth-scale "
                              "1000 or 5000) or --range too small",
                              replay.least_distance_m, options.range_m)
                : std::string("no obstacle: every pixel is sky or missing; usually the value that "
                              "means infinite is wrong: run zonegrid inspect"));
    } else if (statistics.cells_occupied == 0 && statistics.zones_remembered == 0) {
        warnings.push_back(fmt::format(
            "no cell is occupied, though {} changed; usually the distances do not agree from image "
            "to image (poses or depth scale wrong), or --threshold is too high for so few images",
            replay.cells_changed));
    }
    return warnings;
}

} // namespace zonegrid
