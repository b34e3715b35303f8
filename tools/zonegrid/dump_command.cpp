#include "command.h"
#include "io/map_folder.h"
#include "standard_output.h"

#include <memory>
#include <string>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Prints the cells of a map as text: a line \"x y z value\" for each cell of the window whose\n"
    "value is not 0, sorted by x, then y, then z. Numbers are cells, x north, y east, z down.";

constexpr const char* help_footer =
    "With --objects a line an object, sorted by identifier: id (x y z), number of cells, least "
    "and\n"
    "greatest cell of its box, sums of x, y and z, octree and prism in hexadecimal digits\n"
    "(docs/model.md, section 8).\n"
    "\n"
    "sha256sum of this output is the digest in the map's report.json.\n"
    "\n"
    "Examples:\n"
    "  zonegrid dump out/flight1 | awk '$4 >= 2' > occupied.txt\n"
    "  zonegrid dump --objects out/flight1 | head\n"
    "\n";

struct DumpCommand {
    std::string folder;
    bool objects = false;
};

} // namespace

void add_dump_command(CLI::App& app) {
    const auto command = std::make_shared<DumpCommand>();
    CLI::App* const dump_app = app.add_subcommand("dump", description);
    dump_app->add_option("DIR", command->folder, "a folder that zonegrid map wrote")
        ->required()
        ->type_name("");
    dump_app->add_flag("--objects", command->objects, "print the objects in place of the cells");
    dump_app->footer(std::string(help_footer) + exit_codes);
    dump_app->callback([command] {
        const auto list = command->objects ? list_objects : list_cells;
        list(command->folder, write_standard_output);
    });
}

} // namespace zonegrid
