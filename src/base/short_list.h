// SPDX-License-Identifier: GPL-3.0-or-later
// A list that is nearly always short, and then needs no heap memory: for example the media that a
// ray is in or passes.
#pragma once

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace candelabra {

template <class T, std::size_t room>
using ShortList = boost::container::small_vector<T, room>;

}  // namespace candelabra
