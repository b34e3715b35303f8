#include "support/oracle_segment.h"

#include <algorithm>
#include <cstddef>

namespace zonegrid::oracle {

namespace {

/// A moment on the segment: the fraction `time / over` of its way, and behind it an infinitesimal
/// delay by axis (z least, x most) that settles ties.
struct Moment {
    std::int64_t time = 0;
    std::int64_t over = 1; // > 0
    int delay = 0;
};

constexpr Moment before_start{-1, 1, 0};
constexpr Moment after_end{2, 1, 0};

bool earlier(const Moment& a, const Moment& b) {
    const std::int64_t left = a.time * b.over;
    const std::int64_t right = b.time * a.over;
    return left < right || (left == right && a.delay < b.delay);
}

/// From entering to leaving, the moment of leaving excluded.
struct Stay {
    Moment enter = before_start;
    Moment leave = after_end;
};

std::int64_t cell_of(std::int64_t sub) {
    const std::int64_t rest = ((sub % 256) + 256) % 256;
    return (sub - rest) / 256;
}

/// When the segment is in the slab of cells `cell` on one axis; in half sub-cells, so that centres
/// and borders are whole numbers and no centre is on a border.
Stay stay_in_slab(std::int64_t from, std::int64_t to, std::int64_t cell, int axis) {
    const std::int64_t start = 2 * from + 1;
    const std::int64_t way = 2 * (to - from);
    const auto moment_at = [&](std::int64_t border) {
        const int delay = 3 - axis; // z 1, y 2, x 3
        return way > 0 ? Moment{border - start, way, delay} : Moment{start - border, -way, delay};
    };
    Stay stay;
    const std::int64_t low = 512 * cell;
    const std::int64_t high = 512 * (cell + 1);
    const std::int64_t first = cell_of(from);
    const std::int64_t last = cell_of(to);
    if (cell != first) {
        stay.enter = moment_at(way > 0 ? low : high);
    }
    if (cell != last) {
        stay.leave = moment_at(way > 0 ? high : low);
    }
    return stay;
}

Stay common(const Stay& a, const Stay& b) {
    return {earlier(a.enter, b.enter) ? b.enter : a.enter,
            earlier(a.leave, b.leave) ? a.leave : b.leave};
}

bool exists(const Stay& stay) {
    return earlier(stay.enter, stay.leave);
}

std::array<std::int64_t, 3> coordinates(const CellIndex& cell) {
    return {cell.x, cell.y, cell.z};
}

/// One slab of cells that the segment visits, and when.
struct Slab {
    std::int64_t cell = 0;
    Stay stay;
};

/// All slabs that the segment visits on one axis, in the order of its way.
std::vector<Slab> slabs(const SubCell& from, const SubCell& to, int axis) {
    const auto i = static_cast<std::size_t>(axis);
    const auto [low, high] = std::minmax({cell_of(from[i]), cell_of(to[i])});
    std::vector<Slab> result;
    for (std::int64_t cell = low; cell <= high; ++cell) {
        result.push_back({cell, stay_in_slab(from[i], to[i], cell, axis)});
    }
    if (to[i] < from[i]) {
        std::reverse(result.begin(), result.end());
    }
    return result;
}

/// Calls `visit(slab, common stay)` for the slabs that have a moment in common with `stay`. They
/// follow each other: the first is found by bisection, which only saves asking all the others.
template <class Visit>
void for_each_common(const std::vector<Slab>& slabs, const Stay& stay, Visit&& visit) {
    auto slab = std::partition_point(slabs.begin(), slabs.end(), [&](const Slab& candidate) {
        return !earlier(stay.enter, candidate.stay.leave);
    });
    for (; slab != slabs.end() && earlier(slab->stay.enter, stay.leave); ++slab) {
        visit(*slab, common(stay, slab->stay));
    }
}

} // namespace

CellIndex cell_of(const SubCell& sub) {
    return {static_cast<std::int32_t>(cell_of(sub[0])), static_cast<std::int32_t>(cell_of(sub[1])),
            static_cast<std::int32_t>(cell_of(sub[2]))};
}

bool crossed(const SubCell& from, const SubCell& to, const CellIndex& cell) {
    const auto wanted = coordinates(cell);
    Stay stay;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto [low, high] = std::minmax({cell_of(from[i]), cell_of(to[i])});
        if (wanted[i] < low || wanted[i] > high) {
            return false;
        }
        stay = common(stay, stay_in_slab(from[i], to[i], wanted[i], axis));
    }
    return exists(stay);
}

std::vector<CellIndex> segment_cells(const SubCell& from, const SubCell& to) {
    const auto columns = slabs(from, to, 0);
    const auto rows = slabs(from, to, 1);
    const auto levels = slabs(from, to, 2);
    std::vector<std::pair<Moment, CellIndex>> found;
    for (const Slab& x : columns) {
        for_each_common(rows, x.stay, [&](const Slab& y, const Stay& stay_xy) {
            for_each_common(levels, stay_xy, [&](const Slab& z, const Stay& stay) {
                found.emplace_back(stay.enter, CellIndex{static_cast<std::int32_t>(x.cell),
                                                         static_cast<std::int32_t>(y.cell),
                                                         static_cast<std::int32_t>(z.cell)});
            });
        });
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return earlier(a.first, b.first); });
    std::vector<CellIndex> result;
    for (const auto& [moment, cell] : found) {
        result.push_back(cell);
    }
    return result;
}

} // namespace zonegrid::oracle
