#include <gtest/gtest.h>

#include <cstdlib>

// Part of every test program: what tests compile does not go into the user's cache, but into the
// build folder's, where all of them share it.

namespace zonegrid {
namespace {

class TestCacheFolder : public testing::Environment {
public:
    void SetUp() override { setenv("ZONEGRID_CACHE_DIR", ZONEGRID_TEST_CACHE_DIR, 0); }
};

[[maybe_unused]] const auto* const test_cache_folder =
    testing::AddGlobalTestEnvironment(new TestCacheFolder); // GoogleTest deletes it

} // namespace
} // namespace zonegrid
