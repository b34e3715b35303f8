#pragma once

#include <chrono>
#include <cstdint>

namespace zonegrid {

/// A line on standard error that says how far a run over images, or other things, is. Silent unless
/// that is a terminal; erased at the end.
class Progress {
public:
    Progress(std::uint64_t count, bool wanted, const char* things = "images");
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /// Called as often as one is done; draws a few times a second.
    void show(std::uint64_t done);

private:
    using Clock = std::chrono::steady_clock;

    std::uint64_t count_;
    const char* things_;
    bool shown_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
};

} // namespace zonegrid
