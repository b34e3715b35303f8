#include "doctor_report.h"

#include "text_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace zonegrid {
namespace {

using Json = nlohmann::ordered_json;

std::string state_of(const DeviceFile& file) {
    if (file.usable()) {
        return "readable and writable";
    }
    return fmt::format("{}, {}; its group is {}", file.readable ? "readable" : "not readable",
                       file.writable ? "writable" : "not writable", file.group);
}

std::vector<std::string> texts_of(const std::vector<std::filesystem::path>& places) {
    return {places.begin(), places.end()};
}

Json json_of(const InstalledDrivers& drivers) {
    const DriverLoader& loader = drivers.loader;
    Json json;
    json["backend"] = loader.backend;
    json["loader"] = {{"library", loader.library},
                      {"found", loader.problem.empty()},
                      {"file", loader.file},
                      {"problem", loader.problem}};
    json["looked_in"] = texts_of(drivers.places);
    json["driver_files"] = Json::array();
    for (const DriverFile& driver : drivers.files) {
        json["driver_files"].push_back({{"file", driver.file.string()},
                                        {"library", driver.library},
                                        {"found", driver.problem.empty()},
                                        {"foreign", driver.foreign},
                                        {"problem", driver.problem}});
    }
    return json;
}

Json json_of(const ExaminedDevice& examined) {
    const auto& info = examined.info;
    Json json;
    json["id"] = info.id();
    json["name"] = info.name;
    json["type"] = info.type;
    json["driver"] = info.driver;
    json["api"] = info.api;
    json["refusal"] = info.refusal;
    json["self_test"] = nullptr;
    if (!examined.refused()) {
        json["self_test"] = {{"passed", examined.test.passed()},
                             {"problem", examined.test.problem},
                             {"images", examined.test.images},
                             {"cells_changed", examined.test.cells_changed},
                             {"seconds", examined.test.seconds}};
    }
    return json;
}

} // namespace

std::string system_text(const SystemDescription& system) {
    std::string text = labelled("zonegrid", ZONEGRID_VERSION);
    text += labelled("system", fmt::format("{}, {}", system.system, system.kernel));
    text +=
        labelled("processor", fmt::format("{}, {} at a time", system.processor, system.processors));
    for (const auto& [name, value] : system.variables) {
        text += labelled("environment", fmt::format("{}={}", name, value));
    }
    return text;
}

std::string drivers_text(const InstalledDrivers& drivers) {
    const DriverLoader& loader = drivers.loader;
    std::string text = fmt::format("\n{}\n", loader.backend);
    text +=
        labelled("  loader", loader.problem.empty()
                                 ? fmt::format("{} found: {}", loader.library, loader.file)
                                 : fmt::format("{} not found: {}", loader.library, loader.problem));
    for (const DriverFile& driver : drivers.files) {
        std::string state = driver.problem;
        if (!driver.library.empty()) {
            state = driver.problem.empty()
                        ? driver.library + " found"
                        : fmt::format("{} {}: {}", driver.library,
                                      driver.foreign ? "is for another processor" : "not found",
                                      driver.problem);
        }
        text += labelled("  driver", fmt::format("{}: {}", driver.file.string(), state));
    }
    if (drivers.files.empty()) {
        text += labelled("  driver",
                         fmt::format("none in {}", fmt::join(texts_of(drivers.places), ", ")));
    }
    return text;
}

std::string files_text(const std::vector<DeviceFile>& files) {
    std::string text = "\ndevice files\n";
    for (const DeviceFile& file : files) {
        text += fmt::format("  {}: {}\n", file.file.string(), state_of(file));
    }
    return files.empty() ? text + "  no /dev/dri/renderD*, kfd, nvidia* or mali*: no GPU's driver\n"
                         : text;
}

std::string device_text(const ExaminedDevice& examined) {
    const auto& info = examined.info;
    const SelfTest& test = examined.test;
    std::string state = "refused: " + info.refusal;
    if (examined.passed()) {
        state = fmt::format("passes the self-test: {} images, {} changed cells in {:.2f} s",
                            test.images, test.cells_changed, test.seconds);
    } else if (examined.failed()) {
        state = "FAILS the self-test: " + test.problem;
    }
    return fmt::format("  {}  {} ({}), {}, {}\n    {}\n", info.id(), info.name, info.type, info.api,
                       info.driver, state);
}

std::string problems_text(const DeviceDiagnosis& diagnosis) {
    std::string text = "\nproblems\n";
    const auto problems = find_problems(diagnosis);
    for (const DeviceProblem& problem : problems) {
        text += fmt::format("  {}\n    remedy: {}\n", problem.problem, problem.remedy);
    }
    return text + (problems.empty() ? "  none\n" : "") +
           fmt::format("\n{}\n", verdict_on(diagnosis));
}

Json doctor_report(const SystemDescription& system, const DeviceDiagnosis& diagnosis) {
    Json json;
    json["zonegrid"] = ZONEGRID_VERSION;
    json["system"] = system.system;
    json["kernel"] = system.kernel;
    json["processor"] = system.processor;
    json["processors"] = system.processors;
    json["environment"] = Json::object();
    for (const auto& [name, value] : system.variables) {
        json["environment"][name] = value;
    }
    json["backends"] = Json::array();
    for (const InstalledDrivers& drivers : diagnosis.drivers) {
        json["backends"].push_back(json_of(drivers));
    }
    json["device_files"] = Json::array();
    for (const DeviceFile& file : diagnosis.files) {
        json["device_files"].push_back({{"file", file.file.string()},
                                        {"readable", file.readable},
                                        {"writable", file.writable},
                                        {"group", file.group}});
    }
    json["missing"] = diagnosis.missing;
    json["devices"] = Json::array();
    for (const ExaminedDevice& examined : diagnosis.devices) {
        json["devices"].push_back(json_of(examined));
    }
    json["problems"] = Json::array();
    for (const DeviceProblem& problem : find_problems(diagnosis)) {
        json["problems"].push_back({{"problem", problem.problem}, {"remedy", problem.remedy}});
    }
    json["verdict"] = verdict_on(diagnosis);
    return json;
}

} // namespace zonegrid
