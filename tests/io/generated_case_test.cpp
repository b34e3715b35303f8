#include "io/generated_case.h"

#include "io/broken_engine.h"
#include "io/device_check.h"
#include "support/temporary_folder.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

namespace zonegrid {
namespace {

using testing::BrokenEngine;
using testing::Fault;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

GridEngineMaker broken(Fault fault) {
    return
        [fault](const MapperOptions& options, const std::optional<Camera>&, const Window& window) {
            return std::make_unique<BrokenEngine>(options, window, fault);
        };
}

TEST(GeneratedCase, ShowsTheSameFaultWhenItIsReadBack) {
    std::size_t found = 0;
    for (std::uint64_t number = 0; number < 40; ++number) {
        for (const Fault fault : {Fault::image_loses_a_pixel, Fault::scan_loses_a_ray,
                                  Fault::fusion_forgets_limit, Fault::drawing_loses_cells}) {
            SCOPED_TRACE(number);
            const GeneratedFlight flight(5, number);
            const auto difference = FlightCheck(flight, "reference").difference_of(broken(fault));
            if (!difference) {
                continue;
            }
            ++found;
            const TemporaryFolder folder;
            save_case(folder.path() / "case", flight, "a story\n");
            const auto recording = open_recording(folder.path() / "case");
            const auto ignore = [](const ReplaySummary& /*so_far*/) {};
            const MapRecipe expected{flight.options()};
            const auto again =
                find_difference(*recording, {0, recording->frames().size()}, expected,
                                take_steps(*recording, {}, expected, 1, ignore),
                                {flight.options(), broken(fault)}, 1, ignore);
            ASSERT_TRUE(again.has_value());
            EXPECT_EQ(again->images, difference->images);
            EXPECT_EQ(again->operation, difference->operation);
            EXPECT_EQ(again->detail, difference->detail);
            EXPECT_THAT(again->frame, HasSubstr(difference->frame));
        }
    }
    EXPECT_GT(found, 40U);
}

TEST(GeneratedCase, ReplacesACaseButNothingElse) {
    const TemporaryFolder folder;
    const GeneratedFlight flight(5, 0);
    save_case(folder.path() / "case", flight, "first\n");
    save_case(folder.path() / "case", flight, "second\n");
    std::ifstream stream(folder.path() / "case" / "replay.txt");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "second\n");
    std::ofstream(folder.path() / "case" / "mine.txt") << "keep";
    EXPECT_THROW(save_case(folder.path() / "case", flight, ""), OutputError);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "case" / "mine.txt"));
}

TEST(GeneratedCase, QuotesFoldersForAShell) {
    EXPECT_EQ(shell_word("zonegrid-case-1-2"), "zonegrid-case-1-2");
    EXPECT_EQ(shell_word("my case"), "'my case'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
}

TEST(GeneratedCase, NamesTheBackendItIsComparedWith) {
    const MapperOptions options;
    EXPECT_THAT(replay_command("case", options, "opencl:0", "reference"),
                ::testing::AllOf(HasSubstr("zonegrid check case --every 1 --cell 1 "),
                                 ::testing::EndsWith("--backend opencl:0")));
    EXPECT_THAT(replay_command("case", options, "opencl:0", "vulkan:1"),
                HasSubstr("--backend opencl:0 --against vulkan:1"));
}

} // namespace
} // namespace zonegrid
