// SPDX-License-Identifier: GPL-3.0-or-later
// A scene while its blocks are read: puts what was read into it. Used by the readers in the table
// of blocks.
#pragma once

#include "bind/binder.h"
#include "bind/settings.h"

namespace candelabra {

class SceneContent {
public:
    /// Both outlive it.
    SceneContent(Binder& binder, Scene& scene) : binder(binder), scene(scene) {}

    Binder& binder;
    Scene& scene;
    GivenSettings given;

    /// The default texture is the one in force at the end of the object's statement.
    void add(ObjectHandle);
    void add(const PlacedLight&);
    /// A camera that the block describes; warns when the scene has one already.
    void add(const DeclaredCamera&, const Element& block);
    /// The camera of the scene from now on.
    void show(const DeclaredCamera&);
};

}  // namespace candelabra
