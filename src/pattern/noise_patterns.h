// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of noise, or of sums of noise: bozo and its variants, granite, wrinkles and agate.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Bozo {
    static const ItemInfo vocabulary;
};

struct Spotted {
    static const ItemInfo vocabulary;
};

struct Bumps {
    static const ItemInfo vocabulary;
};

struct Dents {
    static const ItemInfo vocabulary;
};

struct Wrinkles {
    static const ItemInfo vocabulary;
};

struct Granite {
    static const ItemInfo vocabulary;
};

struct Agate {
    double agate_turb = 1;

    static const ItemInfo vocabulary;
};

double evaluate(const Bozo&, const PatternPoint&);
double evaluate(const Spotted&, const PatternPoint&);
double evaluate(const Bumps&, const PatternPoint&);
double evaluate(const Dents&, const PatternPoint&);
double evaluate(const Wrinkles&, const PatternPoint&);
/// May exceed 1.
double evaluate(const Granite&, const PatternPoint&);
double evaluate(const Agate&, const PatternPoint&);

}  // namespace candelabra
