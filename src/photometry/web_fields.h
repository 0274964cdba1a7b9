// SPDX-License-Identifier: GPL-3.0-or-later
// The words by which lamps name and turn a photometric web, for the vocabularies of all that have
// one.
#pragma once

#include "photometry/aimed_web.h"
#include "vocabulary/schema.h"

namespace candelabra {

/// T is a WebPlace.
template <class T>
struct WebFields {
    using F = Field<T>;
    static constexpr F ies{
        "ies", &T::ies, item,
        "file of IES LM-63 with its intensity by direction, and its flux if none is given"};
    static constexpr F ldt{"ldt", &T::ldt, item,
                           "name of a photometric file of the format EULUMDAT"};
    static constexpr F profile{
        "profile", &T::profile, item,
        "of a model in the place of `ies`: the number of its light profile, from 0", at_least(0)};
    static constexpr F multiplier{"multiplier", &T::multiplier, item,
                                  "factor on the intensities of the file: 0.5 for a lamp that is "
                                  "dimmed to half of them",
                                  at_least(0)};
    static constexpr F lamp_set{"lamp_set", &T::lamp_set, item,
                                "which set of lamps of EULUMDAT counts", between(1, 100)};
    static constexpr F aim{"aim", &T::aim, item, "where the straight down of the file leads"};
    static constexpr F c0{"c0", &T::c0, item, "where the plane C0 of the file lies"};
    static constexpr F mirrored{"mirrored", &T::mirrored, flag,
                                "the planes C90 and C270 change places"};
};

}  // namespace candelabra
