#include "pipeline/device_memory.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/environment.h"
#include "support/oracle_random.h"
#include "support/oracle_scenes.h"
#include "support/scenes.h"
#include "zonegrid/errors.h"
#include "zonegrid/mapper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

// A device that refuses memory, fails or is lost: one clear error, and a map that either goes on
// with all its cells or says that it has ended.

namespace zonegrid {
namespace {

using oracle::Picture;
using oracle::Random;
using testing::AllOf;
using testing::HasSubstr;

template <class Failure, class Call>
std::string message_of(const Call& call) {
    try {
        call();
    } catch (const Failure& error) {
        return error.what();
    } catch (const std::exception& error) {
        return std::string("another error: ") + error.what();
    }
    return "no error";
}

Camera camera() {
    return scenes::forward_camera(16, 12, 16.0);
}

MapperOptions on(const std::string& device) {
    MapperOptions options;
    options.range_m = 30.0;
    options.zone = 8;
    options.backend = device;
    return options;
}

class MapperFaultsOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, MapperFaultsOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(MapperFaultsOn, SayLimitAndRangeThatFits) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        auto options = on(info.id());
        options.cell_m = 0.5;
        options.device_memory_bytes = 160U << 10U;
        Mapper mapper(options, camera());
        const auto far = scenes::flat_image(camera(), 29.0F);
        const auto message = message_of<CapacityError>([&] {
            scenes::show(mapper, 1.0, {0.0, 0.0, 0.0}, far);
        });
        EXPECT_THAT(message, AllOf(HasSubstr(info.id()), HasSubstr("limit of 0.2 MB"),
                                   HasSubstr("a range of "), HasSubstr("the range of 30 m")));
        EXPECT_TRUE(scenes::values_of(mapper).empty());
        const auto range_m = longest_range_m(options, camera(), options.device_memory_bytes);
        ASSERT_TRUE(range_m);
        EXPECT_THAT(message, HasSubstr(" " + std::to_string(static_cast<int>(*range_m))));

        // The advice is good: in all directions, as far as it goes.
        options.range_m = *range_m;
        Mapper shorter(options, camera());
        for (int i = 0; i < 8; ++i) {
            EXPECT_NO_THROW(scenes::show(shorter, 1.0 + i, {0.0, 0.0, 0.0}, far, 0.8 * i));
        }
        EXPECT_FALSE(scenes::values_of(shorter).empty());

        // Not even the tables of the window.
        options = on(info.id());
        options.cell_m = 0.05;
        options.device_memory_bytes = 1U << 20U;
        EXPECT_THAT(message_of<CapacityError>([&] { const Mapper none(options, camera()); }),
                    AllOf(HasSubstr("limit of 1.0 MB"), HasSubstr("the range of 30 m")));
    }
}

