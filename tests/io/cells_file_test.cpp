#include "io/cells_file.h"

#include "io/cell_listing.h"
#include "io/recording_folder.h"
#include "support/oracle_random.h"

#include <map>
#include <string>
#include <tuple>

namespace zonegrid::testing {
namespace {

using Values = std::map<std::tuple<int, int, int>, int>; // in the order in which cells come

Values random_values(std::uint64_t seed, int extent_cell, int count) {
    oracle::Random random(seed);
    Values values;
    for (int i = 0; i < count; ++i) {
        const int value = random.pick(-8, 8);
        const auto axis = [&] { return random.pick(-extent_cell, extent_cell); };
        if (value != 0) {
            values[{axis(), axis(), axis()}] = value;
        }
    }
    return values;
}

MapperOptions options_with(int zone) {
    MapperOptions options;
    options.cell_m = 0.3;
    options.zone = zone;
    options.limit = 9;
    options.threshold = 3;
    return options;
}

void write_values(const std::filesystem::path& file, const Values& values, int zone) {
    CellsFileWriter writer(file, options_with(zone));
    for (const auto& [place, value] : values) {
        const auto& [x, y, z] = place;
        writer.add({x, y, z}, value);
    }
    writer.close();
}

TEST(CellsFile, GivesBackEveryCellInOrder) {
    const RecordingFolder folder;
    for (const int zone : {8, 16, 32}) {
        const Values values = random_values(static_cast<std::uint64_t>(zone), 70, 3000);
        write_values(folder.path() / "cells.zgrid", values, zone);
        const StoredCells cells = read_cells_file(folder.path() / "cells.zgrid");
        EXPECT_EQ(cells.cell_m, 0.3);
        EXPECT_EQ(cells.zone, zone);
        EXPECT_EQ(cells.limit, 9);
        EXPECT_EQ(cells.threshold, 3);
        auto expected = values.begin();
        std::size_t visited = 0;
        cells.for_each_cell([&](const CellIndex& cell, int value) {
            ASSERT_NE(expected, values.end());
            EXPECT_EQ(std::tuple(cell.x, cell.y, cell.z), expected->first);
            EXPECT_EQ(value, expected->second);
            ++expected;
            ++visited;
        });
        EXPECT_EQ(visited, values.size());
        EXPECT_GT(visited, 2000U);
    }
}

TEST(CellsFile, HoldsNoZoneForAnEmptyGrid) {
    const RecordingFolder folder;
    write_values(folder.path() / "cells.zgrid", {}, 32);
    EXPECT_THAT(read_cells_file(folder.path() / "cells.zgrid").zones, ::testing::IsEmpty());
}

TEST(CellsFile, IsRefusedWhereverItIsCutOff) {
    const RecordingFolder folder;
    write_values(folder.path() / "cells.zgrid", random_values(1, 20, 500), 8);
    const std::string whole = folder.bytes("cells.zgrid");
    std::size_t tried = 0;
    for (std::size_t size = 1; size < whole.size(); size += 1 + size / 16) {
        folder.write("cells.zgrid", std::string_view(whole).substr(0, size));
        EXPECT_THAT([&] { return read_cells_file(folder.path() / "cells.zgrid"); },
                    refuses("cells.zgrid"))
            << size;
        ++tried;
    }
    EXPECT_GT(tried, 50U);
}

TEST(CellsFile, IsRefusedWithAnyBitChanged) {
    const RecordingFolder folder;
    write_values(folder.path() / "cells.zgrid", random_values(2, 20, 100), 8);
    const std::string whole = folder.bytes("cells.zgrid");
    for (std::size_t place = 0; place < whole.size(); place += 7) {
        std::string changed = whole;
        changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
        folder.write("cells.zgrid", changed);
        EXPECT_THAT([&] { return read_cells_file(folder.path() / "cells.zgrid"); },
                    refuses("cells.zgrid"))
            << place;
    }
}

TEST(CellsFile, IsRefusedWithoutItsEnd) {
    const RecordingFolder folder;
    {
        CellsFileWriter writer(folder.path() / "cells.zgrid", options_with(8));
        writer.add({1, 2, 3}, 4);
    }
    EXPECT_THAT([&] { return read_cells_file(folder.path() / "cells.zgrid"); },
                refuses("cells.zgrid"));
}

TEST(CellListing, WritesTheLinesOfTheModel) {
    std::string text;
    CellListing listing([&text](std::string_view lines) { text += lines; });
    listing.add({-12, 0, 7}, -8);
    listing.add({-12, 0, 8}, 127);
    listing.add({-12, 3, 8}, 1);
    listing.add({5, 3, -2147483647}, 2);
    listing.finish();
    EXPECT_EQ(text, "-12 0 7 -8\n-12 0 8 127\n-12 3 8 1\n5 3 -2147483647 2\n");
}

TEST(CellListing, HandsOverWholeLinesInPieces) {
    std::string text;
    std::size_t pieces = 0;
    CellListing listing([&](std::string_view lines) {
        EXPECT_EQ(lines.back(), '\n');
        text += lines;
        ++pieces;
    });
    std::string expected;
    for (int z = 0; z < 300000; ++z) {
        listing.add({1, 2, z}, 3);
        expected += "1 2 " + std::to_string(z) + " 3\n";
    }
    listing.finish();
    EXPECT_GT(pieces, 2U);
    EXPECT_TRUE(text == expected);
}

} // namespace
} // namespace zonegrid::testing
