// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/packed_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace candelabra {

namespace {

/// The fields of each part of a model, for both directions.
template <class Way>
void pass(Way& way, ImportedFile& p) {
    way(p.file, p.bytes);
}
template <class Way>
void pass(Way& way, ImportedMaterial& m) {
    way(m.name, m.stated, m.colour, m.emission, m.opacity, m.transmission, m.ior, m.facets,
        m.metallic, m.roughness, m.specular, m.shininess, m.uses_alpha, m.cutoff, m.picture,
        m.emission_picture, m.facet_picture, m.normal_picture, m.normal_scale, m.heights);
}
template <class Way>
void pass(Way& way, ImportedMesh& m) {
    way(m.points, m.normals, m.uvs, m.faces, m.material, m.coloured);
}
template <class Way>
void pass(Way& way, ImportedLight& l) {
    way(l.kind, l.colour, l.profile, l.inner, l.outer);
}
template <class Way>
void pass(Way& way, ImportedCamera& c) {
    way(c.name, c.location, c.direction, c.up, c.parallel, c.width, c.height);
}
template <class Way>
void pass(Way& way, ImportedNode& n) {
    way(n.name, n.parent, n.transform, n.meshes, n.light, n.camera);
}
template <class Way>
void pass(Way& way, ImportedModel& m) {
    way(m.nodes, m.meshes, m.materials, m.pictures, m.lights, m.profiles, m.cameras,
        m.lights_left_out, m.animated, m.encoded);
}

/// Lists of these are copied at once.
template <class T>
constexpr bool is_plain = std::is_trivially_copyable_v<T> && !std::is_same_v<T, ImportedLight>;

class Packer {
public:
    /// Only counts if there is no place to write to.
    explicit Packer(char* to) : to_(to) {}
    template <class... Fields>
    void operator()(Fields&... fields) {
        (put(fields), ...);
    }
    std::size_t size() const { return size_; }

private:
    template <class T>
    void put(T& value) {
        if constexpr (is_plain<T>)
            write(&value, sizeof value);
        else
            pass(*this, value);
    }
    void put(std::string& text) { put_list(text); }
    template <class T>
    void put(std::vector<T>& list) {
        if constexpr (is_plain<T>) return put_list(list);
        std::uint64_t count = list.size();
        put(count);
        for (T& each : list) put(each);
    }
    template <class List>
    void put_list(List& list) {
        std::uint64_t count = list.size();
        put(count);
        write(list.data(), count * sizeof list[0]);
    }
    void write(const void* from, std::size_t bytes) {
        if (to_ && bytes > 0) std::memcpy(to_ + size_, from, bytes);
        size_ += bytes;
    }

    char* to_;
    std::size_t size_ = 0;
};

class Unpacker {
public:
    Unpacker(std::string_view bytes, std::vector<Mesh>& meshes) : rest_(bytes), meshes_(meshes) {}
    template <class... Fields>
    void operator()(Fields&... fields) {
        (take(fields), ...);
    }
    void take_lists(ImportedMesh& m) {
        Mesh& made = meshes_.emplace_back();
        take_points(made.vertices);
        take_points(made.normals);
        take_points(made.uvs);
        take_list(made.faces);
        (*this)(m.material, m.coloured);
    }
    bool good() const { return good_ && rest_.empty(); }

private:
    template <class T>
    void take(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            char byte = 0;
            copy(&byte, 1);
            value = byte != 0;
        } else if constexpr (is_plain<T>) {
            copy(&value, sizeof value);
        } else {
            pass(*this, value);
        }
    }
    void take(std::string& text) { take_list(text); }
    template <class T>
    void take(std::vector<T>& list) {
        if constexpr (is_plain<T>) return take_list(list);
        std::uint64_t count = 0;
        take(count);
        for (std::uint64_t i = 0; i < count && good_; ++i) take(list.emplace_back());
    }
    template <class List>
    void take_list(List& list) {
        std::uint64_t count = 0;
        take(count);
        if (count > rest_.size() / sizeof list[0]) good_ = false;
        if (!good_) return;
        list.resize(count);
        copy(list.data(), count * sizeof list[0]);
    }
    /// A list of points whose coordinates are floats.
    template <class Point>
    void take_points(std::vector<Point>& list) {
        using Stored = std::array<float, static_cast<std::size_t>(Point::length())>;
        std::uint64_t count = 0;
        take(count);
        if (count > rest_.size() / sizeof(Stored)) good_ = false;
        if (!good_) return;
        list.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            Stored stored;
            std::memcpy(&stored, rest_.data() + i * sizeof stored, sizeof stored);
            if constexpr (Point::length() == 3)
                list.emplace_back(stored[0], stored[1], stored[2]);
            else
                list.emplace_back(stored[0], stored[1]);
        }
        rest_.remove_prefix(count * sizeof(Stored));
    }
    void copy(void* to, std::size_t size) {
        good_ = good_ && size <= rest_.size();
        if (!good_ || size == 0) return;
        std::memcpy(to, rest_.data(), size);
        rest_.remove_prefix(size);
    }

    std::string_view rest_;
    std::vector<Mesh>& meshes_;
    bool good_ = true;
};

