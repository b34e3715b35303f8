#include "simulation/shape.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace zonegrid {
namespace {

void cap(Shape& shape, const Ring& ring, std::uint32_t first, bool faces_forward) {
    const auto size = static_cast<std::uint32_t>(ring.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : ring) {
        mean += point / static_cast<double>(size);
    }
    const auto centre = static_cast<std::uint32_t>(shape.vertices_m.size());
    shape.vertices_m.push_back(mean);
    for (std::uint32_t k = 0; k < size; ++k) {
        const std::uint32_t here = first + k;
        const std::uint32_t next = first + (k + 1) % size;
        if (faces_forward) {
            shape.triangles.push_back({centre, here, next});
        } else {
            shape.triangles.push_back({centre, next, here});
        }
    }
}

} // namespace

void Shape::append(const Shape& other, const Eigen::Isometry3d& placed) {
    const auto first = static_cast<std::uint32_t>(vertices_m.size());
    for (const Eigen::Vector3d& vertex : other.vertices_m) {
        vertices_m.push_back(placed * vertex);
    }
    for (const auto& [a, b, c] : other.triangles) {
        triangles.push_back({first + a, first + b, first + c});
    }
}

Shape lofted(std::span<const Ring> rings, Ends ends) {
    Shape shape;
    const auto size = static_cast<std::uint32_t>(rings.front().size());
    const auto count = static_cast<std::uint32_t>(rings.size());
    for (const Ring& ring : rings) {
        assert(ring.size() == size && size >= 3);
        shape.vertices_m.insert(shape.vertices_m.end(), ring.begin(), ring.end());
    }
    const std::uint32_t strips = ends == Ends::joined ? count : count - 1;
    for (std::uint32_t i = 0; i < strips; ++i) {
        const std::uint32_t from = i * size;
        const std::uint32_t to = (i + 1) % count * size;
        for (std::uint32_t k = 0; k < size; ++k) {
            const std::uint32_t next = (k + 1) % size;
            shape.triangles.push_back({from + k, from + next, to + next});
            shape.triangles.push_back({from + k, to + next, to + k});
        }
    }
    if (ends == Ends::capped) {
        cap(shape, rings.front(), 0, false);
        cap(shape, rings.back(), (count - 1) * size, true);
    }
    return shape;
}

std::vector<Ring> tube_rings(std::span<const Section> sections, int sides,
                             const std::function<double()>& roughness) {
    assert(sections.size() >= 2);
    std::vector<Ring> rings;
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = i + 1 == sections.size() ? i : i + 1;
        const Eigen::Vector3d way =
            (sections[after].centre_m - sections[before].centre_m).normalized();
        if (i == 0) {
            side = way.unitOrthogonal();
        }
        side = (side - side.dot(way) * way).normalized(); // turned no more than the way turns
        const Eigen::Vector3d across = way.cross(side);
        Ring ring;
        for (int k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            const double radius_m = sections[i].radius_m * roughness();
            ring.push_back(sections[i].centre_m +
                           radius_m * (std::cos(angle) * side + std::sin(angle) * across));
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

Shape tube(std::span<const Section> sections, int sides) {
    return lofted(tube_rings(sections, sides));
}

Shape box(const Eigen::Vector3d& least_m, const Eigen::Vector3d& most_m) {
    const auto ring_at = [&](double x) {
        return Ring{{x, least_m.y(), least_m.z()},
                    {x, most_m.y(), least_m.z()},
                    {x, most_m.y(), most_m.z()},
                    {x, least_m.y(), most_m.z()}};
    };
    return lofted(std::vector{ring_at(least_m.x()), ring_at(most_m.x())});
}

double volume_m3(const Shape& shape) {
    double sum = 0.0;
    for (const auto& [a, b, c] : shape.triangles) {
        sum += shape.vertices_m[a].dot(shape.vertices_m[b].cross(shape.vertices_m[c])) / 6.0;
    }
    return sum;
}

} // namespace zonegrid
