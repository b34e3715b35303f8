#include "io/new_folder.h"

#include "io/output_file.h"
#include "io/recording_folder.h"
#include "io/sha256.h"

#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::array<std::string_view, 1> file_names{"a.txt"};

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    return names;
}

TEST(NewFolder, AppearsWhenPutInPlace) {
    const RecordingFolder parent;
    NewFolder folder(parent.path() / "map", {});
    std::ofstream(folder.path() / "a.txt") << "new";
    EXPECT_FALSE(std::filesystem::exists(parent.path() / "map"));
    folder.put_in_place();
    EXPECT_EQ(parent.bytes("map/a.txt"), "new");
    EXPECT_THAT(names_in(parent.path()), ::testing::ElementsAre("map"));
}

TEST(NewFolder, LeavesNothingOtherwise) {
    const RecordingFolder parent;
    {
        const NewFolder folder(parent.path() / "map", {});
        std::ofstream(folder.path() / "a.txt") << "new";
        EXPECT_THAT(names_in(parent.path()), ::testing::SizeIs(1));
    }
    EXPECT_THAT(names_in(parent.path()), ::testing::IsEmpty());
}

TEST(NewFolder, ReplacesOnlyWhatItMay) {
    const RecordingFolder parent;
    parent.write("map/a.txt", "old");
    EXPECT_THAT([&] { const NewFolder folder(parent.path() / "map", {}); },
                ThrowsMessage<OutputError>(HasSubstr("--overwrite")));
    {
        NewFolder folder(parent.path() / "map", file_names);
        std::ofstream(folder.path() / "a.txt") << "new";
        EXPECT_EQ(parent.bytes("map/a.txt"), "old");
        folder.put_in_place();
        EXPECT_EQ(parent.bytes("map/a.txt"), "new");
    }
    EXPECT_THAT(names_in(parent.path()), ::testing::ElementsAre("map"));
    parent.write("map/b.txt", "mine");
    EXPECT_THAT([&] { const NewFolder folder(parent.path() / "map", file_names); },
                ThrowsMessage<OutputError>(HasSubstr("b.txt")));
    EXPECT_EQ(parent.bytes("map/b.txt"), "mine");
}

TEST(NewFolder, DoesNotReplaceWhatAppearedMeanwhile) {
    const RecordingFolder parent;
    {
        NewFolder folder(parent.path() / "map", {});
        parent.write("map/b.txt", "another's");
        EXPECT_THAT([&] { folder.put_in_place(); },
                    ThrowsMessage<OutputError>(HasSubstr("cannot be put in place")));
    }
    EXPECT_EQ(parent.bytes("map/b.txt"), "another's");
    EXPECT_THAT(names_in(parent.path()), ::testing::ElementsAre("map"));
}

TEST(OutputFile, NoticesAFullDisk) {
    OutputFile output("/dev/full");
    output.write(std::string_view("a few bytes, kept back until the end"));
    EXPECT_THAT([&] { output.close(); },
                ThrowsMessage<OutputError>(HasSubstr("/dev/full: cannot be written (No space")));
}

TEST(OutputFile, NoticesAMissingFolder) {
    EXPECT_THAT([] { const OutputFile output("/nowhere/file"); },
                ThrowsMessage<OutputError>(HasSubstr("/nowhere/file: cannot be written (No such")));
}

TEST(Sha256, HasTheSumsOfItsStandard) {
    // FIPS 180-2, appendix B: one block, and two.
    Sha256 one;
    one.add(std::string_view("abc"));
    EXPECT_EQ(one.finish_hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    Sha256 two;
    two.add(std::string_view("abcdbcdecdefdefgefghfghighijhijk"));
    two.add(std::string_view("ijkljklmklmnlmnomnopnopq"));
    EXPECT_EQ(two.finish_hex(), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

} // namespace
} // namespace zonegrid::testing
