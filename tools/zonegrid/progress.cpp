#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace zonegrid {
namespace {

constexpr std::chrono::milliseconds between_drawings{200};
constexpr const char* erase_line = "\r\x1b[K";

} // namespace

Progress::Progress(std::uint64_t count, bool wanted, const char* things)
    : count_(count), things_(things), shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) {
        std::fputs(erase_line, stderr);
    }
}

void Progress::show(std::uint64_t done) {
    const auto now = Clock::now();
    if (!shown_ || now < next_) {
        return;
    }
    next_ = now + between_drawings;
    const std::chrono::duration<double> spent = now - start_;
    std::string line = fmt::format("{}{} of {} {}", erase_line, done, count_, things_);
    if (done > 0 && spent.count() > 0.0) {
        const double rate = static_cast<double>(done) / spent.count();
        const auto left_s = static_cast<std::uint64_t>(static_cast<double>(count_ - done) / rate);
        line +=
            fmt::format(", {:.1f} {}/s, {}:{:02} left", rate, things_, left_s / 60, left_s % 60);
    }
    std::fputs(line.c_str(), stderr);
}

} // namespace zonegrid
