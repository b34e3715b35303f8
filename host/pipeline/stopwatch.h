#pragma once

#include <chrono>

namespace zonegrid {

/// Wall-clock time of stages.
class Stopwatch {
public:
    /// Seconds since construction or the last lap.
    double lap_s() {
        const auto now = Clock::now();
        const std::chrono::duration<double> lap = now - last_;
        last_ = now;
        return lap.count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

} // namespace zonegrid
