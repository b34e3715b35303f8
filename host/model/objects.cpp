#include "zonegrid/objects.h"

namespace zonegrid {

Eigen::Vector3d Object::centre_m(double cell_m) const {
    const auto count = static_cast<double>(cell_count);
    const auto axis = [&](std::int64_t sum) {
        return (static_cast<double>(sum) / count + 0.5) * cell_m;
    };
    return {axis(cell_sum[0]), axis(cell_sum[1]), axis(cell_sum[2])};
}

} // namespace zonegrid
