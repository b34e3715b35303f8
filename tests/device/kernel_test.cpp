#include "device/device.h"

#include "device/embedded_code.h"
#include "kernels/params/fuse_local_map.h"
#include "support/each_device.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The layer's own promises, shown with the kernel that every build has.

namespace zonegrid {
namespace {

using device::Buffer;
using device::Device;
using device::Kernel;
using device::KernelSpec;
using params::FuseLocalMapParams;
using testing::AllOf;
using testing::HasSubstr;

const KernelSpec fusion{"fuse_local_map", "fuse_local_map", 5, sizeof(FuseLocalMapParams), 64};
constexpr std::uint32_t plane_words = 16; // of a zone of 8 cells an edge
constexpr std::uint32_t grid_words = 8 * plane_words;

std::uint32_t repeat_byte(std::uint32_t value) {
    return value * 0x01010101U;
}

/// Zones in which every cell is said to be occupied, paired with as many of the grid; all values 0.
class AllOccupied {
public:
    AllOccupied(Device& device, std::uint32_t zones)
        : device_(device),
          zones_(zones),
          kernel_(device.make_kernel(fusion)),
          local_(filled(zones * 2 * plane_words, 0xFFFFFFFF)),
          grid_(filled(zones * grid_words, 0)),
          occupied_(filled(zones * plane_words, 0)),
          pairs_(filled(3 * zones, 0)),
          changes_(filled(3 * zones, 0)) {
        std::vector<std::uint32_t> pairs(3 * std::size_t{zones});
        for (std::uint32_t i = 0; i < zones; ++i) {
            pairs[3 * i] = zones - 1 - i;
            pairs[3 * i + 1] = i;
        }
        device_.upload(pairs_, 0, std::as_bytes(std::span(pairs)));
    }

    void hit(std::int32_t hit) {
        FuseLocalMapParams params{};
        params.pair_count = zones_;
        params.plane_words = plane_words;
        params.hit = hit;
        params.miss = 1;
        params.limit = 127;
        params.threshold = 100;
        params.zone_bits = 3;
        const std::array<const Buffer*, 5> buffers{&local_, &grid_, &occupied_, &pairs_, &changes_};
        device_.dispatch(kernel_, buffers, std::as_bytes(std::span(&params, 1)), zones_);
    }

    /// The grid's words, and the number of those that differ from `value` in all four cells.
    std::size_t count_other_than(std::uint32_t value) {
        std::vector<std::uint32_t> words(std::size_t{zones_} * grid_words);
        device_.download(grid_, 0, std::as_writable_bytes(std::span(words)));
        return words.size() -
               static_cast<std::size_t>(std::ranges::count(words, repeat_byte(value)));
    }

private:
    Buffer filled(std::uint64_t words, std::uint32_t word) {
        Buffer buffer = device_.make_buffer(4 * words);
        device_.fill(buffer, 0, 4 * words, word);
        return buffer;
    }

    Device& device_;
    std::uint32_t zones_;
    Kernel kernel_;
    Buffer local_;
    Buffer grid_;
    Buffer occupied_;
    Buffer pairs_;
    Buffer changes_;
};

class KernelOf : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, KernelOf, testing::Values("opencl", "vulkan"), backend_name);

TEST_P(KernelOf, SeesWhatTheDispatchBeforeItWrote) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        AllOccupied zones(*device, 40);
        for (int i = 0; i < 90; ++i) {
            zones.hit(1);
        }
        EXPECT_EQ(zones.count_other_than(90), 0U);
    });
}

TEST_P(KernelOf, RunsMoreDispatchesThanABatchHolds) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        AllOccupied zones(*device, 2);
        for (int i = 0; i < 1000; ++i) {
            zones.hit(1);
        }
        EXPECT_EQ(zones.count_other_than(127), 0U);
    });
}

TEST_P(KernelOf, RunsMoreGroupsThanAnAxisHolds) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        AllOccupied zones(*device, 65535 + 2);
        zones.hit(3);
        EXPECT_EQ(zones.count_other_than(3), 0U);
    });
}

TEST_P(KernelOf, TimesEveryDispatch) {
    for_each_device(
        [](const std::unique_ptr<Device>& device) {
            AllOccupied zones(*device, 3);
            for (int i = 0; i < 300; ++i) {
                zones.hit(1);
            }
            const auto times = device->take_times();
            ASSERT_EQ(times.size(), 300U);
            double total_s = 0;
            for (const auto& time : times) {
                EXPECT_EQ(time.kernel, "fuse_local_map.fuse_local_map");
                EXPECT_GE(time.seconds, 0.0);
                EXPECT_LT(time.seconds, 60.0);
                total_s += time.seconds;
            }
            EXPECT_GT(total_s, 0.0);
            EXPECT_TRUE(device->take_times().empty());
        },
        true);
}

TEST_P(KernelOf, HasNoTimesUnlessAskedFor) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        EXPECT_THROW((void)device->take_times(), UsageError);
    });
}

TEST_P(KernelOf, RefusesWhatItDoesNotTake) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const Kernel kernel = device->make_kernel(fusion);
        Buffer buffer = device->make_buffer(4);
        const std::vector<const Buffer*> four(4, &buffer);
        const std::vector<const Buffer*> five(5, &buffer);
        const std::vector<std::byte> params(fusion.params_bytes);
        EXPECT_THROW(device->dispatch(kernel, four, params, 1), UsageError);
        EXPECT_THROW(device->dispatch(kernel, five, std::span(params).first(4), 1), UsageError);
        EXPECT_NO_THROW(device->dispatch(kernel, five, params, 0));

        const auto other = device::open_device(device->info().id());
        EXPECT_THROW(other->dispatch(kernel, five, params, 1), UsageError);
    });
}

