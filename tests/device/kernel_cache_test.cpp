#include "device/kernel_cache.h"

#include "support/environment.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

// The files of the cache alone; what devices make of it: cached_kernel_test.cpp.

namespace zonegrid {
namespace {

using device::KernelCache;
using device::KernelKey;
using testing::TemporaryFolder;
using Bytes = std::vector<std::byte>;

KernelKey key_of(std::string_view text) {
    return KernelKey().add(text);
}

Bytes bytes_of(std::size_t count, std::size_t first = 0) {
    Bytes bytes(count);
    for (std::size_t i = 0; i < count; ++i) {
        bytes[i] = static_cast<std::byte>(first + 7 * i);
    }
    return bytes;
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_file(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

std::size_t count_files(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(KernelCache, GivesBackWhatWasKept) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path() / "made" / "on demand");
    EXPECT_EQ(cache.find(key_of("a")), std::nullopt);
    for (const std::size_t size : {0U, 1U, 100U, 70000U}) {
        cache.keep(key_of("a"), bytes_of(size));
        EXPECT_EQ(cache.find(key_of("a")), bytes_of(size));
    }
    EXPECT_EQ(cache.find(key_of("b")), std::nullopt);
    EXPECT_EQ(count_files(cache.folder()), 1U) << "one file a key, and no temporary one stays";
}

TEST(KernelCache, TellsWhatIsAddedToAKeyApart) {
    EXPECT_EQ(KernelKey().add("ab").add("c").digest(), KernelKey().add("ab").add("c").digest());
    EXPECT_NE(KernelKey().add("ab").add("c").digest(), KernelKey().add("a").add("bc").digest());
    EXPECT_NE(KernelKey().add("ab").digest(), KernelKey().add("ab").add("").digest());
}

TEST(KernelCache, UsesNoFileThatIsCutShortOrLonger) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    const auto key = key_of("a");
    cache.keep(key, bytes_of(50));
    const auto whole = read_file(cache.file_of(key));
    ASSERT_GT(whole.size(), 50U);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        write_file(cache.file_of(key), whole.substr(0, length));
        ASSERT_EQ(cache.find(key), std::nullopt) << "cut to " << length;
    }
    write_file(cache.file_of(key), whole + "x");
    EXPECT_EQ(cache.find(key), std::nullopt);
    write_file(cache.file_of(key), whole);
    EXPECT_EQ(cache.find(key), bytes_of(50));
}

TEST(KernelCache, UsesNoFileWithAFlippedBit) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    const auto key = key_of("a");
    cache.keep(key, bytes_of(50));
    const auto whole = read_file(cache.file_of(key));
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        write_file(cache.file_of(key), damaged);
        ASSERT_EQ(cache.find(key), std::nullopt) << "bit " << bit;
    }
    cache.keep(key, bytes_of(50));
    EXPECT_EQ(read_file(cache.file_of(key)), whole) << "a damaged file is replaced";
}

TEST(KernelCache, UsesNoFileOfAnotherKey) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    cache.keep(key_of("a"), bytes_of(50));
    std::filesystem::copy_file(cache.file_of(key_of("a")), cache.file_of(key_of("b")));
    EXPECT_EQ(cache.find(key_of("b")), std::nullopt);
}

TEST(KernelCache, UsesNoFileOfAnotherUser) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    cache.keep(key_of("a"), bytes_of(50));
    constexpr uid_t somebody = 12345;
    if (chown(cache.file_of(key_of("a")).c_str(), somebody, somebody) != 0) {
        GTEST_SKIP() << "only root can give a file away";
    }
    EXPECT_EQ(cache.find(key_of("a")), std::nullopt);
}

TEST(KernelCache, PassesOverWhatIsNoFile) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    std::filesystem::create_directory(cache.file_of(key_of("folder")));
    cache.keep(key_of("folder"), bytes_of(50));
    EXPECT_EQ(cache.find(key_of("folder")), std::nullopt);
    ASSERT_EQ(mkfifo(cache.file_of(key_of("pipe")).c_str(), 0600), 0);
    EXPECT_EQ(cache.find(key_of("pipe")), std::nullopt);
    EXPECT_EQ(count_files(folder.path()), 2U) << "the temporary file is gone";
}

