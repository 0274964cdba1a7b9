// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/formats.h"

#include "base/loaded_library.h"
#include "text/harmless.h"
#include "text/message.h"

const Formats* picture_formats(Diagnostics& diagnostics, Span asked_at) {
    static const LoadedFunction library = load_function(formats_library, formats_function);
    if (!library.address) {
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("the library of picture formats cannot be opened: ", library.problem)));
        return nullptr;
    }
    static const Formats* const formats = reinterpret_cast<const Formats* (*)()>(library.address)();
    return formats;
}

std::optional<StoredPicture> read_stored(const std::string& path, Diagnostics& diagnostics,
                                         Span asked_at) {
    const Formats* formats = picture_formats(diagnostics, asked_at);
    if (!formats) return std::nullopt;
    StoredPicture stored;
    const std::string problem = formats->read(path, most_pixels, stored);
    if (problem.empty()) return stored;
    diagnostics.add(
        error(Fault::io, asked_at,
              message("cannot read the picture `", harmless(path), "`: ", harmless(problem))));
    return std::nullopt;
}
