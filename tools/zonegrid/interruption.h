#pragma once

#include <array>
#include <csignal>

namespace zonegrid {

/// Thrown by `InterruptionGuard::check`; the command ends by this signal after cleaning up.
struct Interrupted {
    int signal = 0;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP only leave a note that `check` finds. One at a time.
class InterruptionGuard {
public:
    InterruptionGuard();
    InterruptionGuard(const InterruptionGuard&) = delete;
    InterruptionGuard& operator=(const InterruptionGuard&) = delete;
    ~InterruptionGuard();

    /// Throws Interrupted if a signal has come.
    void check() const;

private:
    static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};

    std::array<struct sigaction, signals.size()> previous_{};
};

} // namespace zonegrid
