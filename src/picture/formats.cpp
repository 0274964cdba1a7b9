// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/formats.h"

#include "text/harmless.h"
#include "text/message.h"

#include <dlfcn.h>

namespace {

struct Opened {
    const Formats* formats = nullptr;
    std::string problem;
};

Opened open_library() {
    // Found beside the program or where it was installed: the program's run path says.
    void* const library = dlopen(formats_library, RTLD_NOW | RTLD_LOCAL);
    void* const entry = library ? dlsym(library, formats_function) : nullptr;
    if (!entry) return {nullptr, dlerror()};
    return {reinterpret_cast<const Formats* (*)()>(entry)(), {}};
}

}  // namespace

const Formats* picture_formats(Diagnostics& diagnostics, Span asked_at) {
    static const Opened opened = open_library();
    if (!opened.formats)
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("the library of picture formats cannot be opened: ", opened.problem)));
    return opened.formats;
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
