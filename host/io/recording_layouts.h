#pragma once

#include "io/recording.h"

#include <filesystem>
#include <memory>

namespace zonegrid {

// One pair a layout: does the folder look like it, and open it. docs/formats.md describes each.
// Opening throws InputError naming file and line, or UsageError for options that do not apply.

[[nodiscard]] bool is_tum_recording(const std::filesystem::path& folder);
[[nodiscard]] std::unique_ptr<Recording> open_tum_recording(const std::filesystem::path& folder,
                                                            const RecordingOptions& options);

[[nodiscard]] bool is_poses_recording(const std::filesystem::path& folder);
[[nodiscard]] std::unique_ptr<Recording> open_poses_recording(const std::filesystem::path& folder,
                                                              const RecordingOptions& options);

[[nodiscard]] bool is_kitti_recording(const std::filesystem::path& folder);
[[nodiscard]] std::unique_ptr<Recording> open_kitti_recording(const std::filesystem::path& folder,
                                                              const RecordingOptions& options);

[[nodiscard]] bool is_clouds_recording(const std::filesystem::path& folder);
[[nodiscard]] std::unique_ptr<Recording> open_clouds_recording(const std::filesystem::path& folder,
                                                               const RecordingOptions& options);

[[nodiscard]] bool is_plain_recording(const std::filesystem::path& folder);
[[nodiscard]] std::unique_ptr<Recording> open_plain_recording(const std::filesystem::path& folder,
                                                              const RecordingOptions& options);

} // namespace zonegrid
