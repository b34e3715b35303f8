#include "simulation/aircraft.h"
#include "simulation/plants.h"
#include "simulation/shape.h"
#include "simulation/structures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid::testing {
namespace {

/// Every edge is run through once in each direction: no hole, no triangle turned over.
void expect_closed(const Shape& shape, const std::string& what) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{triangle[k], triangle[(k + 1) % 3]}];
        }
    }
    ASSERT_FALSE(edges.empty()) << what;
    for (const auto& [edge, times] : edges) {
        ASSERT_EQ(times, 1) << what;
        ASSERT_TRUE(edges.contains({edge.second, edge.first})) << what;
    }
}

/// The parts of a shape that share no vertex.
std::vector<Shape> parts_of(const Shape& shape) {
    std::vector<std::uint32_t> owner(shape.vertices_m.size());
    for (std::uint32_t i = 0; i < owner.size(); ++i) {
        owner[i] = i;
    }
    const auto root = [&](std::uint32_t i) {
        while (owner[i] != i) {
            i = owner[i];
        }
        return i;
    };
    for (const auto& [a, b, c] : shape.triangles) {
        owner[root(b)] = root(a);
        owner[root(c)] = root(a);
    }
    std::map<std::uint32_t, Shape> parts;
    for (const auto& triangle : shape.triangles) {
        Shape& part = parts[root(triangle[0])];
        part.vertices_m = shape.vertices_m;
        part.triangles.push_back(triangle);
    }
    std::vector<Shape> list;
    for (auto& [name, part] : parts) {
        list.push_back(std::move(part));
    }
    return list;
}

Eigen::AlignedBox3d bounds_of(const Shape& shape) {
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& vertex : shape.vertices_m) {
        bounds.extend(vertex);
    }
    return bounds;
}

double greatest_radius_m(const Shape& shape) {
    double radius_m = 0.0;
    for (const Eigen::Vector3d& vertex : shape.vertices_m) {
        radius_m = std::max(radius_m, vertex.head<2>().norm());
    }
    return radius_m;
}

TEST(Shapes, AreClosedSolidsWhosePartsAllFaceOutward) {
    SeededNumbers numbers(7, 1);
    const std::vector<Eigen::Vector3d> way{{0, 0, 0}, {10, 0, 0}, {20, 3, -1}};
    const std::vector<std::pair<std::string, Shape>> shapes{
        {"box", box({-1, -2, -3}, {1, 2, 3})},
        {"broadleaf", tree_shape({}, Detail::fine, numbers)},
        {"coarse broadleaf", tree_shape({}, Detail::coarse, numbers)},
        {"conifer", tree_shape({.species = Species::conifer}, Detail::fine, numbers)},
        {"coarse conifer", tree_shape({.species = Species::conifer}, Detail::coarse, numbers)},
        {"bush", bush_shape(1.5, 2.0, numbers)},
        {"flat roof", building_shape({})},
        {"gable roof", building_shape({.roof = Roof::gable})},
        {"pole", pole_shape(10.0, 0.3)},
        {"lattice mast", lattice_mast_shape(20.0, 1.5)},
        {"wire", wire_shape({0, 0, -10}, {30, 40, -12}, 1.5, 0.02)},
        {"tunnel", tunnel_shape(way, 8.0, 0.3)},
        {"aeroplane", aircraft_shape(AircraftModel::aeroplane, 8.0, 10.0)},
        {"helicopter", aircraft_shape(AircraftModel::helicopter, 8.0, 9.0)},
    };
    for (const auto& [name, shape] : shapes) {
        expect_closed(shape, name);
        for (const Shape& part : parts_of(shape)) {
            EXPECT_GT(volume_m3(part), 0.0) << name;
        }
    }
}

TEST(Shapes, HaveTheVolumesOfTheirBodies) {
    EXPECT_NEAR(volume_m3(box({-1, -2, -3}, {1, 2, 5})), 2.0 * 4.0 * 8.0, 1e-12);
    // Walls 10 x 6 x (4 + 0.2), roof a prism over 10 x 6 of height 3.
    const Shape house = building_shape({.length_m = 10.0,
                                        .width_m = 6.0,
                                        .eaves_m = 4.0,
                                        .ridge_m = 7.0,
                                        .roof = Roof::gable,
                                        .foundation_m = 0.2});
    EXPECT_NEAR(volume_m3(house), 60.0 * 4.2 + 0.5 * 60.0 * 3.0, 1e-9);
    // A regular polygon of n corners has the area n / 2 sin(2 pi / n) r^2.
    const std::vector<Section> sections{{{0, 0, 0}, 2.0}, {{0, 5, 0}, 2.0}};
    EXPECT_NEAR(volume_m3(tube(sections, 6)), 3.0 * std::sin(std::numbers::pi / 3.0) * 4.0 * 5.0,
                1e-12);
    const std::vector<Eigen::Vector3d> way{{0, 0, 0}, {10, 0, 0}};
    EXPECT_NEAR(volume_m3(tunnel_shape(way, 8.0, 0.5)),
                16.0 * std::sin(std::numbers::pi / 16.0) * (4.5 * 4.5 - 16.0) * 10.0, 1e-9);
}

TEST(Shapes, MoveAndTurnWhereTheyAreAppended) {
    Shape shape = box({0, 0, 0}, {1, 1, 1});
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() =
        Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    placed.translation() = Eigen::Vector3d(10, 20, -30);
    shape.append(box({0, 0, 0}, {3, 1, 1}), placed); // forward becomes right
    EXPECT_NEAR(volume_m3(shape), 4.0, 1e-9);
    EXPECT_TRUE(bounds_of(shape).min().isApprox(Eigen::Vector3d(0, 0, -30)));
    EXPECT_TRUE(bounds_of(shape).max().isApprox(Eigen::Vector3d(10, 23, 1)));
    EXPECT_EQ(parts_of(shape).size(), 2U);
}

