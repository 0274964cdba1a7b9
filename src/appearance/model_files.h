// SPDX-License-Identifier: GPL-3.0-or-later
// Files that models have in them or beside them: pictures and light profiles. They are named by the
// model and their number in it. Called by the readers of pictures, of lamps and of models.
#pragma once

#include "meshing/model_import.h"
#include "reading/block.h"

#include <optional>
#include <string>

namespace candelabra {

/// Reads a model of parts and materials, and warns if a file is not beside it. Keeps its files for
/// the functions below. Empty after a diagnostic.
std::optional<UnpackedModel> read_model(OpenBlock&, const Found&);

/// A picture or a light profile of the model, in it or beside it; the first one has the number 0.
/// Empty after a diagnostic.
std::optional<Found> picture_of_model(OpenBlock&, const std::string& model, int number);
std::optional<Found> profile_of_model(OpenBlock&, const std::string& model, int number);

}  // namespace candelabra
