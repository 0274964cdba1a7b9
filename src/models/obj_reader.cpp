// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/obj_reader.h"

#include "base/number_text.h"
#include "models/fan.h"

#include <algorithm>
#include <cstddef>
#include <system_error>

namespace candelabra {

namespace {

using polyhedra::place;

/// The rest of a line. Most functions consume a part of its front.
class Line {
public:
    explicit Line(std::string_view text) : rest_(text) {}

    std::string_view word() {
        skip_blanks();
        const std::size_t end = std::min(rest_.find_first_of(blanks), rest_.size());
        const std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return found;
    }
    template <class Number>
    bool number(Number& value) {
        skip_blanks();
        if (rest_.starts_with('+')) rest_.remove_prefix(1);
        const auto [end, failure] =
            number_from(rest_.data(), rest_.data() + rest_.size(), value);
        if (failure != std::errc()) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return true;
    }
    bool slash() {
        if (!rest_.starts_with('/')) return false;
        rest_.remove_prefix(1);
        return true;
    }
    bool at_number() const { return !rest_.empty() && rest_[0] != '/' && !is_blank(rest_[0]); }
    bool at_end() {
        skip_blanks();
        return rest_.empty();
    }

private:
    static constexpr std::string_view blanks = " \t\r";
    static bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    }

    std::string_view rest_;
};

class ObjReader {
public:
    ObjReader(Polyhedron& shape, PolyhedronLook& look) : shape_(shape), look_(look) {}

    /// Returns an error in the line, or an empty string.
    std::string take(Line line);
    /// Called after the last line.
    void finish();

private:
    /// Index from a number that counts from 1, or backwards from the last entry so far.
    static int counted(long number, std::size_t so_far) {
        return place(number < 0 ? static_cast<long>(so_far) + number : number - 1);
    }
    std::string take_face(Line&);
    /// Reads the index after a slash; -1 if there is none.
    bool take_named(Line&, std::size_t so_far, int& named);

    Polyhedron& shape_;
    PolyhedronLook& look_;
    bool has_uvs_ = false, has_normals_ = false;
    std::vector<int> corners_, uvs_, normals_;  ///< of the current face
};

std::string ObjReader::take(Line line) {
    const std::string_view word = line.word();
    if (word == "v") {
        Polyhedron::Point& p = shape_.points.emplace_back();
        return line.number(p[0]) && line.number(p[1]) && line.number(p[2])
                   ? ""
                   : "a point has three numbers";
    }
    if (word == "vn") {
        Polyhedron::Point& n = look_.normals.emplace_back();
        return line.number(n[0]) && line.number(n[1]) && line.number(n[2])
                   ? ""
                   : "a normal has three numbers";
    }
    if (word == "vt") {
        auto& [u, v] = look_.uvs.emplace_back();
        return line.number(u) && (line.at_end() || line.number(v))
                   ? ""
                   : "`vt` has one to three numbers";
    }
    look_.materials |= word == "usemtl";
    return word == "f" ? take_face(line) : "";
}

bool ObjReader::take_named(Line& line, std::size_t so_far, int& named) {
    named = -1;
    if (!line.slash() || !line.at_number()) return true;
    long number = 0;
    if (!line.number(number) || number == 0) return false;
    named = counted(number, so_far);
    return named >= 0;
}

std::string ObjReader::take_face(Line& line) {
    corners_.clear();
    uvs_.clear();
    normals_.clear();
    while (!line.at_end()) {
        long number = 0;
        int uv, normal;
        if (!line.number(number) || number == 0 || !take_named(line, look_.uvs.size(), uv) ||
            !take_named(line, look_.normals.size(), normal))
            return "a corner of a face is `1`, `1/2`, `1//3` or `1/2/3`, and counts from 1";
        corners_.push_back(counted(number, shape_.points.size()));
        uvs_.push_back(uv);
        normals_.push_back(normal);
        has_uvs_ |= uv >= 0;
        has_normals_ |= normal >= 0;
    }
    if (corners_.size() < 3) return "a face has at least three corners";
    polyhedra::add_fan(corners_, shape_.faces);
    polyhedra::add_fan(uvs_, look_.uv_faces);
    polyhedra::add_fan(normals_, look_.normal_faces);
    return {};
}

/// Gives corners without an index the last entry of the list, which is added for them.
template <class Entry>
void complete(bool used, std::vector<Polyhedron::Face>& faces, std::vector<Entry>& list) {
    if (!used) {
        faces.clear();
        list.clear();
        return;
    }
    const int none = static_cast<int>(list.size());
    bool lacks = false;
    for (Polyhedron::Face& face : faces)
        for (int& corner : face) {
            lacks |= corner < 0;
            corner = corner < 0 ? none : corner;
        }
    if (lacks) list.push_back({});
}

void ObjReader::finish() {
    complete(has_uvs_, look_.uv_faces, look_.uvs);
    complete(has_normals_, look_.normal_faces, look_.normals);
}

}  // namespace

std::string polyhedra::read_obj(std::string_view text, Polyhedron& shape, PolyhedronLook& look) {
    ObjReader reader(shape, look);
    std::string joined;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        // A line that ends in a backslash continues in the next one.
        if (line.ends_with('\\') && !text.empty()) {
            joined.append(line.substr(0, line.size() - 1)) += ' ';
            continue;
        }
        const std::string whole = joined.empty() ? "" : joined.append(line);
        const std::string wrong = reader.take(Line(joined.empty() ? line : whole));
        joined.clear();
        if (!wrong.empty()) return "line " + std::to_string(number) + ": " + wrong;
    }
    reader.finish();
    return {};
}

}  // namespace candelabra