TEST(KernelCache, KeepsNothingInAFolderThatCannotBe) {
    const TemporaryFolder folder;
    write_file(folder.path() / "file", "x");
    for (const auto& name : {folder.path() / "file", folder.path() / "file" / "below",
                             std::filesystem::path("/proc/zonegrid")}) {
        const KernelCache cache(name);
        cache.keep(key_of("a"), bytes_of(50));
        EXPECT_EQ(cache.find(key_of("a")), std::nullopt) << name;
    }
    const KernelCache off;
    off.keep(key_of("a"), bytes_of(50));
    EXPECT_EQ(off.find(key_of("a")), std::nullopt);
}

TEST(KernelCache, KeepsNothingInAFolderThatMayNotBeWritten) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    cache.keep(key_of("kept"), bytes_of(50));
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0555});
    const bool root = geteuid() == 0; // may write everywhere, so not as root
    constexpr uid_t nobody = 65534;
    ASSERT_EQ(root ? seteuid(nobody) : 0, 0);
    cache.keep(key_of("a"), bytes_of(50));
    EXPECT_EQ(cache.find(key_of("a")), std::nullopt);
    ASSERT_EQ(root ? seteuid(0) : 0, 0);
    EXPECT_EQ(cache.find(key_of("kept")), bytes_of(50));
    EXPECT_EQ(count_files(folder.path()), 1U);
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
}

TEST(KernelCache, LiesWhereTheEnvironmentSays) {
    const Environment home("HOME", "/home/somebody");
    const Environment caches("XDG_CACHE_HOME", "/caches");
    {
        const Environment own("ZONEGRID_CACHE_DIR", "/own");
        EXPECT_EQ(KernelCache::of_user().folder(), "/own");
    }
    {
        const Environment own("ZONEGRID_CACHE_DIR", "");
        EXPECT_EQ(KernelCache::of_user().folder(), "");
    }
    const Environment own("ZONEGRID_CACHE_DIR", std::nullopt);
    EXPECT_EQ(KernelCache::of_user().folder(), "/caches/zonegrid");
    for (const char* none : {"", "relative"}) {
        const Environment other("XDG_CACHE_HOME", none);
        EXPECT_EQ(KernelCache::of_user().folder(), "/home/somebody/.cache/zonegrid");
    }
    const Environment no_caches("XDG_CACHE_HOME", std::nullopt);
    EXPECT_EQ(KernelCache::of_user().folder(), "/home/somebody/.cache/zonegrid");
    const Environment no_home("HOME", std::nullopt);
    EXPECT_EQ(KernelCache::of_user().folder(), "");
}

constexpr std::size_t writers = 4;
constexpr std::size_t large = 100000; // several writes of the file system's

/// Keeps its own bytes again and again, and sees only what some writer kept.
bool write_and_read(const KernelCache& cache, std::size_t writer) {
    bool whole = true;
    for (int round = 0; round < 100; ++round) {
        cache.keep(key_of("a"), bytes_of(large, writer));
        const auto found = cache.find(key_of("a"));
        whole = whole && found && found->size() == large &&
                std::to_integer<std::size_t>(found->front()) < writers &&
                *found == bytes_of(large, std::to_integer<std::size_t>(found->front()));
    }
    return whole;
}

TEST(KernelCache, IsSafeForThreads) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    std::atomic<std::size_t> passed = 0;
    std::vector<std::thread> threads;
    for (std::size_t writer = 0; writer < writers; ++writer) {
        threads.emplace_back([&, writer] { passed += write_and_read(cache, writer) ? 1U : 0U; });
    }
    for (auto& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(passed, writers);
    EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(KernelCache, IsSafeForProcesses) {
    const TemporaryFolder folder;
    const KernelCache cache(folder.path());
    std::vector<pid_t> children;
    for (std::size_t writer = 0; writer < writers; ++writer) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            _exit(write_and_read(cache, writer) ? 0 : 1);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    EXPECT_EQ(count_files(folder.path()), 1U);
}

} // namespace
} // namespace zonegrid
