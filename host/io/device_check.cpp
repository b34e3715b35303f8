#include "io/device_check.h"

#include "pipeline/stopwatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t every_image = 1;

} // namespace

FlightCheck::FlightCheck(const GeneratedFlight& flight, const std::string& against,
                         ReplayObserver observer)
    : flight_(flight),
      expected_(recipe_on(against)),
      observer_(std::move(observer)),
      steps_(take_steps(flight, {}, expected_, every_image, observer_)) {}

std::optional<MapDifference> FlightCheck::difference_of(const std::string& backend) const {
    return difference_of(recipe_on(backend));
}

std::optional<MapDifference> FlightCheck::difference_of(const GridEngineMaker& engine) const {
    return difference_of(MapRecipe{flight_.options(), engine});
}

MapRecipe FlightCheck::recipe_on(const std::string& backend) const {
    MapRecipe recipe{flight_.options()};
    recipe.options.backend = backend;
    return recipe;
}

std::optional<MapDifference> FlightCheck::difference_of(const MapRecipe& actual) const {
    return find_difference(flight_, {0, flight_.frames().size()}, expected_, steps_, actual,
                           every_image, observer_);
}

SelfTest test_backend(const std::string& backend) {
    SelfTest test;
    Stopwatch stopwatch;
    try {
        for (const std::uint64_t number : self_test_flights) {
            const GeneratedFlight flight(self_test_seed, number);
            const FlightCheck check(flight, "reference");
            const auto difference = check.difference_of(backend);
            test.images += check.images();
            test.cells_changed += check.cells_changed();
            if (difference) {
                test.problem = fmt::format(
                    "{} differ from the reference's after image {} of "
                    "flight {} ({}: {})",
                    difference->what, difference->images, number, difference->operation,
                    difference->detail);
                break;
            }
        }
    } catch (const std::exception& error) { // whatever a driver does is what was asked for
        test.problem = error.what();
        std::ranges::replace(test.problem, '\n', ' '); // of a compiler's log
    }
    test.seconds = stopwatch.lap_s();
    return test;
}

} // namespace zonegrid
