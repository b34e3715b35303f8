#include "cli/command_fixture.h"
#include "device/device.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

// Two runs of the command at once share devices and the cache of compiled kernels.

namespace zonegrid::testing {
namespace {

class TwoProcessesTest : public CommandTest {};

TEST_F(TwoProcessesTest, MakeTheReferencesMapAtOnceOnEachDevice) {
    write_recording(SmallRecording{});
    const std::string map = "zonegrid map recording --cell 0.2 --quiet";
    ASSERT_EQ(run(map + " -o reference").exit_code, 0);
    const auto expected = run("zonegrid dump reference").output;
    ASSERT_FALSE(expected.empty());
    for (const auto& info : device::list_devices().devices) {
        if (!info.refusal.empty()) {
            continue;
        }
        // First from the source, then from the cache.
        for (const std::string round : {"compiled", "cached"}) {
            SCOPED_TRACE(info.id() + ", " + round);
            const auto result =
                run(fmt::format("export ZONEGRID_CACHE_DIR=\"$PWD/cache-{0}\"\n"
                                "{1} --backend {0} -o one-{0}-{2} & first=$!\n"
                                "{1} --backend {0} -o two-{0}-{2} & second=$!\n"
                                "wait $first && wait $second",
                                info.id(), map, round));
            EXPECT_EQ(result.exit_code, 0) << result.errors;
            EXPECT_EQ(run(fmt::format("zonegrid dump one-{}-{}", info.id(), round)).output,
                      expected);
            EXPECT_EQ(run(fmt::format("zonegrid dump two-{}-{}", info.id(), round)).output,
                      expected);
        }
        EXPECT_TRUE(exists("cache-" + info.id()));
    }
}

} // namespace
} // namespace zonegrid::testing
