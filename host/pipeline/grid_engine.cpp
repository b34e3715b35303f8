#include "pipeline/grid_engine.h"

#include "pipeline/device_engine.h"
#include "pipeline/reference_engine.h"

namespace zonegrid {

std::unique_ptr<GridEngine> make_grid_engine(const MapperOptions& options,
                                             const std::optional<Camera>& camera,
                                             const Window& window) {
    if (options.backend == "reference") {
        return std::make_unique<ReferenceEngine>(options, window);
    }
    return std::make_unique<DeviceEngine>(options, camera, window);
}

} // namespace zonegrid
