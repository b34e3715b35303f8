#include "simulation/clock.h"

#include <cmath>

namespace zonegrid {
namespace {

constexpr double jitter_share = 0.02;
constexpr double ticks_per_s = 1e6;

} // namespace

std::vector<double> clock_times(double rate_hz, double duration_s, const CountedNumbers& numbers) {
    std::vector<double> times_s;
    // Number 0 is the phase; it leaves room for the first jitter.
    const double phase = jitter_share + (1.0 - 2.0 * jitter_share) * numbers.share(0);
    for (std::uint64_t i = 0;; ++i) {
        const double jitter = jitter_share * (2.0 * numbers.share(i + 1) - 1.0);
        const double time_s = (static_cast<double>(i) + phase + jitter) / rate_hz;
        if (time_s > duration_s) {
            return times_s;
        }
        times_s.push_back(std::round(time_s * ticks_per_s) / ticks_per_s);
    }
}

} // namespace zonegrid
