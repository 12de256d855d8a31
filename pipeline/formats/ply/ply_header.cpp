#include "pipeline/formats/ply/ply_header.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/text/text_scanner.h"

namespace pipeline {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr TypeName kTypes[] = {
    {"char", PlyType::Int8},   {"uchar", PlyType::Uint8},   {"short", PlyType::Int16},   {"ushort", PlyType::Uint16},
    {"int", PlyType::Int32},   {"uint", PlyType::Uint32},   {"float", PlyType::Float},   {"double", PlyType::Double},
    {"int8", PlyType::Int8},   {"uint8", PlyType::Uint8},   {"int16", PlyType::Int16},   {"uint16", PlyType::Uint16},
    {"int32", PlyType::Int32}, {"uint32", PlyType::Uint32}, {"float32", PlyType::Float}, {"float64", PlyType::Double},
};

struct FormName {
    std::string_view name;
    PlyForm form;
};
constexpr FormName kForms[] = {{"ascii", PlyForm::Text},
                               {"binary_little_endian", PlyForm::LittleEndian},
                               {"binary_big_endian", PlyForm::BigEndian}};

struct RoleName {
    std::string_view element, property;
    bool isList;
    PlyRole role;
};
constexpr RoleName kRoles[] = {
    {"vertex", "x", false, PlyRole::X},
    {"vertex", "y", false, PlyRole::Y},
    {"vertex", "z", false, PlyRole::Z},
    {"vertex", "nx", false, PlyRole::NormalX},
    {"vertex", "ny", false, PlyRole::NormalY},
    {"vertex", "nz", false, PlyRole::NormalZ},
    {"vertex", "red", false, PlyRole::Red},
    {"vertex", "green", false, PlyRole::Green},
    {"vertex", "blue", false, PlyRole::Blue},
    {"vertex", "diffuse_red", false, PlyRole::Red},
    {"vertex", "diffuse_green", false, PlyRole::Green},
    {"vertex", "diffuse_blue", false, PlyRole::Blue},
    {"vertex", "r", false, PlyRole::Red},
    {"vertex", "g", false, PlyRole::Green},
    {"vertex", "b", false, PlyRole::Blue},
    {"face", "vertex_indices", true, PlyRole::Corners},
    {"face", "vertex_index", true, PlyRole::Corners},
    {"tristrips", "vertex_indices", true, PlyRole::Corners},
    {"tristrips", "vertex_index", true, PlyRole::Corners},
    {"tristrip", "vertex_indices", true, PlyRole::Corners},
    {"tristrip", "vertex_index", true, PlyRole::Corners},
};

constexpr std::size_t kMostProperties = 1000;

// The word was read last.
PlyType typeOf(std::string_view word, bool whole, LineScanner& scanner) {
    const auto* const row = std::ranges::find(kTypes, word, &TypeName::name);
    const bool fits = row != std::end(kTypes) && (!whole || row->type < PlyType::Float);
    if (fits) return row->type;
    scanner.refuse(whole ? "a whole number's type, as uchar or int" : "a number's type, as float or int");
    return PlyType::Int8;
}

void readProperty(LineScanner& scanner, PlyElement& element) {
    PlyProperty property;
    std::string_view word = scanner.next();
    property.isList = word == "list";
    if (property.isList) {
        property.countType = typeOf(scanner.next(), true, scanner);
        word = scanner.next();
    }
    property.type = typeOf(word, false, scanner);
    const std::string_view name = scanner.next();
    if (name.empty()) scanner.refuse("the property's name");
    const auto* const role = std::ranges::find_if(kRoles, [&](const RoleName& row) {
        return row.element == element.name && row.property == name && row.isList == property.isList;
    });
    if (role != std::end(kRoles)) property.role = role->role;
    if (property.role == PlyRole::Corners && property.type >= PlyType::Float)
        scanner.fail("found corners that are no whole numbers", "a type as int");
    property.name = name;
    element.properties.push_back(std::move(property));
    if (element.properties.size() == kMostProperties + 1) scanner.fail("found more than 1 000 properties");
}

bool has(const PlyElement& element, PlyRole role) {
    return std::ranges::find(element.properties, role, &PlyProperty::role) != element.properties.end();
}

void checkElements(LineScanner& scanner, const PlyHeader& header) {
    const auto& elements = header.elements;
    const auto vertex = std::ranges::find(elements, "vertex", &PlyElement::name);
    const auto face = std::ranges::find_if(
        elements, [](const PlyElement& element) { return hasPolygons(element) && has(element, PlyRole::Corners); });
    if (vertex == elements.end() || !has(*vertex, PlyRole::X) || !has(*vertex, PlyRole::Y) || !has(*vertex, PlyRole::Z))
        scanner.fail("found no element vertex with x, y, z");
    else if (face == elements.end())
        scanner.fail("found no element face or tristrips with a list vertex_indices", "a model with polygons");
    else if (face < vertex)
        scanner.fail(fmt::format("found the element {} before vertex", face->name), "vertex first");
    for (const PlyElement& element : elements) {
        if (element.properties.empty() && element.count > 0) scanner.fail("found an element without properties");
        if ((element.name == "vertex" || hasPolygons(element)) &&
            std::ranges::count(elements, element.name, &PlyElement::name) > 1)
            return scanner.fail("found an element twice: " + quotedInput(element.name));
    }
}

}  // namespace

std::size_t byteCount(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::Uint8: return 1;
        case PlyType::Int16:
        case PlyType::Uint16: return 2;
        case PlyType::Int32:
        case PlyType::Uint32:
        case PlyType::Float: return 4;
        case PlyType::Double: return 8;
    }
    return 8;
}

PlyHeader readPlyHeader(LineScanner& scanner) {
    PlyHeader header;
    scanner.nextLine();
    if (scanner.next() != "ply") {
        scanner.refuse("ply");
        return header;
    }
    bool formKnown = false;
    while (scanner.nextLine()) {
        const std::string_view word = scanner.next();
        if (word == "format") {
            const auto* const row = std::ranges::find(kForms, scanner.next(), &FormName::name);
            formKnown = row != std::end(kForms);
            if (formKnown)
                header.form = row->form;
            else
                scanner.refuse("ascii, binary_little_endian or binary_big_endian");
        } else if (word == "element") {
            PlyElement& element = header.elements.emplace_back();
            element.name = scanner.next();
            const std::optional<std::uint64_t> count = parseCount(scanner.next());
            if (!count) scanner.refuse("how many elements there are");
            element.count = count.value_or(0);
            if (header.elements.size() > kMostProperties) {
                scanner.fail("found more than 1 000 elements");
                return header;
            }
        } else if (word == "property") {
            if (header.elements.empty()) {
                scanner.refuse("element before property");
                return header;
            }
            readProperty(scanner, header.elements.back());
            if (header.elements.back().properties.size() > kMostProperties) return header;
        } else if (word == "end_header") {
            if (!formKnown) scanner.refuse("format before end_header");
            checkElements(scanner, header);
            return header;
        } else if (!word.empty() && word != "comment" && word != "obj_info") {
            // A line of words of its own changes nothing; one that may mean what the numbers are does.
            constexpr std::size_t kTypo = 3;
            const auto isLike = [&](std::string_view keyword) { return editDistance(word, keyword) <= kTypo; };
            if (isLike("format") || isLike("element") || isLike("property") || isLike("end_header"))
                scanner.refuse("format, comment, element, property or end_header");
            else if (header.unknownLines++ == 0)
                header.firstUnknown = scanner.line();
        }
    }
    scanner.fail("found the end of the file", "end_header");
    return header;
}

}  // namespace pipeline
