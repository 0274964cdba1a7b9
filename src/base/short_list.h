// SPDX-License-Identifier: GPL-3.0-or-later
// A list that is short nearly always, and then needs no memory from the heap: what one ray is in or
// passes.
#pragma once

#include <boost/container/small_vector.hpp>

namespace candelabra {

template <class T, std::size_t room>
using ShortList = boost::container::small_vector<T, room>;

}  // namespace candelabra
