#include "cli/command_fixture.h"

#include <fmt/format.h>

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class DumpTest : public CommandTest {
protected:
    DumpTest() {
        write_recording();
        const CommandResult result = run("zonegrid map recording -o map --cell 0.1 --range 8");
        EXPECT_EQ(result.exit_code, 0) << result.errors;
    }

    void flip_byte(const std::string& name, std::size_t place) const {
        std::string bytes = read_file(name);
        bytes.at(place) = static_cast<char>(bytes[place] ^ 1);
        write_file(name, bytes);
    }
};

TEST_F(DumpTest, IsQuietWhenTheReaderStops) {
    for (const char* const option : {"", "--objects "}) {
        const CommandResult result = run("zonegrid dump " + std::string(option) +
                                         "map | head -n 1 | wc -l; echo ${PIPESTATUS[0]}");
        EXPECT_EQ(result.output, "1\n0\n") << option;
        EXPECT_THAT(result.errors, IsEmpty()) << option;
    }
}

TEST_F(DumpTest, NoticesAFullDisk) {
    const CommandResult result = run("zonegrid dump map > /dev/full");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("standard output"));
}

TEST_F(DumpTest, KeepsItsExitCodeWhereErrorsCannotBePrinted) {
    EXPECT_EQ(run("zonegrid dump nowhere 2> /dev/full").exit_code, 1);
    EXPECT_EQ(run("zonegrid dump 2> /dev/full").exit_code, 2);
}

TEST_F(DumpTest, RefusesADamagedGridBeforePrinting) {
    const std::size_t size = read_file("map/cells.zgrid").size();
    for (const std::size_t place : {std::size_t{0}, std::size_t{9}, size / 2, size - 1}) {
        flip_byte("map/cells.zgrid", place);
        const CommandResult result = run("zonegrid dump map");
        EXPECT_EQ(result.exit_code, 1) << place;
        EXPECT_THAT(result.output, IsEmpty()) << place;
        EXPECT_THAT(result.errors, one_line_with("cells.zgrid", "again")) << place;
        flip_byte("map/cells.zgrid", place);
    }
    std::filesystem::resize_file(path("map/cells.zgrid"), size - 100);
    EXPECT_THAT(run("zonegrid dump map").errors, one_line_with("cells.zgrid", "cut off"));
}

TEST_F(DumpTest, RefusesObjectsThatAreNotTheReports) {
    std::string objects = read_file("map/objects.json");
    const std::size_t digit = objects.find("\"cells\":") + 8;
    objects[digit] = objects[digit] == '1' ? '2' : '1';
    write_file("map/objects.json", objects);
    const CommandResult changed = run("zonegrid dump --objects map");
    EXPECT_EQ(changed.exit_code, 1);
    EXPECT_THAT(changed.output, IsEmpty());
    EXPECT_THAT(changed.errors, one_line_with("objects.json", "report.json"));
    write_file("map/objects.json", objects.substr(0, objects.size() / 2));
    EXPECT_THAT(run("zonegrid dump --objects map").errors,
                one_line_with("objects.json", "damaged"));
}

TEST_F(DumpTest, ListsObjectsInTheirOwnForm) {
    const std::string lines = run("zonegrid dump --objects map | head -n 1").output;
    const nlohmann::json first = read_json("map/objects.json")["objects"][0];
    EXPECT_THAT(lines,
                StartsWith(fmt::format("{} {} {} {} ", first["id"][0].dump(), first["id"][1].dump(),
                                       first["id"][2].dump(), first["cells"].dump())));
    EXPECT_THAT(lines, HasSubstr(fmt::format(" {} {}\n", first["octree"].get<std::string>(),
                                             first["prism"].get<std::string>())));
}

} // namespace
} // namespace zonegrid::testing
