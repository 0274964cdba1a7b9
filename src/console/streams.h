// SPDX-License-Identifier: GPL-3.0-or-later
// The program's output by kind, as POV-Ray divides it. Each kind can be hidden from the console and
// written to a file.
#pragma once

#include "options/stream_settings.h"
#include "text/opened_file.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace candelabra {

class Streams {
public:
    /// Truncates the files; streams with the same file share it.
    Streams(const StreamSettings&, std::function<void(std::string_view)> console);

    /// Returns the file that cannot be written to, at the start or later, or "".
    const std::string& problem() const { return problem_; }
    bool shown(Stream stream) const { return settings_[stream].shown; }
    /// `plain`: the text without colours, for files.
    void say(Stream, std::string_view text, std::string_view plain);

private:
    StreamSettings settings_;
    std::function<void(std::string_view)> console_;
    std::array<OpenedFile, stream_count> files_;
    std::array<std::size_t, stream_count> file_of_{};  ///< index in files_
    std::string problem_;
};

}  // namespace candelabra
