#pragma once

#include "device/device.h"
#include "kernels/params/local_map.h"
#include "model/window.h"
#include "ops/zone_layout.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace zonegrid::ops {

/// A local map on a device: two bit planes for each zone that an image may reach.
class DeviceLocalMap {
public:
    /// `device` lives longer.
    DeviceLocalMap(device::Device& device, const Window& window);

    /// Empties the map and takes memory for the zones at `places`, each given once. Throws
    /// CapacityError if the device's buffers cannot hold them; then it must be called again before
    /// anything is drawn.
    void reserve(std::span<const std::uint32_t> places);

    /// Slot of the i-th reserved zone. Slot 0 is nobody's: what goes astray lands there.
    [[nodiscard]] static std::uint32_t slot_of(std::size_t i) {
        return static_cast<std::uint32_t>(i) + 1;
    }

    /// What drawing kernels take as their first buffers and parameters.
    [[nodiscard]] std::array<const device::Buffer*, 3> bindings() const {
        return {&*planes_, &slots_, &faults_};
    }
    [[nodiscard]] const params::LocalMapParams& params() const { return params_; }
    [[nodiscard]] const device::Buffer& planes() const { return *planes_; }

    /// How many zones are reserved, and their places, on the device.
    [[nodiscard]] std::uint32_t zone_count() const { return zone_count_; }
    [[nodiscard]] const device::Buffer& places() const { return places_; }

    /// Waits and copies what is said of each cell of the i-th reserved zone: ZG_STATEMENT_*, order
    /// [z][y][x].
    void download_zone(std::size_t i, std::span<std::uint8_t> statements) const;

    /// Waits. Throws std::logic_error if a ray entered a zone that was not reserved.
    void check();

private:
    device::Device& device_;
    ZoneLayout layout_;
    params::LocalMapParams params_;
    std::optional<device::Buffer> planes_;
    device::Buffer slots_;
    device::Buffer places_;
    device::Buffer faults_;
    std::uint32_t zone_count_ = 0;
    std::vector<std::uint32_t> table_; ///< slot by place
};

} // namespace zonegrid::ops
