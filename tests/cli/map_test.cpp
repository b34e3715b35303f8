#include "cli/command_fixture.h"

#include "io/history_file.h"
#include "io/recording.h"
#include "zonegrid/mapper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

using MapTest = CommandTest;

constexpr const char* map_command_line = "zonegrid map recording -o map --cell 0.1 --range 8 ";

TEST_F(MapTest, WritesAllFilesAndASummary) {
    write_recording();
    const CommandResult result = run(map_command_line);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, IsEmpty());
    EXPECT_THAT(names(), ElementsAre("map", "recording"));
    for (const char* const name :
         {"report.json", "objects.json", "cells.zgrid", "profile.png", "profile_3d.png"}) {
        EXPECT_GT(std::filesystem::file_size(path("map") / name), 0U) << name;
    }
    for (const char* const part : {"8 of 8 mapped", "map/profile.png", "occupied", "median"}) {
        EXPECT_THAT(result.output, HasSubstr(part));
    }
    EXPECT_THAT(read_file("map/profile.png"), StartsWith("\x89PNG"));
}

TEST_F(MapTest, ReportsWhatItDid) {
    write_recording();
    const CommandResult result = run(std::string(map_command_line) + "--json --frames 2:7");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output, read_file("map/report.json"));
    const nlohmann::json report = read_json("map/report.json");
    EXPECT_EQ(report["recording"]["layout"], "poses");
    EXPECT_EQ(report["recording"]["frames"], 8);
    EXPECT_EQ(report["parameters"]["cell_m"], 0.1);
    EXPECT_EQ(report["parameters"]["frames"], nlohmann::json({2, 7}));
    EXPECT_EQ(report["images"]["integrated"], 5);
    EXPECT_EQ(report["rays"]["missing"], 5);
    EXPECT_EQ(report["rays"]["stated"], 5 * (32 * 24 - 1));
    EXPECT_GT(report["map"]["cells_occupied"], 0);
    EXPECT_GE(report["map"]["zones_held_most"], report["map"]["zones_held"]);
    EXPECT_GT(report["memory_most_bytes"], 1000000);
    EXPECT_GT(report["time"]["image_ms"]["integrate"]["median"], 0.0);
    EXPECT_THAT(report["warnings"], IsEmpty());
}

TEST_F(MapTest, ObjectsFileAgreesWithTheReport) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    const nlohmann::json objects = read_json("map/objects.json");
    EXPECT_THAT(objects["objects"], SizeIs(read_json("map/report.json")["map"]["objects"]));
    EXPECT_THAT(objects["objects"], Not(IsEmpty()));
    std::uint64_t cells = 0;
    for (const auto& object : objects["objects"]) {
        cells += object["cells"].get<std::uint64_t>();
        EXPECT_LE(object["box_m"]["min"][2], object["box_m"]["max"][2]);
        EXPECT_DOUBLE_EQ(object["prism_height_m"]["highest"].get<double>(),
                         -object["box_m"]["min"][2].get<double>());
    }
    EXPECT_EQ(cells, read_json("map/report.json")["map"]["cells_occupied"]);
}

/// The listing that docs/model.md, section 10, asks for, from the library's own calls.
std::string cells_by_library(const std::filesystem::path& folder) {
    const auto recording = open_recording(folder);
    MapperOptions options;
    options.cell_m = 0.1;
    options.range_m = 8.0;
    Mapper mapper(options, recording->camera());
    std::size_t next = 0;
    for (std::size_t i = 0; i < recording->frames().size(); ++i) {
        const double time_s = recording->frames()[i].time_s;
        for (; next < recording->navigation().size() &&
               recording->navigation()[next].time_s <= time_s + options.max_gap_s;
             ++next) {
            mapper.add_navigation(recording->navigation()[next]);
        }
        const FrameData data = recording->read_frame(i);
        EXPECT_EQ(mapper.add_image({time_s, data.depth_m}).status, ImageStatus::integrated);
    }
    std::string lines;
    mapper.for_each_cell([&lines](const CellIndex& cell, int value) {
        lines += fmt::format("{} {} {} {}\n", cell.x, cell.y, cell.z, value);
    });
    return lines;
}

TEST_F(MapTest, DumpEqualsTheLibrarysOwnMap) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    const std::string lines = run("zonegrid dump map").output;
    EXPECT_GT(lines.size(), 10000U);
    EXPECT_TRUE(lines == cells_by_library(path("recording")));
}

TEST_F(MapTest, DigestsAreThoseOfTheDumps) {
    write_recording();
    for (const char* const zone : {"8", "16", "32"}) {
        ASSERT_EQ(run(fmt::format("{} --overwrite --zone {}", map_command_line, zone)).exit_code,
                  0);
        const nlohmann::json digest = read_json("map/report.json")["digest"];
        EXPECT_THAT(run("zonegrid dump map | sha256sum").output,
                    StartsWith(digest["cells"].get<std::string>()))
            << zone;
        EXPECT_THAT(run("zonegrid dump --objects map | sha256sum").output,
                    StartsWith(digest["objects"].get<std::string>()))
            << zone;
    }
}

TEST_F(MapTest, GivesTheSameMapAgain) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    ASSERT_EQ(run("zonegrid map recording -o again --cell 0.1 --range 8").exit_code, 0);
    for (const char* const name :
         {"cells.zgrid", "objects.json", "profile.png", "profile_3d.png"}) {
        EXPECT_TRUE(read_file(std::string("map/") + name) ==
                    read_file(std::string("again/") + name))
            << name;
    }
}

