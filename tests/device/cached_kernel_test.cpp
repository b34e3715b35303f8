#include "device/device.h"

#include "device/embedded_code.h"
#include "device/sha256.h"
#include "kernels/params/draw_objects.h"
#include "support/each_device.h"
#include "support/environment.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

// Kernels that come out of the cache do what compiled ones do; the files alone are tested in
// kernel_cache_test.cpp.

namespace zonegrid {
namespace {

using device::Buffer;
using device::Device;
using device::KernelSpec;
using params::DrawObjectsParams;

constexpr std::uint32_t cell_value = 5;

KernelSpec spec_of(std::uint32_t group_items) {
    return {"draw_objects", "draw_objects", 3, sizeof(DrawObjectsParams), group_items};
}

device::KernelCode code() {
    return device::embedded_code("draw_objects", "draw_objects");
}

/// Opens the device anew, draws cell 0, and gives the grid's word.
std::uint32_t draw(const std::string& device_id, const device::KernelCode& kernel_code = code(),
                   std::uint32_t group_items = 32) {
    const auto device = device::open_device(device_id);
    const auto kernel = device->make_kernel(spec_of(group_items), kernel_code);
    std::vector<Buffer> buffers;
    for (int i = 0; i < 3; ++i) {
        buffers.push_back(device->make_buffer(64));
        device->fill(buffers.back(), 0, 64, 0);
    }
    const DrawObjectsParams params{1, cell_value};
    const std::array<const Buffer*, 3> bindings{&buffers[0], &buffers[1], &buffers[2]};
    device->dispatch(kernel, bindings, std::as_bytes(std::span(&params, 1)), 1);
    std::uint32_t word = 0;
    device->download(buffers[0], 0, std::as_writable_bytes(std::span(&word, 1)));
    return word;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    return files;
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_file(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

// Of a file: magic and version, key; then length and digest; then what is kept.
constexpr std::size_t name_bytes = 40;
constexpr std::size_t head_bytes = 80;

/// The file that keeps `kept` under the key of `file`.
std::string with_kept(const std::string& file, const std::string& kept) {
    auto changed = file.substr(0, name_bytes);
    for (unsigned i = 0; i < 8; ++i) {
        changed += static_cast<char>(kept.size() >> (8 * i));
    }
    for (const auto byte : device::sha256(std::as_bytes(std::span(kept)))) {
        changed += static_cast<char>(byte);
    }
    return changed + kept;
}

class CachedKernelOf : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, CachedKernelOf, ::testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(CachedKernelOf, DoesTheSameAsOneThatIsCompiled) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        const testing::TemporaryFolder folder;
        const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
        EXPECT_EQ(draw(info.id()), cell_value);
        const auto files = files_in(folder.path());
        ASSERT_EQ(files.size(), 1U);
        const auto kept = read_file(files[0]);
        EXPECT_EQ(draw(info.id()), cell_value);
        EXPECT_EQ(files_in(folder.path()), files);
        EXPECT_EQ(read_file(files[0]), kept);
    }
}

TEST_P(CachedKernelOf, IsReallyTaken) {
    if (std::string(GetParam()) != "opencl") {
        return; // what Vulkan keeps stays unseen: it only saves the driver work
    }
    // Another kernel's machine code, laid under this one's key, runs.
    auto other = std::string(code().opencl_source);
    const std::string value = "pack_cell(params.value";
    ASSERT_NE(other.find(value), std::string::npos);
    other.replace(other.find(value), value.size(), "pack_cell(params.value + 1");
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        const testing::TemporaryFolder folder;
        const testing::TemporaryFolder other_folder;
        {
            const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
            EXPECT_EQ(draw(info.id()), cell_value);
        }
        {
            const Environment cache("ZONEGRID_CACHE_DIR", other_folder.path().string());
            EXPECT_EQ(draw(info.id(), {other, {}}), cell_value + 1);
        }
        const auto file = files_in(folder.path()).at(0);
        const auto others = read_file(files_in(other_folder.path()).at(0));
        write_file(file, with_kept(read_file(file), others.substr(head_bytes)));
        const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
        EXPECT_EQ(draw(info.id()), cell_value + 1);
    }
}

TEST_P(CachedKernelOf, IsCompiledAnewWhereItsFileIsDamagedOrRejected) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        const testing::TemporaryFolder folder;
        const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
        EXPECT_EQ(draw(info.id()), cell_value);
        const auto file = files_in(folder.path()).at(0);
        const auto whole = read_file(file);
        ASSERT_GT(whole.size(), head_bytes);
        auto flipped = whole;
        flipped.back() = static_cast<char>(flipped.back() ^ 1);
        std::vector<std::string> all{"", whole.substr(0, head_bytes / 2),
                                     whole.substr(0, whole.size() - 1), flipped};
        if (info.driver.find("rusticl") == std::string::npos) { // it aborts the program
            // Whole files, of which the driver must see that they are none of its.
            for (const auto& kept : {std::string(), std::string("no machine code at all"),
                                     std::string(5000, '\xff')}) {
                all.push_back(with_kept(whole, kept));
            }
        }
        for (const auto& damaged : all) {
            write_file(file, damaged);
            EXPECT_EQ(draw(info.id()), cell_value);
            EXPECT_EQ(files_in(folder.path()).size(), 1U);
            EXPECT_NE(read_file(file), damaged) << "not replaced";
            EXPECT_EQ(draw(info.id()), cell_value);
        }
    }
}

TEST_P(CachedKernelOf, IsOfOneDeviceOneSourceAndOneGroupSize) {
    const testing::TemporaryFolder folder;
    const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
    std::size_t files = 0;
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        EXPECT_EQ(draw(info.id(), code(), 16), cell_value);
        EXPECT_EQ(files_in(folder.path()).size(), files += 1);
        EXPECT_EQ(draw(info.id(), code(), 32), cell_value);
        EXPECT_EQ(files_in(folder.path()).size(), files += 1);
        if (info.backend == "opencl") {
            EXPECT_EQ(draw(info.id(), {std::string(code().opencl_source) + "\n", {}}), cell_value);
            EXPECT_EQ(files_in(folder.path()).size(), files += 1);
        }
    }
}

TEST_P(CachedKernelOf, IsNotKeptWhereTheCacheIsOffOrCannotBe) {
    const testing::TemporaryFolder folder;
    write_file(folder.path() / "file", "x");
    for (const auto& info : devices()) {
        for (const auto& value : {std::string(), (folder.path() / "file" / "below").string()}) {
            const Environment cache("ZONEGRID_CACHE_DIR", value);
            const Environment home("HOME", folder.path().string());
            const Environment caches("XDG_CACHE_HOME", folder.path().string());
            EXPECT_EQ(draw(info.id()), cell_value);
            EXPECT_FALSE(std::filesystem::exists(folder.path() / "zonegrid"));
        }
    }
}

TEST_P(CachedKernelOf, IsMadeByThreadsAtOnce) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        const testing::TemporaryFolder folder;
        const Environment cache("ZONEGRID_CACHE_DIR", folder.path().string());
        std::array<std::uint32_t, 4> words{};
        std::vector<std::thread> threads;
        for (auto& word : words) {
            threads.emplace_back([&word, &info] {
                word = draw(info.id());
                word = draw(info.id()) == word ? word : 0;
            });
        }
        for (auto& thread : threads) {
            thread.join();
        }
        EXPECT_THAT(words, ::testing::Each(cell_value));
        EXPECT_EQ(files_in(folder.path()).size(), 1U);
    }
}

} // namespace
} // namespace zonegrid
