#include "io/object_listing.h"

#include "io/hexadecimal.h"

#include <fmt/format.h>

namespace zonegrid {

std::string object_line(const Object& object) {
    const auto& [id, count, low, high, sum, octree, prism] = object;
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", id.x, id.y, id.z, count,
                       low.x, low.y, low.z, high.x, high.y, high.z, sum[0], sum[1], sum[2],
                       to_hexadecimal(octree), to_hexadecimal(prism));
}

} // namespace zonegrid
