// SPDX-License-Identifier: GPL-3.0-or-later
// The file and the format of the picture, by POV-Ray's rules for +O and +F.
#pragma once

#include "options/options.h"

#include <array>
#include <string>

namespace candelabra {

struct Output {
    std::string path;  ///< "-": standard output
    PictureFormat format;
};

/// Returns the path and format of the picture. The format is that of +F, else that of the extension
/// of +O, else png. A name without the format's extension gets it. Without a name it is that of the
/// scene, in the current folder or the folder of +O. Names of devices and pipes are not changed.
/// Reports contradictions.
Output output_of(const Options&, Diagnostics&);

/// Returns the folder beside the picture to which a scene writes its files: `scene.files`. It is in
/// the current folder if the picture goes to standard output, a device or a pipe.
std::string own_folder(const Output&, const Options&);

/// Describes why the file cannot be written; empty if no problem is known or the path is empty.
std::string problem_with_output(const Options&, const std::string& path);

/// The names of the files that each picture of a run has besides its own, which are numbered as the
/// pictures are. A name may be empty.
std::array<std::string*, 5> files_beside(Options&);

/// Whether a path is standard output (`-`), a device or a pipe. All frames go there under the same
/// name.
bool is_stream(const std::string& path);

}  // namespace candelabra
