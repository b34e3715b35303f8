#include "device/device.h"

#include "kernels/params/fuse_local_map.h"
#include "support/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

// Vulkan's validation layer stays silent about everything else only if it is there and looks at
// what it should: here it is shown one mistake of each kind. Run by tools/test.sh, which turns the
// layer on and says in ZONEGRID_VALIDATION_LOG where it writes.

namespace zonegrid {
namespace {

using device::Buffer;
using params::FuseLocalMapParams;
using testing::HasSubstr;

constexpr std::uint32_t plane_words = 16; // of a zone of 8 cells an edge

class ValidationLayer : public testing::Test {
protected:
    void SetUp() override {
        if (log() == nullptr) {
            GTEST_SKIP() << "ZONEGRID_VALIDATION_LOG is not set: run by tools/test.sh";
        }
    }

    /// What the layer wrote since a device was opened: it begins its file anew then.
    static std::string messages() {
        std::ifstream stream(log(), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    /// Fuses a zone of the local map into the grid's zone at `grid_slot`, twice. There is one.
    static void fuse(std::uint32_t grid_slot) {
        const auto device = device::open_device("vulkan");
        const auto kernel = device->make_kernel(
            {"fuse_local_map", "fuse_local_map", 5, sizeof(FuseLocalMapParams), 64});
        const Buffer local = zeros(*device, 2 * plane_words);
        const Buffer grid = zeros(*device, 8 * plane_words);
        const Buffer occupied = zeros(*device, plane_words);
        Buffer pairs = zeros(*device, 3);
        const Buffer changes = zeros(*device, 3);
        device->fill(pairs, 4, 4, grid_slot);
        FuseLocalMapParams params{};
        params.pair_count = 1;
        params.plane_words = plane_words;
        params.hit = 1;
        params.miss = 1;
        params.limit = 8;
        params.threshold = 2;
        params.zone_bits = 3;
        const std::array<const Buffer*, 5> buffers{&local, &grid, &occupied, &pairs, &changes};
        for (int i = 0; i < 2; ++i) {
            device->dispatch(kernel, buffers, std::as_bytes(std::span(&params, 1)), 1);
        }
        device->finish();
    }

private:
    static const char* log() { return std::getenv("ZONEGRID_VALIDATION_LOG"); }

    /// All bits of the local map say something, so that nothing is passed over.
    static Buffer zeros(device::Device& device, std::uint64_t words) {
        Buffer buffer = device.make_buffer(4 * words);
        device.fill(buffer, 0, 4 * words, words == 2 * plane_words ? ~0U : 0);
        return buffer;
    }
};

TEST_F(ValidationLayer, IsSilentAboutWhatIsRight) {
    fuse(0);
    EXPECT_EQ(messages(), "");
}

TEST_F(ValidationLayer, ReportsAWrongStructure) {
    const Environment loader("ZONEGRID_VULKAN_LIBRARY", ZONEGRID_FAULTY_VULKAN);
    const Environment fault("ZONEGRID_TEST_FAULT", "vkCreateFence=1");
    fuse(0);
    EXPECT_THAT(messages(), HasSubstr("VUID-VkFenceCreateInfo-sType-sType"));
}

TEST_F(ValidationLayer, ReportsAMissingBarrier) {
    const Environment loader("ZONEGRID_VULKAN_LIBRARY", ZONEGRID_FAULTY_VULKAN);
    const Environment fault("ZONEGRID_TEST_FAULT", "vkCmdPipelineBarrier=1");
    fuse(0);
    EXPECT_THAT(messages(), HasSubstr("SYNC-HAZARD"));
}

TEST_F(ValidationLayer, ReportsAShaderThatWritesOutsideABuffer) {
    fuse(5);
    EXPECT_THAT(messages(), HasSubstr("out of bounds"));
}

} // namespace
} // namespace zonegrid
