#include "io/generated_case.h"

#include "io/flight_writer.h"
#include "io/new_folder.h"
#include "io/output_file.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace zonegrid {
namespace {

constexpr std::string_view story_name = "replay.txt";

} // namespace

std::string mapping_arguments(const MapperOptions& options) {
    // The shortest numbers that are read back as the same doubles.
    return fmt::format(
        "--cell {} --range {} --zone {} --model {} --span-sigmas {} --hit {} --miss {} --limit {} "
        "--threshold {} --max-gap {}",
        options.cell_m, options.range_m, options.zone,
        options.model == SensorModel::span ? "span" : "line", options.span_sigmas, options.hit,
        options.miss, options.limit, options.threshold, options.max_gap_s);
}

std::string shell_word(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:+,@";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string word = "'";
    for (const char letter : text) {
        word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    }
    return word + "'";
}

std::string replay_command(const std::filesystem::path& folder, const MapperOptions& options,
                           const std::string& backend, const std::string& against) {
    return fmt::format("zonegrid check {} --every 1 {} --backend {}{}", shell_word(folder.string()),
                       mapping_arguments(options), backend,
                       against == "reference" ? "" : " --against " + against);
}

void save_case(const std::filesystem::path& folder, const GeneratedFlight& flight,
               const std::string& story) {
    constexpr std::array<std::string_view, 5> names{flight_file_names[0], flight_file_names[1],
                                                    flight_file_names[2], flight_frames_name,
                                                    story_name};
    NewFolder saved(folder, names);
    write_flight(saved.path(), flight);
    OutputFile output(saved.path() / story_name);
    output.write(story);
    output.close();
    saved.put_in_place();
}

} // namespace zonegrid
