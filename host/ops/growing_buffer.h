#pragma once

#include "device/device.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace zonegrid::ops {

/// A buffer that grows to what it must hold. Holds at least a word: a kernel's buffers must exist.
class GrowingBuffer {
public:
    /// `device` lives longer.
    explicit GrowingBuffer(device::Device& device) : device_(device) {}

    /// Makes room for `bytes`; if it had less, its contents are lost. Throws CapacityError beyond
    /// what a buffer of the device may hold.
    device::Buffer& reserve(std::uint64_t bytes) {
        bytes = std::max(bytes, std::uint64_t{sizeof(std::uint32_t)});
        if (!buffer_ || buffer_->bytes() < bytes) {
            // Twice what is needed, so that a growing map does not come here every image; but not
            // where memory is scarce.
            const std::uint64_t most =
                std::min(device_.info().limits.buffer_bytes, device_.spare_bytes() / 64);
            buffer_.reset();
            buffer_.emplace(device_.make_buffer(2 * bytes <= most ? 2 * bytes : bytes));
        }
        return *buffer_;
    }

    template <class Element>
    device::Buffer& upload(std::span<const Element> elements) {
        reserve(elements.size_bytes());
        if (!elements.empty()) {
            device_.upload(*buffer_, 0, std::as_bytes(elements));
        }
        return *buffer_;
    }

    template <class Element>
    void download(std::span<Element> elements) const {
        if (!elements.empty()) {
            device_.download(*buffer_, 0, std::as_writable_bytes(elements));
        }
    }

    /// What was reserved last.
    [[nodiscard]] const device::Buffer& get() const { return *buffer_; }

private:
    device::Device& device_;
    std::optional<device::Buffer> buffer_;
};

} // namespace zonegrid::ops
