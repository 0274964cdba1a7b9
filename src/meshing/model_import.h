// SPDX-License-Identifier: GPL-3.0-or-later
// Models with their parts and materials, read by a library that is opened when it is first needed,
// in a process of its own (base/apart.h). Used by the reader of `model { }`.
#pragma once

#include "base/function_ref.h"
#include "meshing/packed_model.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>

namespace candelabra {

/// Whether the file's extension is that of a format with parts and materials: glTF, OBJ, FBX,
/// Collada or 3MF.
bool has_parts(std::string_view name);

/// The name of a file beside a model, as the program asks for it; empty if the model must not name
/// it. Names that lead out of the model's folder, such as those of the machine on which the model
/// was made, keep their last part only.
std::string name_beside(std::string_view name);

/// Reads a file beside the model; nothing if there is none. The name is one of name_beside().
using ReadBeside = FunctionRef<std::optional<std::string>(const std::string& name)>;

/// Reads the model; empty, with a diagnostic at the span, when that cannot be done.
std::optional<UnpackedModel> import_model(const Found&, ReadBeside, Diagnostics&, Span asked_at);

}  // namespace candelabra