TEST_P(KernelOf, RefusesSpecsThatCannotWork) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const auto make = [&](std::uint32_t buffers, std::size_t params_bytes,
                              std::uint32_t items) {
            (void)device->make_kernel(
                {"fuse_local_map", "fuse_local_map", buffers, params_bytes, items});
        };
        EXPECT_THROW(make(5, 132, 64), UsageError);
        EXPECT_THROW(make(5, 6, 64), UsageError);
        EXPECT_THROW(make(5, 24, 0), UsageError);
        EXPECT_THROW(make(device::max_kernel_buffers + 1, 24, 64), CapacityError);
        EXPECT_THROW((void)device->make_kernel({"no_such_kernel", "none", 1, 4, 64}), UsageError);
    });
}

TEST_P(KernelOf, HasNoMoreItemsInAGroupThanTheDeviceAllows) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        auto spec = fusion;
        spec.group_items = 2 * device->info().limits.group_items;
        const Kernel kernel = device->make_kernel(spec);
        EXPECT_GE(kernel.spec().group_items, 1U);
        EXPECT_LE(kernel.spec().group_items, device->info().limits.group_items);
        const auto items = kernel.spec().group_items;
        EXPECT_EQ(kernel.groups_for(items), 1U);
        EXPECT_EQ(kernel.groups_for(items + 1), 2U);
    });
}

/// What every OpenCL device says of this source.
void expect_build_failure(const std::string& source, const std::string& place) {
    for (const auto& info : usable_devices("opencl")) {
        const auto opened = device::open_device(info.id());
        try {
            (void)opened->make_kernel(fusion, {source, {}});
            ADD_FAILURE() << info.id() << " built a broken kernel";
        } catch (const DeviceError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("CL_BUILD_PROGRAM_FAILURE"),
                                            HasSubstr(info.driver), HasSubstr(place)));
        }
    }
}

/// Number of the line of a file, from 1, that contains the text.
std::size_t line_of(const std::string& file, const std::string& text) {
    std::ifstream stream(std::string(ZONEGRID_SOURCE_DIR) + "/" + file);
    std::size_t number = 1;
    for (std::string line; std::getline(stream, line); ++number) {
        if (line.find(text) != std::string::npos) {
            return number;
        }
    }
    return 0;
}

TEST_P(KernelOf, NamesFileAndLineOfWhatDoesNotCompile) {
    if (std::string(GetParam()) != "opencl") {
        return; // Vulkan's shaders are compiled with the library
    }
    const std::string source(
        device::embedded_code("fuse_local_map", "fuse_local_map").opencl_source);
    // In an included file, and after the includes.
    for (const auto& [file, text] :
         {std::pair<std::string, std::string>{"kernels/common.cl", "return popcount(word);"},
          {"kernels/fuse_local_map.cl", "continue;"}}) {
        auto broken = source;
        ASSERT_NE(broken.find(text), std::string::npos) << text;
        broken.replace(broken.find(text), text.size(), "wrong;");
        expect_build_failure(broken, file + ":" + std::to_string(line_of(file, text)));
    }
}

TEST(EmbeddedCode, IsCutToOneKernelLineForLine) {
    const std::string source =
        "int f();\n__kernel void one(int i) {\n    {\n    }\n}\n// between\n"
        "__kernel __attribute__((a(8, 1, 1))) void two(\n    int i) {\n}\nint g();";
    EXPECT_EQ(device::only_entry(source, "one"),
              "int f();\n__kernel void one(int i) {\n    {\n    }\n}\n// between\n\n\n\nint g();");
    EXPECT_EQ(device::only_entry(source, "two"),
              "int f();\n\n\n\n\n// between\n"
              "__kernel __attribute__((a(8, 1, 1))) void two(\n    int i) {\n}\nint g();");
    EXPECT_EQ(device::only_entry("", "one"), "");
}

TEST(EmbeddedCode, NamesLinesThatADriverCountsThroughTheWholeText) {
    const std::string source =
        "#line 1 \"a.cl\"\n// a\n#line 1 \"b.cl\"\nwrong\n#line 3 \"a.cl\"\n"
        "x\nwrong\n";
    EXPECT_EQ(device::name_lines("<kernel>:4:5: error\n<kernel>:7:1: error\nend", source),
              "b.cl:1:5: error\na.cl:4:1: error\nend");
    EXPECT_EQ(device::name_lines("<kernel>:0:1 <kernel>:8:1", source), "<kernel>:0:1 <kernel>:8:1");
    EXPECT_EQ(device::name_lines("b.cl:1:5: error", source), "b.cl:1:5: error");
}

TEST(EmbeddedCode, HasEveryKernelInBothLanguages) {
    std::set<std::string> operations;
    for (const auto& source : device::embedded_sources()) {
        operations.insert(std::string(source.operation));
    }
    EXPECT_TRUE(operations.contains("fuse_local_map"));
    std::set<std::string> with_shader;
    constexpr std::uint32_t spirv_magic = 0x07230203;
    for (const auto& shader : device::embedded_shaders()) {
        with_shader.insert(std::string(shader.operation));
        ASSERT_FALSE(shader.words.empty());
        EXPECT_EQ(shader.words[0], spirv_magic) << shader.operation << "." << shader.entry;
    }
    EXPECT_EQ(with_shader, operations);
}

} // namespace
} // namespace zonegrid
