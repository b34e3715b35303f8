#include "interruption.h"

namespace zonegrid {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t noted_signal = 0; // NOLINT(*-avoid-non-const-global-variables)

void note(int signal) {
    noted_signal = signal;
}

} // namespace

InterruptionGuard::InterruptionGuard() {
    noted_signal = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &previous_[i]);
        if (previous_[i].sa_handler != SIG_IGN) { // nohup stays in force
            sigaction(signals[i], &action, nullptr);
        }
    }
}

InterruptionGuard::~InterruptionGuard() {
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], &previous_[i], nullptr);
    }
}

void InterruptionGuard::check() const {
    if (noted_signal != 0) {
        throw Interrupted{noted_signal};
    }
}

} // namespace zonegrid
