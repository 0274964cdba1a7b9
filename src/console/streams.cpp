// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/streams.h"

#include "picture/file.h"

#include <ostream>
#include <utility>

namespace candelabra {

Streams::Streams(const StreamSettings& settings, std::function<void(std::string_view)> console)
    : settings_(settings), console_(std::move(console)) {
    for (std::size_t i = 0; i < stream_count; ++i) {
        const std::string& file = settings.all[i].file;
        file_of_[i] = i;
        for (std::size_t k = 0; k < i; ++k)
            if (settings.all[k].file == file) file_of_[i] = file_of_[k];
        if (file.empty() || file_of_[i] != i) continue;
        files_[i] = open_growing_file(file);
        if (!files_[i]) problem_ = file;
    }
}

void Streams::say(Stream stream, std::string_view text, std::string_view plain) {
    if (shown(stream)) console_(text);
    const std::size_t which = file_of_[static_cast<std::size_t>(stream)];
    const OpenedFile& file = files_[which];
    if (file && write_all(file.descriptor(), plain) != 0) problem_ = settings_.all[which].file;
}

}  // namespace candelabra
