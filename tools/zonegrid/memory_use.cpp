#include "memory_use.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace zonegrid {

std::uint64_t memory_most_bytes() {
    constexpr std::uint64_t bytes_per_kib = 1024;
    // The kernel's own mark, where /proc is there: getrusage() also counts what ran in the process
    // before this program did.
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::uint64_t kib = 0;
        if (word == "VmHWM:" && status >> kib) {
            return kib * bytes_per_kib;
        }
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * bytes_per_kib;
}

} // namespace zonegrid
