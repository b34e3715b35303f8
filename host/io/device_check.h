#pragma once

#include "io/generated_flight.h"
#include "io/map_comparison.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// A flight made by one way to compute, to be flown by others: after every image cells, objects
/// with boxes, octrees and prisms, and the height profile are compared. Counts what was compared.
class FlightCheck {
public:
    /// Flies `flight` by the backend `against`. `observer` is called before every image, here and
    /// in `difference_of`. Throws what the Mapper and the observer throw.
    FlightCheck(
        const GeneratedFlight& flight, const std::string& against,
        ReplayObserver observer = [](const ReplaySummary&) {});

    /// Flies it by `backend`; nothing if the maps are equal.
    [[nodiscard]] std::optional<MapDifference> difference_of(const std::string& backend) const;
    /// The same on an engine of the caller's.
    [[nodiscard]] std::optional<MapDifference> difference_of(const GridEngineMaker& engine) const;

    [[nodiscard]] std::uint64_t cells_changed() const { return steps_.back().cells_changed; }
    [[nodiscard]] std::size_t images() const { return steps_.size() - 1; }

private:
    [[nodiscard]] MapRecipe recipe_on(const std::string& backend) const;
    [[nodiscard]] std::optional<MapDifference> difference_of(const MapRecipe& actual) const;

    const GeneratedFlight& flight_;
    MapRecipe expected_;
    ReplayObserver observer_;
    std::vector<MapStep> steps_;
};

/// What a self-test found.
struct SelfTest {
    std::string problem; ///< empty: passed
    std::size_t images = 0;
    std::uint64_t cells_changed = 0;
    double seconds = 0.0;
    [[nodiscard]] bool passed() const { return problem.empty(); }
};

/// The generated flights of the self-test. The faults that they find are asserted by
/// tests/io/device_check_test.cpp.
inline constexpr std::uint64_t self_test_seed = 1;
inline constexpr std::array<std::uint64_t, 2> self_test_flights{0, 4};

/// Flies these, one with a camera and one with a scanner, by `backend` and compares with the
/// reference. What the driver throws is the problem; nothing is thrown.
[[nodiscard]] SelfTest test_backend(const std::string& backend);

} // namespace zonegrid
