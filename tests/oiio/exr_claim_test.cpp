// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/formats.h"

#include "support/picture_formats.h"

namespace candelabra {

namespace {

/// Returns the library's message for a small picture with changed bytes.
template <class Change>
std::string changed_exr(const Change& change) {
    RawPicture picture{4, 4, 3, std::vector<float>(48, 0.5F), "exr", "zip"};
    std::string bytes;
    REQUIRE(formats().write(picture, bytes) == "");
    change(bytes);
    StoredPicture stored;
    return formats().read(bytes, 1 << 28, stored);
}

/// Returns the position of an attribute's value.
std::size_t value_of(const std::string& bytes, const std::string& name, const std::string& type) {
    const std::string head = name + '\0' + type + '\0';
    const std::size_t found = bytes.find(head);
    REQUIRE(found != std::string::npos);
    return found + head.size() + 4;
}

}  // namespace

TEST_CASE("the window of an OpenEXR file is bounded before it is opened", "[formats]") {
    CHECK(changed_exr([](std::string&) {}) == "");
    const auto with_height = [](const std::string& low_first) {
        return changed_exr([&](std::string& bytes) {
            bytes.replace(value_of(bytes, "dataWindow", "box2i") + 12, 4, low_first);
        });
    };
    CHECK(with_height("\xff\xff\xff\x7f").starts_with("its header is for a larger picture than"));
    CHECK(with_height(std::string("\0\0\1\0", 4))
              .starts_with("its header is for a larger picture than"));
    CHECK(with_height("\xfe\xff\xff\xff") == "it has no pixels");
    CHECK(changed_exr([](std::string& bytes) {
              bytes[value_of(bytes, "compression", "compression")] = 77;
          }) == "its compression is not known");
    CHECK(changed_exr([](std::string& bytes) { bytes.resize(40); }) == "it ends in its head");
}

}  // namespace candelabra
