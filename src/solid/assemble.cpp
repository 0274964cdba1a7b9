// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/assemble.h"

Handle<Transform> combined(const Handle<Transform>& inner, const Handle<Transform>& outer) {
    if (!inner) return outer;
    if (!outer) return inner;
    return make_handle<Transform>(inner->then(*outer));
}

Composite composite_of(const Object& object, ShapeStore& shapes) {
    CompositeBuilder builder;
    NoVisitor nobody;
    const PartRef root = Assembler<NoVisitor>(builder, shapes, nobody).add(object, nullptr);
    return builder.finish(root);
}
