// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns whose value grows along a line, a radius or an angle: gradient, marble, wood, onion,
// leopard, radial and the spirals.
#pragma once

#include "pattern/waveform.h"

namespace candelabra {

struct Gradient {
    Vec3 direction = Vec3(0, 1, 0);

    static const ItemInfo vocabulary;
};

/// The statement's turbulence is added to the value instead of displacing the point.
struct Marble {
    using Wave = TriangleWave;
    static constexpr bool displaced = false;

    static const ItemInfo vocabulary;
};

/// The statement's turbulence displaces the rings instead of the point.
struct Wood {
    using Wave = TriangleWave;
    static constexpr bool displaced = false;

    static const ItemInfo vocabulary;
};

struct Onion {
    static const ItemInfo vocabulary;
};

struct Leopard {
    static const ItemInfo vocabulary;
};

struct Radial {
    static const ItemInfo vocabulary;
};

struct Spiral1 {
    using Wave = TriangleWave;
    int arms = 1;

    static const ItemInfo vocabulary;
};

struct Spiral2 {
    using Wave = TriangleWave;
    int arms = 1;

    static const ItemInfo vocabulary;
};

double evaluate(const Gradient&, const Vec3& point);
double evaluate(const Marble&, const PatternPoint&);
double evaluate(const Wood&, const PatternPoint&);
double evaluate(const Onion&, const Vec3& point);
double evaluate(const Leopard&, const Vec3& point);
double evaluate(const Radial&, const Vec3& point);
double evaluate(const Spiral1&, const PatternPoint&);
double evaluate(const Spiral2&, const PatternPoint&);

}  // namespace candelabra