TEST_F(MapTest, KeepsAHistoryWhenAsked) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    EXPECT_FALSE(exists("map/history.zgrid"));
    ASSERT_EQ(
        run("zonegrid map recording -o again --cell 0.1 --range 8 --frames 2: --history").exit_code,
        0);
    const StoredHistory history = read_history_file(path("again/history.zgrid"));
    EXPECT_EQ(history.frames, 8U);
    // Nothing left the window: the history's values are the map's, and images count in the
    // recording.
    std::map<CellIndex, int> values;
    std::uint32_t least = CellStamp::never;
    std::uint32_t most = 0;
    for (const auto& [zone, known] : history.zones) {
        for (std::uint32_t place = 0; place < known.values.size(); ++place) {
            if (known.values[place] != 0) {
                values[cell_at(zone, place, history.options.zone)] = known.values[place];
            }
        }
        for (const auto& stamp : known.stamps) {
            least = std::min(least, stamp.first_image);
            most = std::max(most, stamp.first_image);
        }
    }
    std::string lines;
    for (const auto& [cell, value] : values) {
        lines += fmt::format("{} {} {} {}\n", cell.x, cell.y, cell.z, value);
    }
    EXPECT_TRUE(lines == run("zonegrid dump again").output);
    EXPECT_EQ(least, 2U);
    EXPECT_EQ(most, 7U);
    EXPECT_EQ(run("zonegrid map recording -o again --cell 0.1 --range 8 --overwrite").exit_code, 0);
    EXPECT_FALSE(exists("again/history.zgrid"));
}

TEST_F(MapTest, SkipsAndListsDamagedImages) {
    write_recording();
    std::filesystem::resize_file(path("recording/frame-000003.depth.png"), 60);
    write_file("recording/frame-000005.depth.png", "no picture");
    const CommandResult result = run(map_command_line);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("6 of 8 mapped; 2 skipped: damaged"));
    EXPECT_THAT(result.output, HasSubstr("frame-000003.depth.png"));
    const nlohmann::json images = read_json("map/report.json")["images"];
    EXPECT_EQ(images["integrated"], 6);
    EXPECT_EQ(images["skipped"]["damaged"], 2);
    EXPECT_THAT(images["skipped_first"], SizeIs(2));
    EXPECT_THAT(images["skipped_first"][0]["file"].get<std::string>(), HasSubstr("000003"));
}

TEST_F(MapTest, WithoutAnyImageIsAFailure) {
    write_recording();
    for (int image = 1; image < 8; ++image) {
        write_file(fmt::format("recording/frame-{:06}.depth.png", image), "no picture");
    }
    const CommandResult result = run(std::string(map_command_line) + "--frames 1:8");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("none of 7 images", "7 damaged", "inspect"));
    EXPECT_THAT(names(), ElementsAre("recording"));
}

TEST_F(MapTest, SaysWhenEveryPixelIsMissing) {
    SmallRecording recording;
    recording.depth_m = [](std::size_t, int, int) { return 0.0; };
    write_recording(recording);
    const CommandResult result = run(map_command_line);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.errors, HasSubstr("warning: no cell changed: all 6144 pixels"));
    EXPECT_THAT(run("zonegrid dump map").output, IsEmpty());
    EXPECT_THAT(run("zonegrid dump map").errors, IsEmpty());
    EXPECT_EQ(read_json("map/report.json")["images"]["without_change"], 8);
}

TEST_F(MapTest, SaysWhenEverythingIsBeyondTheRange) {
    SmallRecording recording;
    recording.units_per_m = 8000; // read with 1000: everything is 8 times as far
    write_recording(recording);
    const CommandResult result = run(map_command_line);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.errors, HasSubstr("nearest distance in any image is 18.4 m"));
    EXPECT_THAT(result.errors, HasSubstr("--depth-scale"));
    EXPECT_THAT(run(std::string(map_command_line) + "--overwrite --depth-scale 8000").errors,
                IsEmpty());
}

TEST_F(MapTest, IsQuietWhenAsked) {
    write_recording();
    const CommandResult result = run(std::string(map_command_line) + "--quiet");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.output + result.errors, IsEmpty());
}

TEST_F(MapTest, ShowsProgressOnATerminalOnly) {
    write_recording();
    // script(1) gives the command a terminal.
    const CommandResult result = run(fmt::format(
        "script -qec \"'{}' map recording -o map --range 8\" /dev/null", ZONEGRID_COMMAND));
    if (result.errors.find("pseudo-terminal") != std::string::npos) {
        GTEST_SKIP() << "no terminal can be made here: " << result.errors;
    }
    EXPECT_THAT(result.output, HasSubstr("0 of 8 images"));
    EXPECT_THAT(run(std::string(map_command_line) + "--overwrite").errors, IsEmpty());
}

TEST_F(MapTest, DrawsOnlyBelowTheCutHeight) {
    write_recording();
    ASSERT_EQ(run(std::string(map_command_line) + "--json").exit_code, 0);
    const nlohmann::json whole = read_json("map/report.json");
    ASSERT_EQ(run(std::string(map_command_line) + "--overwrite --cut-height -1").exit_code, 0);
    const nlohmann::json cut = read_json("map/report.json");
    EXPECT_LT(cut["map"]["profile_columns"], whole["map"]["profile_columns"]);
    EXPECT_EQ(cut["digest"], whole["digest"]);
}

} // namespace
} // namespace zonegrid::testing
