#include "standard_output.h"

#include "zonegrid/errors.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace zonegrid {

void write_standard_output(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            throw StandardOutputClosed{};
        } else if (errno != EINTR) {
            throw OutputError("standard output: cannot be written (" +
                              std::generic_category().message(errno) +
                              "); check where it is redirected to");
        }
    }
}

} // namespace zonegrid
