#include "command.h"
#include "evaluation/evaluation_json.h"
#include "evaluation/evaluation_pictures.h"
#include "evaluation/evaluation_text.h"
#include "interruption.h"
#include "io/json_text.h"
#include "io/new_folder.h"
#include "io/output_file.h"
#include "progress.h"
#include "standard_output.h"
#include "truth/ray_caster.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Judges a map of a simulated flight against its known truth: precision and recall of occupied\n"
    "cells, wrong free and unknown cells, and for each obstacle whether it was found, split or\n"
    "merged, where, how large, and from which distance on (docs/evaluation.md).";

constexpr const char* help_footer =
    "Make the map with --history: the cells of the window at the end do not tell what was mapped\n"
    "before, nor since when. The truth is looked at from the true poses of every K-th image; by\n"
    "default so many that it takes seconds. First sights are exact whatever K is.\n"
    "\n"
    "DIR gets evaluation.json, profiles.png and profiles_3d.png (map and truth side by side), and\n"
    "measures.png. It appears whole or not at all.\n"
    "\n"
    "Examples:\n"
    "  zonegrid map slalom -o out/slalom --cell 1 --history\n"
    "  zonegrid evaluate out/slalom --truth slalom/truth -o out/judged\n"
    "  zonegrid evaluate out/slalom --truth slalom/truth --json --every 1 > slalom.json\n"
    "\n";

constexpr std::string_view json_name = "evaluation.json";
constexpr std::string_view profiles_name = "profiles.png";
constexpr std::string_view profiles3d_name = "profiles_3d.png";
constexpr std::string_view measures_name = "measures.png";
constexpr std::array<std::string_view, 4> folder_names{json_name, profiles_name, profiles3d_name,
                                                       measures_name};

struct EvaluateCommand {
    std::string map;
    std::string truth;
    std::optional<std::string> output;
    std::optional<int> every;
    bool overwrite = false;
    bool json = false;
    bool quiet = false;
};

/// Draws the truth's images; moves what moves where an image's time is another than the last.
TrueImageDrawer draw_with(RayCaster& caster) {
    return [&caster](const Camera& camera, const TrueImage& image, std::span<float> depth_m,
                     std::span<std::uint32_t> obstacles) {
        caster.move_to(image.time_s);
        caster.draw(camera, image.world_from_camera, depth_m, obstacles);
    };
}

Evaluation evaluate_with_progress(const EvaluateCommand& command,
                                  const InterruptionGuard& interruption) {
    const JudgedMap map = read_judged_map(command.map);
    const Truth truth = read_truth(command.truth);
    require_same_recording(map, truth, command.truth);
    RayCaster caster(truth.surfaces, truth.motions);
    EvaluationOptions options;
    if (command.every) {
        options.every = static_cast<std::size_t>(*command.every);
    }
    std::optional<Progress> progress;
    return evaluate(map, truth, draw_with(caster), options,
                    [&](std::size_t done, std::size_t images) {
                        interruption.check();
                        if (!progress) {
                            progress.emplace(images, !command.quiet);
                        }
                        progress->show(done);
                    });
}

void write_folder(const Evaluation& evaluation, const std::string& json, NewFolder& folder) {
    OutputFile output(folder.path() / json_name);
    output.write(json);
    output.close();
    draw_profiles(evaluation, folder.path() / profiles_name);
    draw_profiles_3d(evaluation, folder.path() / profiles3d_name);
    draw_measures(evaluation, folder.path() / measures_name);
}

void run_evaluate(const EvaluateCommand& command) {
    const InterruptionGuard interruption;
    std::optional<NewFolder> folder;
    if (command.output) {
        folder.emplace(*command.output, command.overwrite ? std::span(folder_names)
                                                          : std::span<const std::string_view>());
    }
    const Evaluation evaluation = evaluate_with_progress(command, interruption);
    const std::string json = json_text(json_of(evaluation));
    if (folder) {
        write_folder(evaluation, json, *folder);
        interruption.check();
        folder->put_in_place();
    }
    if (command.json) {
        write_standard_output(json);
    } else if (!command.quiet) {
        write_standard_output(text_of(evaluation));
    }
}

} // namespace

void add_evaluate_command(CLI::App& app) {
    const auto command = std::make_shared<EvaluateCommand>();
    CLI::App* const evaluate_app = app.add_subcommand("evaluate", description);
    evaluate_app->add_option("MAP", command->map, "a folder that zonegrid map wrote")
        ->required()
        ->type_name("");
    evaluate_app
        ->add_option("--truth", command->truth,
                     "the folder truth/ of the recording, which zonegrid simulate wrote")
        ->required()
        ->type_name("DIR");
    evaluate_app->add_option("--every", command->every, "look at the truth from every K-th image")
        ->type_name("K")
        ->check(CLI::Range(1, 1000000));
    evaluate_app->add_option("-o,--output", command->output, "folder to make for JSON and pictures")
        ->type_name("DIR");
    evaluate_app->add_flag("--overwrite", command->overwrite,
                           "replace DIR if it holds an evaluation");
    evaluate_app->add_flag("--json", command->json, "print the JSON in place of the tables");
    evaluate_app->add_flag("--quiet", command->quiet, "print neither tables nor progress");
    evaluate_app->footer(std::string(help_footer) + exit_codes);
    evaluate_app->callback([command] { run_evaluate(*command); });
}

} // namespace zonegrid
