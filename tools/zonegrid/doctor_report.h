#pragma once

#include "io/device_diagnosis.h"
#include "io/system_description.h"

#include <nlohmann/json.hpp>

#include <string>

namespace zonegrid {

// Each part of what `zonegrid doctor` prints, in its order.

[[nodiscard]] std::string system_text(const SystemDescription& system);
[[nodiscard]] std::string drivers_text(const InstalledDrivers& drivers);
[[nodiscard]] std::string files_text(const std::vector<DeviceFile>& files);
[[nodiscard]] std::string device_text(const ExaminedDevice& examined);
[[nodiscard]] std::string problems_text(const DeviceDiagnosis& diagnosis);

/// All of it for machines.
[[nodiscard]] nlohmann::ordered_json doctor_report(const SystemDescription& system,
                                                   const DeviceDiagnosis& diagnosis);

} // namespace zonegrid
