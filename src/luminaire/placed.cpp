// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/placed.h"

#include <utility>

namespace candelabra {

namespace {

SealedSide turned(SealedSide side) {
    return side == SealedSide::inner   ? SealedSide::outer
           : side == SealedSide::outer ? SealedSide::inner
                                       : side;
}

struct Move {
    const Transform& place;

    Emitter operator()(const SphereEmitter& e) const {
        return SphereEmitter{place.point(e.centre), e.radius * place.uniform_scale()};
    }
    Emitter operator()(const TriangleEmitter& e) const {
        // A reflection changes the winding of the corners, which tells the outer side.
        return TriangleEmitter{place.point(e.corner1), place.point(e.corner2),
                               place.point(e.corner3),
                               place.determinant() < 0 ? turned(e.sealed) : e.sealed};
    }
    Emitter operator()(const RectangleEmitter& e) const {
        return RectangleEmitter{place.point(e.corner), place.direction(e.side1),
                                place.direction(e.side2)};
    }
    Emitter operator()(const AreaEmitter& e) const {
        AreaEmitter moved = e;
        moved.transform = make_handle<Transform>(e.transform ? e.transform->then(place) : place);
        moved.area *= place.uniform_scale() * place.uniform_scale();
        return moved;
    }
    Emitter operator()(const CompositeEmitter& e) const { return e; }
};

}  // namespace

bool can_be_placed(const Luminaire& luminaire) {
    const Emitter& emitter = luminaire.emitter;
    return !luminaire.varying && !luminaire.brightness && !luminaire.web &&
           !std::holds_alternative<CompositeEmitter>(emitter);
}

Luminaire placed(const Luminaire& own, const Transform& place) {
    Luminaire moved = own;
    moved.emitter = std::visit(Move{place}, own.emitter);
    return moved;
}

}  // namespace candelabra
