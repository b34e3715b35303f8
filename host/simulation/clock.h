#pragma once

#include "simulation/counted_numbers.h"

#include <vector>

namespace zonegrid {

/// When a sensor that nothing triggers measures between 0 and `duration_s`: every 1 / `rate_hz`
/// from a random phase, each time off by up to a fiftieth of that. Times are whole microseconds and
/// strictly increasing.
[[nodiscard]] std::vector<double> clock_times(double rate_hz, double duration_s,
                                              const CountedNumbers& numbers);

} // namespace zonegrid
