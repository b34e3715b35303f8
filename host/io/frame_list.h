#pragma once

#include "io/recording.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// Collects the frames that a list names, in the list's order. Files that do not exist are left
/// out and counted: published excerpts often keep the whole list.
class FrameList {
public:
    /// `list` is the file or folder that names the frames, for messages.
    explicit FrameList(std::filesystem::path list) : list_(std::move(list)) {}

    /// Throws InputError at `where` unless `time_s` is later than that of the frame before.
    void add(double time_s, const std::filesystem::path& file, const std::string& where);

    /// Hands the frames over; adds one warning if some do not exist.
    /// Throws InputError if none exists.
    [[nodiscard]] std::vector<FrameEntry> take(std::vector<RecordingWarning>& warnings);

private:
    std::filesystem::path list_;
    std::vector<FrameEntry> frames_;
    double last_time_s_ = 0.0;
    std::size_t listed_ = 0;
    std::size_t absent_ = 0;
    std::filesystem::path first_absent_;
};

} // namespace zonegrid
