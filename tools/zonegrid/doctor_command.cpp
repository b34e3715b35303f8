#include "command.h"
#include "doctor_report.h"
#include "io/json_text.h"
#include "standard_output.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

namespace zonegrid {
namespace {

constexpr const char* description =
    "Examines what lies between zonegrid and this machine's devices: versions, loaders, drivers,\n"
    "permissions. Then makes a small map on each device and compares it with the reference's.\n"
    "Paste what it prints into a bug report.";

constexpr const char* help_footer =
    "Each problem comes with its remedy. The exit code is 1 if a device fails its self-test, and "
    "0\n"
    "otherwise, also where there is no device: the reference backend needs none. Parts are "
    "printed\n"
    "as they are found: if this ends in the middle, the driver examined next has crashed.\n"
    "\n"
    "Examples:\n"
    "  zonegrid doctor\n"
    "  zonegrid doctor --json > doctor.json\n"
    "\n";

/// Examines part after part; `print` gets each part's text as soon as it is known.
DeviceDiagnosis diagnose(const std::function<void(const std::string&)>& print) {
    DeviceDiagnosis diagnosis;
    diagnosis.files = find_device_files("/dev");
    print(files_text(diagnosis.files));
    for (const auto find : {&find_opencl_drivers, &find_vulkan_drivers}) {
        diagnosis.drivers.push_back(find());
        print(drivers_text(diagnosis.drivers.back()));
    }
    print("\ndevices\n");
    const auto list = device::list_devices();
    diagnosis.missing = list.missing;
    for (const auto& info : list.devices) {
        ExaminedDevice examined{info, {}};
        if (!examined.refused()) {
            examined.test = test_backend(info.id());
        }
        print(device_text(examined));
        diagnosis.devices.push_back(std::move(examined));
    }
    if (list.devices.empty()) {
        print("  none\n");
    }
    print(problems_text(diagnosis));
    return diagnosis;
}

void examine(bool as_json) {
    const SystemDescription system = describe_system();
    const auto print = [as_json](const std::string& text) {
        if (!as_json) {
            write_standard_output(text);
        }
    };
    print(system_text(system));
    const DeviceDiagnosis diagnosis = diagnose(print);
    if (as_json) {
        write_standard_output(json_text(doctor_report(system, diagnosis)));
    }
    if (std::ranges::any_of(diagnosis.devices, &ExaminedDevice::failed)) {
        throw Error(verdict_on(diagnosis));
    }
}

} // namespace

void add_doctor_command(CLI::App& app) {
    const auto as_json = std::make_shared<bool>(false);
    CLI::App* const doctor_app = app.add_subcommand("doctor", description);
    doctor_app->add_flag("--json", *as_json, "print JSON");
    doctor_app->footer(std::string(help_footer) + exit_codes);
    doctor_app->callback([as_json] { examine(*as_json); });
}

} // namespace zonegrid