TEST_P(MapperFaultsOn, LeaveTheMapAsItWasWhereMemoryIsRefused) {
    const std::uint64_t flights = case_count(40);
    for (const auto& info : devices()) {
        std::uint64_t refused = 0;
        std::uint64_t compared_after_a_refusal = 0;
        for (std::uint64_t seed = 1; seed <= flights; ++seed) {
            SCOPED_TRACE(describe(info) + ", seed " + std::to_string(seed));
            Random random(seed);
            auto options = on(info.id());
            options.range_m = random.real(6.0, 14.0);
            // Enough for the objects of a zone, but not for every image.
            const auto objects = object_bytes_at_most(options.zone);
            const auto most =
                device_bytes_at_most(make_window(options, camera()), 16 * 12) - objects;
            options.device_memory_bytes =
                objects +
                static_cast<std::uint64_t>(static_cast<double>(most) * random.real(0.02, 0.12));
            Mapper device(options, camera());
            options.backend = "reference";
            Mapper reference(options, camera());
            double x_m = 0.0;
            bool any = false;
            for (int step = 1; step <= 16; ++step) {
                x_m += random.real(-1.0, 1.0) * 12.0;
                const double yaw_rad = random.real(-3.0, 3.0);
                const Eigen::Vector3d position_m(x_m, 0.0, -3.0);
                const auto depths =
                    random.chance(0.3)
                        ? scenes::flat_image(camera(), 4.0F)
                        : oracle::random_depths(random, camera(), options, Picture::step);
                try {
                    scenes::show(device, step, position_m, depths, yaw_rad);
                } catch (const CapacityError&) {
                    // The sensor was there, but nothing was seen.
                    scenes::show(reference, step, position_m, scenes::blind_image(camera()),
                                 yaw_rad);
                    ++refused;
                    any = true;
                    continue;
                }
                scenes::show(reference, step, position_m, depths, yaw_rad);
                ASSERT_EQ(scenes::values_of(reference), scenes::values_of(device))
                    << "step " << step;
                ASSERT_EQ(scenes::difference(reference.objects(), device.objects()), "");
                ASSERT_EQ(reference.height_profile().columns, device.height_profile().columns);
                compared_after_a_refusal += any ? 1U : 0U;
            }
        }
        EXPECT_TRUE(refused > 40U || flights < 40) << refused;
        EXPECT_TRUE(compared_after_a_refusal > 40U || flights < 40) << compared_after_a_refusal;
    }
}

/// The code of the fault, the kind of error that it becomes, and what that must say.
struct Fault {
    const char* fault;
    const char* name;
    const char* remedy;
};

class FaultyLoader {
    Environment opencl_{"ZONEGRID_OPENCL_LIBRARY", ZONEGRID_FAULTY_OPENCL};
    Environment vulkan_{"ZONEGRID_VULKAN_LIBRARY", ZONEGRID_FAULTY_VULKAN};
};

TEST_P(MapperFaultsOn, EndTheMapWhereTheDeviceFails) {
    const FaultyLoader loader;
    const bool opencl = std::string(GetParam()) == "opencl";
    const auto faults =
        opencl ? std::vector<Fault>{{"clEnqueueNDRangeKernel=-5", "CL_OUT_OF_RESOURCES", "reset"},
                                    {"clEnqueueNDRangeKernel=-4",
                                     "CL_MEM_OBJECT_ALLOCATION_FAILURE", "larger cells"}}
               : std::vector<Fault>{
                     {"vkQueueSubmit=-4", "VK_ERROR_DEVICE_LOST", "new map"},
                     {"vkQueueSubmit=-2", "VK_ERROR_OUT_OF_DEVICE_MEMORY", "larger cells"}};
    const auto wall = scenes::flat_image(camera(), 10.0F);
    for (const auto& fault : faults) {
        SCOPED_TRACE(fault.fault);
        Mapper mapper(on(GetParam()), camera());
        scenes::show(mapper, 1.0, {0.0, 0.0, 0.0}, wall);
        {
            const Environment now("ZONEGRID_TEST_FAULT", fault.fault);
            EXPECT_THAT(
                message_of<DeviceError>([&] {
                    scenes::show(mapper, 2.0, {0.0, 0.0, 0.0}, wall);
                }),
                AllOf(HasSubstr(GetParam()), HasSubstr(fault.name), HasSubstr(fault.remedy)));
        }
        // The device answers again, but nobody knows what it did in the meantime.
        for (const auto& message :
             {message_of<UsageError>([&] {
                  scenes::show(mapper, 3.0, {0.0, 0.0, 0.0}, wall);
              }),
              message_of<UsageError>([&] { (void)mapper.objects(); }), message_of<UsageError>([&] {
                  (void)mapper.value({0, 0, 0});
              })}) {
            EXPECT_THAT(message, AllOf(HasSubstr("has ended"), HasSubstr(fault.name)));
        }
    }
}

