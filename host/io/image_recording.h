#pragma once

#include "io/depth_decoder.h"
#include "io/recording.h"

#include <array>
#include <filesystem>
#include <span>

namespace zonegrid {

/// A recording whose frames are depth images.
class ImageRecording final : public Recording {
public:
    /// `contents.camera` is present and complete.
    ImageRecording(RecordingContents contents, DepthCoding coding);

    [[nodiscard]] FrameData read_frame(std::size_t index) const override;

private:
    DepthDecoder decoder_;
};

/// An ideal pinhole camera that looks forward, with the stereo noise that the options give.
/// `intrinsics` are fx fy cx cy in pixels.
[[nodiscard]] Camera forward_pinhole(ImageSize size, const std::array<double, 4>& intrinsics,
                                     const RecordingOptions& options);

/// The size of the first image among `frames` that can be read.
/// Throws the first image's InputError if none can.
[[nodiscard]] ImageSize size_of_first_image(std::span<const FrameEntry> frames);

} // namespace zonegrid