TEST(Trees, FillTheirSizesAndNoMore) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SeededNumbers numbers(seed, 0);
        for (const Species species : {Species::broadleaf, Species::conifer}) {
            const TreeSize size{species, 9.0, 5.0, 2.5, 0.4};
            for (const Detail detail : {Detail::coarse, Detail::fine}) {
                const Shape tree = tree_shape(size, detail, numbers);
                EXPECT_NEAR(bounds_of(tree).min().z(), -9.0, 1e-9);
                EXPECT_NEAR(bounds_of(tree).max().z(), 0.3, 1e-9);
                EXPECT_LE(greatest_radius_m(tree), 2.5 + 1e-9);
                EXPECT_GT(greatest_radius_m(tree), 1.9);
                // Below the crown only the trunk is left.
                for (const Eigen::Vector3d& vertex : tree.vertices_m) {
                    if (vertex.z() > -2.5 + 1e-9) {
                        EXPECT_LE(vertex.head<2>().norm(), 0.2 + 1e-9);
                    }
                }
            }
        }
        const Shape bush = bush_shape(1.6, 2.2, numbers);
        EXPECT_NEAR(bounds_of(bush).min().z(), -1.6, 1e-9);
        EXPECT_LE(greatest_radius_m(bush), 1.1 + 1e-9);
        EXPECT_GT(greatest_radius_m(bush), 0.8);
    }
}

TEST(Trees, OfTwoSeedsAreDifferent) {
    SeededNumbers one(1, 0);
    SeededNumbers same(1, 0);
    SeededNumbers two(2, 0);
    const Shape tree = tree_shape({}, Detail::fine, one);
    EXPECT_EQ(tree.vertices_m, tree_shape({}, Detail::fine, same).vertices_m);
    EXPECT_NE(tree.vertices_m, tree_shape({}, Detail::fine, two).vertices_m);
}

/// The middle of the ring `at` of a wire, whose rings have six points.
Eigen::Vector3d middle_of_ring(const Shape& wire, std::size_t at) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 6; ++k) {
        sum += wire.vertices_m[6 * at + k] / 6.0;
    }
    return sum;
}

TEST(Wires, HangAsACatenaryBetweenTheirEnds) {
    // With a = 50 a span of 80 sags by 50 (cosh(40 / 50) - 1), a quarter from the end by
    // 50 (cosh(20 / 50) - 1) less.
    const double sag_m = 50.0 * (std::cosh(0.8) - 1.0);
    const Shape wire = wire_shape({0, 0, -20}, {0, 80, -20}, sag_m, 0.1);
    const std::size_t pieces = (wire.vertices_m.size() - 2) / 6 - 1;
    ASSERT_EQ(pieces % 4, 0U);
    EXPECT_TRUE(middle_of_ring(wire, 0).isApprox(Eigen::Vector3d(0, 0, -20), 1e-9));
    EXPECT_TRUE(middle_of_ring(wire, pieces).isApprox(Eigen::Vector3d(0, 80, -20), 1e-9));
    EXPECT_TRUE(
        middle_of_ring(wire, pieces / 2).isApprox(Eigen::Vector3d(0, 40, sag_m - 20), 1e-9));
    const double quarter_m = sag_m - 50.0 * (std::cosh(0.4) - 1.0);
    EXPECT_TRUE(
        middle_of_ring(wire, pieces / 4).isApprox(Eigen::Vector3d(0, 20, quarter_m - 20), 1e-9));
    for (std::size_t k = 0; k < 6; ++k) { // of the given diameter
        EXPECT_NEAR((wire.vertices_m[6 * 3 + k] - middle_of_ring(wire, 3)).norm(), 0.05, 1e-9);
    }
}

TEST(Wires, ThatAreAlmostStraightAndThatHangDeepAreFoundToo) {
    for (const double sag_m : {0.001, 0.5, 30.0, 100.0}) {
        const Shape wire = wire_shape({0, 0, -20}, {100, 0, -20}, sag_m, 0.01);
        EXPECT_NEAR(bounds_of(wire).max().z(), sag_m - 20.0, 0.011) << sag_m;
        EXPECT_NEAR(bounds_of(wire).min().z(), -20.0, 0.011) << sag_m;
    }
}

TEST(Masts, ReachTheirHeight) {
    EXPECT_NEAR(bounds_of(pole_shape(12.0, 0.4)).min().z(), -12.0, 1e-9);
    EXPECT_NEAR(greatest_radius_m(pole_shape(12.0, 0.4)), 0.2, 1e-9);
    const Shape mast = lattice_mast_shape(24.0, 2.0);
    EXPECT_NEAR(bounds_of(mast).min().z(), -24.0, 0.1); // and half of a cross-piece
    // 4 legs and, in 8 bays, 4 cross-pieces and 4 diagonals each.
    EXPECT_EQ(parts_of(mast).size(), 4U + 8U * 8U);
}

TEST(Aircraft, AreAsLongAndWideAsAskedAndStandOnTheirUndercarriage) {
    for (const AircraftModel model : {AircraftModel::aeroplane, AircraftModel::helicopter}) {
        const Eigen::AlignedBox3d bounds = bounds_of(aircraft_shape(model, 8.0, 11.0));
        EXPECT_NEAR(bounds.min().x(), -4.0, model == AircraftModel::helicopter ? 0.4 : 0.1);
        EXPECT_NEAR(bounds.sizes().y(), 11.0, 0.1);
        EXPECT_NEAR(bounds.max().z(), undercarriage_m(8.0), 1e-9);
    }
}

} // namespace
} // namespace zonegrid::testing
