// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/colour.h"

#include "base/elementary.h"

namespace candelabra {

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * math::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : math::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace candelabra
