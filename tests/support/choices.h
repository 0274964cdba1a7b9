// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires of a test, for light strategies to choose among.
#pragma once

#include "world/luminaire_choices.h"

#include <memory>
#include <span>

namespace candelabra {

/// The luminaires must outlive the result.
inline std::shared_ptr<const ChoosableLights> choices(std::span<const Luminaire> luminaires) {
    return std::make_shared<LuminaireChoices>(luminaires);
}

}  // namespace candelabra
