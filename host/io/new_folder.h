#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace zonegrid {

/// A folder that appears whole or not at all: it is filled beside its place under the name
/// `<target>.partial-<process>` and renamed at the end. Unless it is put in place, it is removed.
class NewFolder {
public:
    /// `replaceable` are the names that a folder which `put_in_place` may replace consists of: one
    /// that holds anything else is not deleted. An empty list: an existing target is refused.
    /// Throws OutputError if the target exists and may not be replaced, or its parent is missing or
    /// cannot be written.
    NewFolder(const std::filesystem::path& target, std::span<const std::string_view> replaceable);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    /// Where to write until then.
    [[nodiscard]] const std::filesystem::path& path() const { return partial_; }

    /// Renames to the target; what was there is removed after that.
    /// Throws OutputError, leaving the old target as it was.
    void put_in_place();

private:
    std::filesystem::path target_;
    std::filesystem::path partial_;
    bool may_replace_ = false;
};

} // namespace zonegrid
