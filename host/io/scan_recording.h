#pragma once

#include "io/point_file.h"
#include "io/recording.h"

#include <cstddef>

namespace zonegrid {

/// A recording whose frames are sweeps of a laser scanner.
class ScanRecording final : public Recording {
public:
    ScanRecording(RecordingContents contents, PointFields fields);

    [[nodiscard]] FrameData read_frame(std::size_t index) const override;

private:
    PointFields fields_;
};

/// Throws UsageError if the options describe a camera, which a laser recording has not.
void require_no_camera_options(const RecordingOptions& options, const std::string& layout);

} // namespace zonegrid
