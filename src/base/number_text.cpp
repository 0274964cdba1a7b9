// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/number_text.h"

namespace candelabra {

std::from_chars_result number_from(const char* first, const char* last, double& value,
                                   std::chars_format format) {
    return std::from_chars(first, last, value, format);
}

std::from_chars_result number_from(const char* first, const char* last, float& value) {
    return std::from_chars(first, last, value);
}

}  // namespace candelabra