/// The lists of a mesh go to another place.
void pass(Unpacker& way, ImportedMesh& m) { way.take_lists(m); }

template <class Number, std::size_t count>
bool is_finite(const std::array<Number, count>& each) {
    return std::ranges::all_of(each, [](Number x) { return std::isfinite(x); });
}

template <class List>
bool is_place(int index, const List& list) {
    return index < 0 || static_cast<std::size_t>(index) < list.size();
}

/// Whether all coordinates are finite: otherwise their sum is not.
template <class Point>
bool all_finite(const std::vector<Point>& list) {
    Point sum(0);
    for (const Point& each : list) sum += 0.0 * each;
    return sum == Point(0);
}

bool is_whole(const Mesh& mesh) {
    const auto fits = [&](const auto& list) {
        return list.empty() || list.size() == mesh.vertices.size();
    };
    const auto inside = [&](const Face& face) {
        return std::ranges::all_of(
            face, [&](int corner) { return corner >= 0 && is_place(corner, mesh.vertices); });
    };
    return fits(mesh.normals) && fits(mesh.uvs) && std::ranges::all_of(mesh.faces, inside) &&
           all_finite(mesh.vertices) && all_finite(mesh.normals) && all_finite(mesh.uvs);
}

bool is_whole(const ImportedMesh& mesh, const ImportedModel& model) {
    return is_place(mesh.material, model.materials);
}

bool is_whole(const ImportedMaterial& m, const ImportedModel& model) {
    const auto numbers = {m.opacity,  m.transmission, m.ior,    m.metallic,    m.roughness,
                          m.specular, m.shininess,    m.cutoff, m.normal_scale};
    return is_finite(m.colour) && is_finite(m.emission) &&
           std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }) &&
           std::ranges::all_of(
               std::array{m.picture, m.emission_picture, m.facet_picture, m.normal_picture},
               [&](int place) { return is_place(place, model.pictures); });
}

bool is_whole(const ImportedNode& node, int number, const ImportedModel& model) {
    return node.parent < number && (number == 0 || node.parent >= 0) && is_finite(node.transform) &&
           is_place(node.light, model.lights) && is_place(node.camera, model.cameras) &&
           std::ranges::all_of(node.meshes,
                               [&](int mesh) { return mesh >= 0 && is_place(mesh, model.meshes); });
}

bool is_whole(const ImportedLight& light, const ImportedModel& model) {
    return is_place(light.profile, model.profiles) &&
           (light.kind != ImportedLight::measured || light.profile >= 0) &&
           is_finite(light.colour) && std::isfinite(light.inner) && std::isfinite(light.outer);
}

bool is_whole(const ImportedCamera& camera) {
    return is_finite(camera.location) && is_finite(camera.direction) && is_finite(camera.up) &&
           std::isfinite(camera.width) && std::isfinite(camera.height);
}

std::string problem_of(const UnpackedModel& unpacked) {
    const ImportedModel& model = unpacked.model;
    const auto whole = [&](const auto& part) { return is_whole(part, model); };
    const auto is_whole_mesh = [](const Mesh& mesh) { return is_whole(mesh); };
    if (!std::ranges::all_of(unpacked.meshes, is_whole_mesh) ||
        !std::ranges::all_of(model.meshes, whole))
        return "a face, a normal or a number of a mesh in it is wrong";
    if (!std::ranges::all_of(model.materials, whole)) return "a number of a material is wrong";
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (!is_whole(model.nodes[i], static_cast<int>(i), model))
            return "the place of a part in it is wrong";
    if (!std::ranges::all_of(model.lights, whole)) return "a number of a light is wrong";
    if (!std::ranges::all_of(model.cameras, [](const auto& each) { return is_whole(each); }))
        return "a number of a camera is wrong";
    return {};
}

}  // namespace

std::size_t packed_size(const ImportedModel& model) {
    Packer packer(nullptr);
    pass(packer, const_cast<ImportedModel&>(model));  // which is only read
    return packer.size();
}

void pack(const ImportedModel& model, char* to) {
    Packer packer(to);
    pass(packer, const_cast<ImportedModel&>(model));  // which is only read
}

std::string unpack(std::string_view bytes, UnpackedModel& model) {
    UnpackedModel made;
    Unpacker unpacker(bytes, made.meshes);
    pass(unpacker, made.model);
    if (!unpacker.good()) return "it is damaged";
    std::string problem = problem_of(made);
    if (problem.empty()) model = std::move(made);
    return problem;
}

}  // namespace candelabra
