#include "device/device.h"

#include "support/each_device.h"
#include "support/oracle_random.h"
#include "zonegrid/errors.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace zonegrid {
namespace {

using device::Buffer;
using device::Device;

std::vector<std::byte> random_bytes(oracle::Random& random, std::size_t count) {
    std::vector<std::byte> bytes(count);
    for (auto& byte : bytes) {
        byte = static_cast<std::byte>(random.pick(0, 255));
    }
    return bytes;
}

std::vector<std::byte> read(Device& device, const Buffer& buffer, std::uint64_t offset,
                            std::size_t count) {
    std::vector<std::byte> bytes(count);
    device.download(buffer, offset, bytes);
    return bytes;
}

class BufferOf : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, BufferOf, testing::Values("opencl", "vulkan"), backend_name);

TEST_P(BufferOf, GivesBackWhatWasUploaded) {
    // Longer than the pieces in which a device with its own memory is served; sizes that are odd.
    for_each_device([](const std::unique_ptr<Device>& device) {
        oracle::Random random(7);
        for (const std::size_t size : {1U, 3U, 4U, 4097U, (9U << 20U) + 5U}) {
            Buffer buffer = device->make_buffer(size);
            EXPECT_EQ(buffer.bytes(), size);
            const auto bytes = random_bytes(random, size);
            device->upload(buffer, 0, bytes);
            EXPECT_EQ(read(*device, buffer, 0, size), bytes) << size;
        }
    });
}

TEST_P(BufferOf, KeepsWhatLiesAroundAPart) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        oracle::Random random(8);
        Buffer buffer = device->make_buffer(1000);
        auto expected = random_bytes(random, 1000);
        device->upload(buffer, 0, expected);
        for (int i = 0; i < 200; ++i) {
            const auto offset = static_cast<std::uint64_t>(random.pick(0, 999));
            const auto part = random_bytes(
                random, static_cast<std::size_t>(random.pick(0, 1000 - static_cast<int>(offset))));
            device->upload(buffer, offset, part);
            std::copy(part.begin(), part.end(),
                      expected.begin() + static_cast<std::ptrdiff_t>(offset));
        }
        EXPECT_EQ(read(*device, buffer, 0, 1000), expected);
        EXPECT_EQ(read(*device, buffer, 123, 45),
                  std::vector<std::byte>(expected.begin() + 123, expected.begin() + 168));
    });
}

TEST_P(BufferOf, FillsAndUploadsInTheOrderAsked) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        constexpr std::uint32_t word = 0x81020304;
        Buffer buffer = device->make_buffer(64);
        device->fill(buffer, 0, 64, word);
        const std::vector<std::uint32_t> mine{1, 2};
        device->upload(buffer, 8, std::as_bytes(std::span(mine)));
        device->fill(buffer, 12, 4, 9);
        std::vector<std::uint32_t> expected(16, word);
        expected[2] = 1;
        expected[3] = 9;
        std::vector<std::uint32_t> words(16);
        device->download(buffer, 0, std::as_writable_bytes(std::span(words)));
        EXPECT_EQ(words, expected);
    });
}

TEST_P(BufferOf, RefusesWhatLiesOutside) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        Buffer buffer = device->make_buffer(16);
        std::vector<std::byte> bytes(8);
        EXPECT_THROW(device->upload(buffer, 9, bytes), UsageError);
        EXPECT_THROW(device->download(buffer, 17, bytes), UsageError);
        EXPECT_THROW(device->upload(buffer, ~std::uint64_t{0}, bytes), UsageError);
        EXPECT_THROW(device->fill(buffer, 8, 12, 0), UsageError);
        EXPECT_THROW(device->fill(buffer, 2, 4, 0), UsageError);
        EXPECT_THROW(device->fill(buffer, 0, 5, 0), UsageError);
        EXPECT_NO_THROW(device->upload(buffer, 16, {}));
    });
}

TEST_P(BufferOf, RefusesSizesThatNoBufferHas) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        EXPECT_THROW((void)device->make_buffer(0), UsageError);
        EXPECT_THROW((void)device->make_buffer(device->info().limits.buffer_bytes + 1),
                     CapacityError);
    });
}

TEST_P(BufferOf, CountsAgainstTheLimitWhileItLives) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        device::DeviceOptions options;
        options.memory_limit_bytes = 1000;
        const auto device = device::open_device(info.id(), options);
        EXPECT_EQ(device->spare_bytes(), 1000U);
        const Buffer kept = device->make_buffer(600);
        {
            const Buffer gone = device->make_buffer(400);
            EXPECT_EQ(device->held_bytes(), 1000U);
            EXPECT_EQ(device->spare_bytes(), 0U);
            EXPECT_THROW((void)device->make_buffer(1), CapacityError);
        }
        Buffer moved = device->make_buffer(399);
        moved = device->make_buffer(1);
        EXPECT_EQ(device->held_bytes(), 601U);
        EXPECT_THROW((void)device->make_buffer(400), CapacityError);
        EXPECT_NO_THROW((void)device->make_buffer(399));
    }
}

TEST_P(BufferOf, TwoDevicesInOneProcessKeepApart) {
    for_each_device([this](const std::unique_ptr<Device>& device) {
        const auto other = device::open_device(GetParam());
        Buffer mine = device->make_buffer(64);
        Buffer others = other->make_buffer(64);
        device->fill(mine, 0, 64, 1);
        other->fill(others, 0, 64, 2);
        EXPECT_EQ(read(*device, mine, 60, 1).front(), std::byte{1});
        EXPECT_EQ(read(*other, others, 60, 1).front(), std::byte{2});
        EXPECT_THROW(device->fill(others, 0, 64, 1), UsageError);
        std::vector<std::byte> bytes(4);
        EXPECT_THROW(other->download(mine, 0, bytes), UsageError);
    });
}

TEST_P(BufferOf, GoesAwayWhileWorkIsPending) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        Buffer kept = device->make_buffer(64);
        for (std::uint32_t i = 0; i < 50; ++i) {
            Buffer gone = device->make_buffer(1U << 16U);
            device->fill(gone, 0, 1U << 16U, i);
            device->fill(kept, 0, 64, i);
        }
        EXPECT_EQ(read(*device, kept, 0, 1).front(), std::byte{49});
    });
}

} // namespace
} // namespace zonegrid
