#include "io/history_file.h"

#include "io/recording_folder.h"
#include "support/oracle_random.h"

#include <gmock/gmock.h>

#include <cstring>
#include <string>

namespace zonegrid::testing {
namespace {

constexpr std::uint32_t frames = 90;

MapperOptions options_with(int zone) {
    MapperOptions options;
    options.cell_m = 0.3;
    options.zone = zone;
    options.limit = 9;
    options.threshold = 3;
    return options;
}

/// A few zones that were changed by several images.
MapHistory random_history(int zone, std::uint64_t seed) {
    oracle::Random random(seed);
    MapHistory history(options_with(zone));
    std::vector<std::int8_t> values(static_cast<std::size_t>(zone * zone * zone));
    for (std::uint32_t image = 0; image < frames; image += 7) {
        history.begin_image(image);
        for (int i = 0; i < 20; ++i) {
            values[static_cast<std::size_t>(random.pick(0, zone * zone * zone - 1))] =
                static_cast<std::int8_t>(random.pick(-9, 9));
        }
        history.take({zone * random.pick(-1, 1), zone * random.pick(-1, 0), zone * 5}, values);
    }
    return history;
}

TEST(HistoryFile, GivesBackEveryValueAndStamp) {
    const RecordingFolder folder;
    for (const int zone : {8, 16, 32}) {
        const MapHistory history = random_history(zone, static_cast<std::uint64_t>(zone));
        write_history_file(folder.path() / "history.zgrid", history, frames);
        const StoredHistory stored = read_history_file(folder.path() / "history.zgrid");
        EXPECT_EQ(stored.options.cell_m, 0.3);
        EXPECT_EQ(stored.options.zone, zone);
        EXPECT_EQ(stored.options.limit, 9);
        EXPECT_EQ(stored.options.threshold, 3);
        EXPECT_EQ(stored.frames, frames);
        EXPECT_GT(stored.zones.size(), 3U);
        EXPECT_TRUE(stored.zones == history.zones());
    }
}

TEST(HistoryFile, LeavesOutZonesThatHoldNothing) {
    const RecordingFolder folder;
    MapHistory history(options_with(8));
    std::vector<std::int8_t> values(512, 0);
    history.take({0, 0, 0}, values);
    values[5] = 3; // was occupied once: that is kept
    history.take({8, 0, 0}, values);
    values[5] = 0;
    history.take({8, 0, 0}, values);
    write_history_file(folder.path() / "history.zgrid", history, 1);
    const auto zones = read_history_file(folder.path() / "history.zgrid").zones;
    ASSERT_EQ(zones.size(), 1U);
    EXPECT_THAT(zones.begin()->second.stamps,
                ::testing::ElementsAre(CellStamp{5, 0, CellStamp::never}));
}

TEST(HistoryFile, IsRefusedWhereverItIsCutOffOrChanged) {
    const RecordingFolder folder;
    write_history_file(folder.path() / "history.zgrid", random_history(8, 1), frames);
    const std::string whole = folder.bytes("history.zgrid");
    ASSERT_GT(whole.size(), 100U);
    for (std::size_t size = 1; size < whole.size(); size += 13) {
        folder.write("history.zgrid", whole.substr(0, size));
        EXPECT_THROW(static_cast<void>(read_history_file(folder.path() / "history.zgrid")),
                     InputError)
            << size;
    }
    for (std::size_t place = 0; place < whole.size(); place += 11) {
        std::string changed = whole;
        changed[place] = static_cast<char>(changed[place] ^ 0x10);
        folder.write("history.zgrid", changed);
        EXPECT_THROW(static_cast<void>(read_history_file(folder.path() / "history.zgrid")),
                     InputError)
            << place;
    }
}

TEST(HistoryFile, IsNotTakenForAGridOfCells) {
    const RecordingFolder folder;
    folder.write("history.zgrid", std::string("ZGRID\r\n\x1a") + std::string(200, 'x'));
    try {
        static_cast<void>(read_history_file(folder.path() / "history.zgrid"));
        ADD_FAILURE() << "it was read";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("is no history that zonegrid wrote"));
    }
}

} // namespace
} // namespace zonegrid::testing
