#include "io/new_folder.h"

#include "zonegrid/errors.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& problem,
                       const std::string& remedy) {
    throw OutputError(folder.string() + ": " + problem + "; " + remedy);
}

/// The target without links and trailing slashes, so that it has a parent and a name.
fs::path resolve(const fs::path& target) {
    std::error_code error;
    fs::path resolved = fs::weakly_canonical(fs::absolute(target, error), error);
    if (error) {
        fail(target, "the name cannot be used (" + error.message() + ")", "give another folder");
    }
    return resolved.has_filename() ? resolved : resolved.parent_path();
}

/// Throws unless the existing `target` consists of files that may go.
void require_replaceable(const fs::path& target, std::span<const std::string_view> replaceable) {
    std::error_code error;
    if (!fs::is_directory(target, error)) {
        fail(target, "a file stands where the folder belongs", "give another name for the folder");
    }
    if (replaceable.empty()) {
        fail(target, "the folder exists", "give --overwrite to replace it, or another folder");
    }
    for (fs::directory_iterator entry(target, error); !error && entry != fs::directory_iterator{};
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (std::ranges::find(replaceable, name) == replaceable.end()) {
            fail(target, fmt::format("it holds {}, which zonegrid did not write", name),
                 "move that away or give another folder");
        }
    }
    if (error) {
        fail(target, "the folder cannot be read (" + error.message() + ")",
             "check its permissions or give another folder");
    }
}

/// A folder made beside `target` that did not exist before.
fs::path make_partial(const fs::path& target) {
    for (int attempt = 0;; ++attempt) {
        fs::path partial = target;
        partial += fmt::format(".partial-{}", ::getpid());
        if (attempt > 0) {
            partial += fmt::format("-{}", attempt); // left by a killed process of the same number
        }
        std::error_code error;
        if (fs::create_directory(partial, error)) {
            return partial;
        }
        if (error) {
            fail(target, "the folder cannot be made (" + error.message() + ")",
                 fmt::format("check the permissions and the space left in {}",
                             target.parent_path().string()));
        }
    }
}

/// Swaps two folders, in one step where the file system can. Returns an error number or 0.
int exchange(const fs::path& first, const fs::path& second) {
    if (::renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0) {
        return 0;
    }
    if (errno != EINVAL && errno != ENOSYS) {
        return errno;
    }
    fs::path aside = first;
    aside += "-old";
    if (::rename(second.c_str(), aside.c_str()) != 0) {
        return errno;
    }
    if (::rename(first.c_str(), second.c_str()) != 0) {
        const int reason = errno;
        ::rename(aside.c_str(), second.c_str());
        return reason;
    }
    return ::rename(aside.c_str(), first.c_str()) == 0 ? 0 : errno;
}

} // namespace

NewFolder::NewFolder(const fs::path& target, std::span<const std::string_view> replaceable)
    : target_(resolve(target)), may_replace_(!replaceable.empty()) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(target_, error))) {
        require_replaceable(target_, replaceable);
    }
    if (!fs::is_directory(target_.parent_path(), error)) {
        fail(target, fmt::format("its parent {} is no folder", target_.parent_path().string()),
             "make that first or give another folder");
    }
    partial_ = make_partial(target_);
}

NewFolder::~NewFolder() {
    std::error_code error; // nobody is left to tell
    fs::remove_all(partial_, error);
}

void NewFolder::put_in_place() {
    // RENAME_NOREPLACE: a folder that appeared meanwhile is not replaced unasked.
    int reason = 0;
    if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) != 0) {
        reason = errno;
    }
    if (reason == EINVAL || reason == ENOSYS) { // the file system cannot promise that
        reason = ::rename(partial_.c_str(), target_.c_str()) == 0 ? 0 : errno;
    }
    if ((reason == EEXIST || reason == ENOTEMPTY) && may_replace_) {
        reason = exchange(partial_, target_);
    }
    if (reason != 0) {
        fail(target_,
             fmt::format("the folder cannot be put in place ({})",
                         std::generic_category().message(reason)),
             "give another folder");
    }
}

} // namespace zonegrid
