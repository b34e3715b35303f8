#pragma once

#include <string_view>

namespace zonegrid {

/// Thrown when whoever reads standard output has closed it (`zonegrid dump DIR | head`).
struct StandardOutputClosed {};

/// Writes all of `text` at once. Throws OutputError if that fails, or StandardOutputClosed.
void write_standard_output(std::string_view text);

} // namespace zonegrid
