#include "io/frame_list.h"

#include "io/text_list.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace zonegrid {

void FrameList::add(double time_s, const std::filesystem::path& file, const std::string& where) {
    if (listed_ > 0) {
        require_later(last_time_s_, time_s, where);
    }
    last_time_s_ = time_s;
    ++listed_;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) {
        frames_.push_back({time_s, file, where});
        return;
    }
    if (absent_ == 0) {
        first_absent_ = file;
    }
    ++absent_;
}

std::vector<FrameEntry> FrameList::take(std::vector<RecordingWarning>& warnings) {
    if (frames_.empty()) {
        throw InputError(list_.string(),
                         listed_ == 0
                             ? std::string("no frame is listed")
                             : fmt::format("none of the {} frames listed exists (the first is {})",
                                           listed_, first_absent_.string()),
                         "copy the frames beside the list");
    }
    if (absent_ > 0) {
        warnings.push_back(
            {list_.string(),
             fmt::format("{} of {} frames listed do not exist and are skipped (the first is {})",
                         absent_, listed_, first_absent_.string())});
    }
    return std::exchange(frames_, {});
}

} // namespace zonegrid
