#pragma once

#include <string>
#include <utility>
#include <vector>

namespace zonegrid {

/// The machine that zonegrid runs on, in the words of its own system.
struct SystemDescription {
    std::string system;      ///< "Debian GNU/Linux 12 (bookworm)"
    std::string kernel;      ///< "Linux 6.1.0-18-amd64 x86_64"
    std::string processor;   ///< "AMD Ryzen 7 5800X 8-Core Processor"
    unsigned processors = 0; ///< that run at a time
    /// What of the environment decides about drivers, sorted: names and values.
    std::vector<std::pair<std::string, std::string>> variables;
};

[[nodiscard]] SystemDescription describe_system();

} // namespace zonegrid
