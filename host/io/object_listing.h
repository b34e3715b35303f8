#pragma once

#include "zonegrid/objects.h"

#include <string>

namespace zonegrid {

/// The object's line of docs/model.md, section 10, with its end of line.
[[nodiscard]] std::string object_line(const Object& object);

} // namespace zonegrid
