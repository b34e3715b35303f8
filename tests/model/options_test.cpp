#include "zonegrid/options.h"

#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

namespace zonegrid {
namespace {

using testing::HasSubstr;
using Change = std::function<void(MapperOptions&)>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Options, DefaultsAndTheEdgesOfEveryRangeAreAllowed) {
    EXPECT_NO_THROW(check_options({}));
    for (const Change& change : std::vector<Change>{
             [](auto& o) { o.limit = o.hit = o.miss = o.threshold = 1; },
             [](auto& o) { o.limit = o.hit = o.miss = o.threshold = 127; },
             [](auto& o) { o.zone = 8; },
             [](auto& o) { o.zone = 16; },
             [](auto& o) { o.max_gap_s = 0.0; },
             [](auto& o) { o.span_sigmas = 0.0; },
         }) {
        MapperOptions options;
        change(options);
        EXPECT_NO_THROW(check_options(options));
    }
}

TEST(Options, EachIsRefusedByNameWithItsValueAndTheRule) {
    struct Refusal {
        const char* message;
        Change change;
    };
    const std::vector<Refusal> refusals{
        {"cell is 0: it must be a length above 0", [](auto& o) { o.cell_m = 0.0; }},
        {"cell is -1", [](auto& o) { o.cell_m = -1.0; }},
        {"cell is nan", [](auto& o) { o.cell_m = nan; }},
        {"cell is inf", [](auto& o) { o.cell_m = infinity; }},
        {"range is 0: it must be a distance above 0", [](auto& o) { o.range_m = 0.0; }},
        {"range is nan", [](auto& o) { o.range_m = nan; }},
        {"range is inf", [](auto& o) { o.range_m = infinity; }},
        {"zone is 24: it must be 8, 16 or 32", [](auto& o) { o.zone = 24; }},
        {"zone is 64", [](auto& o) { o.zone = 64; }},
        {"zone is 0", [](auto& o) { o.zone = 0; }},
        {"span-sigmas is -0.5: it must be 0 or more", [](auto& o) { o.span_sigmas = -0.5; }},
        {"span-sigmas is nan", [](auto& o) { o.span_sigmas = nan; }},
        {"limit is 128: it must be in 1 .. 127", [](auto& o) { o.limit = 128; }},
        {"limit is 0", [](auto& o) { o.limit = 0; }},
        {"hit is 9: it must be in 1 .. limit (4)", [](auto& o) { o.hit = 9; }},
        {"hit is 0", [](auto& o) { o.hit = 0; }},
        {"miss is 9: it must be in 1 .. limit (4)", [](auto& o) { o.miss = 9; }},
        {"miss is -1", [](auto& o) { o.miss = -1; }},
        {"threshold is 9: it must be in 1 .. limit (4)", [](auto& o) { o.threshold = 9; }},
        {"threshold is 0", [](auto& o) { o.threshold = 0; }},
        {"max-gap is -0.01: it must be 0 or more", [](auto& o) { o.max_gap_s = -0.01; }},
        {"max-gap is nan", [](auto& o) { o.max_gap_s = nan; }},
        {"backend is warp: it must be reference, opencl or vulkan",
         [](auto& o) { o.backend = "warp"; }},
        {"backend is opencl:: it must be", [](auto& o) { o.backend = "opencl:"; }},
        {"backend is vulkan:x: it must be", [](auto& o) { o.backend = "vulkan:x"; }},
        {"backend is vulkan1: it must be", [](auto& o) { o.backend = "vulkan1"; }},
    };
    for (const auto& [message, change] : refusals) {
        MapperOptions options;
        change(options);
        try {
            check_options(options);
            ADD_FAILURE() << "accepted: " << message;
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr(message));
        }
    }
}

} // namespace
} // namespace zonegrid
