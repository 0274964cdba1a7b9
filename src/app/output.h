// SPDX-License-Identifier: GPL-3.0-or-later
// Which file the picture goes to, and in which format, by POV-Ray's rules for +O and +F.
#pragma once

#include "app/options.h"

namespace candelabra {

struct Output {
    std::string path;  ///< "-": standard output
    PictureFormat format;
};

/// The format is that of +F, or else of the ending of +O, or else png. A name without the format's
/// ending gets it. Without a name it is the scene's, in the current folder or the folder of +O.
/// Devices and pipes are taken by the name that they have. Reports what does not fit together.
Output output_of(const Options&, Diagnostics&);

/// The folder of the picture, below which the scene may write; "" is the current one, also for
/// standard output, devices and pipes.
std::string folder_of(const Output&);

/// Why a file of this name cannot be written; empty when nothing is known, and for no name.
std::string problem_with_output(const Options&, const std::string& path);

/// Whether a path is standard output (`-`), a device or a pipe: each frame goes there under the
/// same name.
bool is_stream(const std::string& path);

}  // namespace candelabra
