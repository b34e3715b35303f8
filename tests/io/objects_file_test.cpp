#include "io/objects_file.h"

#include "io/hexadecimal.h"
#include "io/object_listing.h"
#include "io/recording_folder.h"

#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

Object example_object() {
    Object object;
    object.id = {-3, 4, 5};
    object.cell_count = 2;
    object.box_min = {-3, 4, 5};
    object.box_max = {-2, 4, 5};
    object.cell_sum = {-5, 8, 10};
    object.octree = {0x05, 0xA0};
    object.prism = {0x0F};
    return object;
}

TEST(ObjectsFile, GivesBackTheObjects) {
    const RecordingFolder folder;
    Object other = example_object();
    other.id.x = 7;
    other.octree.clear();
    other.cell_sum = {std::int64_t{1} << 60, -(std::int64_t{1} << 60), 0};
    const std::vector<Object> objects{example_object(), other};
    write_objects_file(folder.path() / "objects.json", objects, 0.1);
    EXPECT_EQ(read_objects_file(folder.path() / "objects.json"), objects);
    write_objects_file(folder.path() / "objects.json", {}, 0.1);
    EXPECT_THAT(read_objects_file(folder.path() / "objects.json"), ::testing::IsEmpty());
}

TEST(ObjectsFile, IsRefusedWhereverItIsCutOff) {
    const RecordingFolder folder;
    const std::vector<Object> objects{example_object()};
    write_objects_file(folder.path() / "objects.json", objects, 0.1);
    const std::string whole = folder.bytes("objects.json");
    for (std::size_t size = 1; size + 1 < whole.size(); ++size) { // the last byte ends the line
        folder.write("objects.json", std::string_view(whole).substr(0, size));
        EXPECT_THAT([&] { return read_objects_file(folder.path() / "objects.json"); },
                    refuses("objects.json", "damaged"))
            << size;
    }
}

TEST(ObjectsFile, IsRefusedIfATreeIsNotHexadecimal) {
    const RecordingFolder folder;
    const std::vector<Object> objects{example_object()};
    write_objects_file(folder.path() / "objects.json", objects, 0.1);
    std::string text = folder.bytes("objects.json");
    text.replace(text.find("05a0"), 4, "05g0");
    folder.write("objects.json", text);
    EXPECT_THAT([&] { return read_objects_file(folder.path() / "objects.json"); },
                refuses("objects.json", "hexadecimal"));
}

TEST(ObjectListing, WritesTheLineOfTheModel) {
    EXPECT_EQ(object_line(example_object()), "-3 4 5 2 -3 4 5 -2 4 5 -5 8 10 05a0 0f\n");
}

TEST(Hexadecimal, ReadsOnlyItsOwnForm) {
    EXPECT_EQ(from_hexadecimal("00ff7e"), (std::vector<std::uint8_t>{0x00, 0xFF, 0x7E}));
    EXPECT_EQ(from_hexadecimal(""), std::vector<std::uint8_t>());
    EXPECT_EQ(from_hexadecimal("0"), std::nullopt);
    EXPECT_EQ(from_hexadecimal("0F"), std::nullopt);
    EXPECT_EQ(from_hexadecimal(" f"), std::nullopt);
}

} // namespace
} // namespace zonegrid::testing
