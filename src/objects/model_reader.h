// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the contents of mesh { } that replace triangles: a file, an object to be meshed, a hull.
// Called by the reader of objects.
#pragma once

#include "meshing/library.h"
#include "objects/object_draft.h"

namespace candelabra {

class ModelReader : public SimpleReader {
public:
    /// Both references outlive the reader. It takes nothing unless the block is a mesh.
    ModelReader(OpenBlock&, ObjectDraft&, bool is_mesh);

    bool take(const Element&);
    void add_words(WordList&) const;

    /// The requested mesh. Nothing if the block has only triangles, or after a diagnostic.
    std::optional<Mesh> made(const TriangleMesh&);

private:
    /// The parts of a convex_hull.
    struct Hull {
        std::vector<Vec3> points;
        std::vector<ObjectHandle> objects;
    };

    void take_object(const Element&);
    void read_hull(const Element&);
    void wrong(const std::string& why);
    /// The surface that the mesh is made from; nothing after a diagnostic.
    std::optional<Polyhedron> source(const TriangleMesh&, const Polyhedra*);
    /// Returns false after a diagnostic.
    bool refine(Polyhedron&, int steps, const Polyhedra*);

    OpenBlock& block_;
    ObjectDraft& draft_;
    bool is_mesh_;
    ObjectHandle object_;
    std::optional<Hull> hull_;
    PolyhedronLook look_;  ///< normals, texture coordinates and materials of a file
    Span span_;            ///< of the object or hull
};

}  // namespace candelabra
