#include "io/device_diagnosis.h"

#include <gmock/gmock.h>

namespace zonegrid {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

InstalledDrivers installed(const std::string& backend, const std::string& problem = "") {
    InstalledDrivers drivers;
    drivers.loader = {backend, "libloader.so.1", "", "/usr/lib/libloader.so.1", ""};
    drivers.places = {"/etc"};
    drivers.files.push_back({backend, "/etc/a.icd", "liba.so", problem, false});
    return drivers;
}

ExaminedDevice examined(std::uint32_t index, const std::string& problem) {
    ExaminedDevice examined;
    examined.info.backend = "opencl";
    examined.info.index = index;
    examined.info.name = "Chip";
    examined.info.driver = "Driver 7";
    examined.test.problem = problem;
    return examined;
}

auto problem_with(const std::string& problem, const std::string& remedy) {
    return AllOf(Field(&DeviceProblem::problem, HasSubstr(problem)),
                 Field(&DeviceProblem::remedy, HasSubstr(remedy)));
}

DeviceDiagnosis sound() {
    DeviceDiagnosis diagnosis;
    diagnosis.drivers = {installed("opencl"), installed("vulkan")};
    diagnosis.files.push_back({"/dev/dri/renderD128", true, true, "root", "render", true});
    diagnosis.devices.push_back(examined(0, ""));
    return diagnosis;
}

TEST(DeviceDiagnosis, OfASoundMachineFindsNoProblem) {
    EXPECT_THAT(find_problems(sound()), IsEmpty());
    EXPECT_EQ(verdict_on(sound()), "opencl:0: the reference's map, bit for bit");
}

TEST(DeviceDiagnosis, NamesThePackageOfAMissingLoader) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.drivers[0].loader.problem = "no such file";
    diagnosis.drivers[0].files.clear(); // without a loader, drivers do not matter
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("libloader.so.1", "apt install ocl-icd-libopencl1")));
    diagnosis.drivers[0].loader.variable = "ZONEGRID_OPENCL_LIBRARY";
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("opencl: ", "unset ZONEGRID_OPENCL_LIBRARY")));
}

TEST(DeviceDiagnosis, NamesThePackageOfAMissingDriver) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.drivers[0].files.clear();
    diagnosis.drivers[1].files.clear();
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("opencl: no driver", "apt install pocl-opencl-icd"),
                            problem_with("vulkan: no driver", "apt install mesa-vulkan-drivers")));
}

TEST(DeviceDiagnosis, NamesTheFileWhoseLibraryIsMissing) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.drivers[1] = installed("vulkan", "no such file");
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("/etc/a.icd names liba.so", "dpkg -S /etc/a.icd")));
    diagnosis.drivers[1].files[0].foreign = true; // the 32-bit half of a system
    EXPECT_THAT(find_problems(diagnosis), IsEmpty());
}

TEST(DeviceDiagnosis, NamesTheGroupThatMayUseADevice) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.files[0].writable = false;
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("cannot write", "usermod -aG render $USER")));
    diagnosis.files[0].group = "root"; // nobody is told to join that
    EXPECT_THAT(find_problems(diagnosis), ElementsAre(problem_with("renderD128", "udev")));
}

TEST(DeviceDiagnosis, SaysOnceWhatIsMissing) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.missing = {"opencl: the driver finds no device; connect one"};
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("opencl: the driver finds no device", "connect one")));
    diagnosis.drivers[0].files.clear();
    EXPECT_THAT(find_problems(diagnosis), SizeIs(1));
}

TEST(DeviceDiagnosis, TellsFailedAndRefusedDevicesApart) {
    DeviceDiagnosis diagnosis = sound();
    diagnosis.devices.push_back(examined(1, "cells differ"));
    diagnosis.devices.push_back(examined(2, ""));
    diagnosis.devices[2].info.refusal = "OpenCL 1.2 is needed";
    EXPECT_THAT(find_problems(diagnosis),
                ElementsAre(problem_with("opencl:1 (Chip) fails its self-test: cells differ",
                                         "check --generated 1 --device opencl:1"),
                            problem_with("opencl:2 (Chip) is refused: OpenCL 1.2", "Driver 7")));
    EXPECT_THAT(verdict_on(diagnosis), HasSubstr("opencl:1: not the reference's map"));
    diagnosis.devices.erase(diagnosis.devices.begin(), diagnosis.devices.begin() + 2);
    EXPECT_THAT(verdict_on(diagnosis), HasSubstr("no device can be used"));
}

} // namespace
} // namespace zonegrid
