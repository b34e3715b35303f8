#pragma once

#include "support/oracle_local_map.h"

#include <map>
#include <string>

namespace zonegrid::oracle {

using CellValues = std::map<CellIndex, int>;

/// Empty if both hold the same values other than 0; else the first cell that differs, its zone,
/// both values, and how many differ.
[[nodiscard]] std::string difference(const CellValues& expected, const CellValues& actual,
                                     int zone);

/// Statements as the numbers the library uses (ZG_STATEMENT_*).
[[nodiscard]] CellValues as_values(const StatementMap& statements);

/// A pose of the public types as the oracle holds it.
[[nodiscard]] Pose pose_of(const Eigen::Isometry3d& world_from_sensor);

} // namespace zonegrid::oracle
