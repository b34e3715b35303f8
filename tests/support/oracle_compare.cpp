#include "support/oracle_compare.h"

#include "model/constants.h"

#include <cstddef>
#include <optional>
#include <set>
#include <sstream>

namespace zonegrid::oracle {

namespace {

int value_at(const CellValues& values, const CellIndex& cell) {
    const auto found = values.find(cell);
    return found == values.end() ? 0 : found->second;
}

std::int32_t zone_of(std::int32_t cell, std::int32_t zone) {
    return (cell - ((cell % zone) + zone) % zone) / zone;
}

} // namespace

std::string difference(const CellValues& expected, const CellValues& actual, int zone) {
    std::set<CellIndex> cells;
    for (const auto& [cell, value] : expected) {
        cells.insert(cell);
    }
    for (const auto& [cell, value] : actual) {
        cells.insert(cell);
    }
    std::size_t different = 0;
    std::optional<CellIndex> first;
    for (const CellIndex& cell : cells) {
        if (value_at(expected, cell) != value_at(actual, cell)) {
            ++different;
            first = first.value_or(cell);
        }
    }
    if (!first) {
        return {};
    }
    std::ostringstream text;
    text << different << " of " << cells.size() << " cells differ, first (" << first->x << ", "
         << first->y << ", " << first->z << ") in zone (" << zone_of(first->x, zone) << ", "
         << zone_of(first->y, zone) << ", " << zone_of(first->z, zone) << "): expected "
         << value_at(expected, *first) << ", is " << value_at(actual, *first);
    return text.str();
}

CellValues as_values(const StatementMap& statements) {
    CellValues values;
    for (const auto& [cell, statement] : statements) {
        values[cell] = statement == Statement::occupied ? ZG_STATEMENT_OCCUPIED : ZG_STATEMENT_FREE;
    }
    return values;
}

Pose pose_of(const Eigen::Isometry3d& world_from_sensor) {
    Pose pose;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto r = static_cast<Eigen::Index>(row);
        pose.position_m[row] = world_from_sensor.translation()[r];
        for (std::size_t column = 0; column < 3; ++column) {
            pose.rotation[row][column] =
                world_from_sensor.linear()(r, static_cast<Eigen::Index>(column));
        }
    }
    return pose;
}

} // namespace zonegrid::oracle