TEST_P(MapperFaultsOn, GoOnWhereTheDriverRefusesMemory) {
    const FaultyLoader loader;
    const bool opencl = std::string(GetParam()) == "opencl";
    Mapper mapper(on(GetParam()), camera());
    const auto near = scenes::flat_image(camera(), 3.0F);
    const auto far = scenes::flat_image(camera(), 29.0F);
    scenes::show(mapper, 1.0, {0.0, 0.0, 0.0}, near);
    const auto before = scenes::values_of(mapper);
    {
        const Environment now("ZONEGRID_TEST_FAULT",
                              opencl ? "clCreateBuffer=-4" : "vkAllocateMemory=-2");
        EXPECT_THAT(message_of<CapacityError>([&] {
                        scenes::show(mapper, 2.0, {0.0, 0.0, 0.0}, far);
                    }),
                    AllOf(HasSubstr("no more memory"), HasSubstr("shorter range")));
    }
    EXPECT_EQ(scenes::values_of(mapper), before);
    EXPECT_NO_THROW(scenes::show(mapper, 3.0, {0.0, 0.0, 0.0}, far));
    EXPECT_GT(scenes::values_of(mapper).size(), before.size());
}

TEST_P(MapperFaultsOn, ForgetNoZoneThatReturnsWhereMemoryIsRefused) {
    const FaultyLoader loader;
    const bool opencl = std::string(GetParam()) == "opencl";
    Mapper device(on(GetParam()), camera());
    Mapper reference(on("reference"), camera());
    const auto wall = scenes::flat_image(camera(), 10.0F);
    const auto show_both = [&](double time_s, double x_m) {
        scenes::show(reference, time_s, {x_m, 0.0, 0.0}, wall);
        return scenes::show(device, time_s, {x_m, 0.0, 0.0}, wall);
    };
    show_both(1.0, 0.0);
    EXPECT_GT(show_both(2.0, 500.0).zones_left, 0U);
    {
        // Zones return for the first time, and what draws them has no memory yet.
        const Environment now("ZONEGRID_TEST_FAULT",
                              opencl ? "clCreateBuffer=-4" : "vkAllocateMemory=-2");
        EXPECT_THROW(scenes::show(device, 3.0, {0.0, 0.0, 0.0}, wall), CapacityError);
        scenes::show(reference, 3.0, {0.0, 0.0, 0.0}, scenes::blind_image(camera()));
        EXPECT_EQ(scenes::difference(reference.objects(), device.objects()), "");
    }
    EXPECT_GT(show_both(4.0, 0.0).zones_entered, 0U);
    EXPECT_EQ(scenes::values_of(reference), scenes::values_of(device));
    EXPECT_EQ(scenes::difference(reference.objects(), device.objects()), "");
}

TEST(MapperFaults, KeepTwoMapsOnEachDeviceApart) {
    // All at once, image by image in turn: same calls, same maps.
    std::vector<std::string> names{"reference"};
    for (const auto* backend : {"opencl", "vulkan"}) {
        for (const auto& info : usable_devices(backend)) {
            names.push_back(info.id());
            names.push_back(info.id());
        }
    }
    std::vector<Mapper> mappers;
    for (const auto& name : names) {
        mappers.emplace_back(on(name), camera());
    }
    Random random(5);
    for (int step = 1; step <= 12; ++step) {
        const Eigen::Vector3d position_m(random.real(-30.0, 30.0), 0.0, -3.0);
        const double yaw_rad = random.real(-3.0, 3.0);
        const auto depths =
            oracle::random_depths(random, camera(), mappers[0].options(), Picture::step);
        for (auto& mapper : mappers) {
            scenes::show(mapper, step, position_m, depths, yaw_rad);
        }
        for (std::size_t i = 1; i < mappers.size(); ++i) {
            ASSERT_EQ(scenes::values_of(mappers[0]), scenes::values_of(mappers[i])) << names[i];
        }
    }
    EXPECT_FALSE(scenes::values_of(mappers[0]).empty());
}

} // namespace
} // namespace zonegrid
