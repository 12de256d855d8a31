#include <algorithm>
#include <array>

#include "pipeline/compare/handed_in/conventions.h"
#include "pipeline/formats/toml/toml_values.h"

namespace pipeline::foreign {

StatedConventions StatedConventions::of(const HandedFile& file) const {
    const auto own = files.find(file.name.buffer.text());
    if (own == files.end()) return *this;
    StatedConventions out = own->second;
    if (!out.bottomUp) out.bottomUp = bottomUp;
    if (!out.mirrored) out.mirrored = mirrored;
    if (!out.bgr) out.bgr = bgr;
    out.codings.insert(codings.begin(), codings.end());
    return out;
}

bool StatedConventions::states(const HandedFile& file, const ReadingContext& context) const {
    return std::ranges::any_of(readingsOf(file, context), [&](const Reading& reading) {
        return codings.contains(std::string(codingInfo(reading.coding).key));
    });
}

std::vector<Reading> allowedReadings(const HandedFile& file, const ReadingContext& context,
                                     const StatedConventions& stated) {
    const StatedConventions ofFile = stated.of(file);
    std::vector<Reading> all = readingsOf(file, context);
    if (file.name.buffer.id == BufferId::VerticesScreen) all.push_back({false, false, false, Coding::FromTheFoot});
    const bool isPicture = bufferInfo(file.name.buffer.id).domain == Domain::Pixel;
    std::erase_if(all, [&](const Reading& reading) {
        // A gamma that no standard knows is an error, until it is stated.
        if (reading.coding == Coding::Gamma22 && !ofFile.codings.contains("encoding")) return true;
        if (!isPicture) return false;
        return (ofFile.bottomUp && *ofFile.bottomUp != reading.bottomUp) ||
               (ofFile.mirrored && *ofFile.mirrored != reading.mirrored) || (ofFile.bgr && *ofFile.bgr != reading.bgr);
    });
    for (const auto& one : ofFile.codings) {
        const auto& key = one.first;
        const Coding coding = one.second;
        const bool has = std::ranges::any_of(all, [&](const Reading& reading) { return reading.coding == coding; });
        const bool isAsked =
            std::ranges::any_of(all, [&](const Reading& reading) { return codingInfo(reading.coding).key == key; });
        if (has && isAsked) std::erase_if(all, [&](const Reading& reading) { return reading.coding != coding; });
    }
    return all;
}

namespace {

// Of all files, or in a table of its name of one.
void readStatedTable(const toml::table& table, bool ofAll, TomlValues& values, StatedConventions& out) {
    std::vector<std::string> known{"rows", "columns", "channels"};
    for (const CodingInfo& info : codingTable())
        if (!info.key.empty() && std::ranges::find(known, info.key) == known.end()) known.emplace_back(info.key);
    constexpr std::size_t kMostLights = 1000;
    for (const TomlEntry& entry : inFileOrder(table)) {
        const std::string key(entry.key->str());
        constexpr std::array<std::string_view, 2> kRows{"top-down", "bottom-up"};
        constexpr std::array<std::string_view, 2> kColumns{"left-to-right", "right-to-left"};
        constexpr std::array<std::string_view, 2> kChannels{"rgb", "bgr"};
        const auto flag = [&](std::optional<bool>& to, std::span<const std::string_view> choices) {
            if (const auto choice = values.choice(*entry.node, key, choices)) to = *choice == 1;
        };
        if (const auto* const file = entry.node->as_table(); file && ofAll) {
            if (const auto name = findHanded(key, kMostLights))
                readStatedTable(*file, false, values, out.files[name->buffer.text()]);
            else
                values.unknown(*entry.key, key, known);
        } else if (key == "rows") {
            flag(out.bottomUp, kRows);
        } else if (key == "columns") {
            flag(out.mirrored, kColumns);
        } else if (key == "channels") {
            flag(out.bgr, kChannels);
        } else {
            std::vector<std::string_view> choices{"own"};
            std::vector<Coding> codings{Coding::AsIs};
            for (const CodingInfo& info : codingTable())
                if (info.key == key) choices.push_back(info.value), codings.push_back(info.id);
            if (choices.size() == 1)
                values.unknown(*entry.key, key, known);
            else if (const auto choice = values.choice(*entry.node, key, choices))
                out.codings[key] = codings[*choice];
        }
    }
}

}  // namespace

Result<StatedConventions> readStated(const std::string& text, const std::string& name) {
    StatedConventions out;
    if (text.empty()) return out;
    auto table = parseToml({text, name});
    if (!table) return table.errors();
    TomlValues values(name);
    readStatedTable(*table, true, values, out);
    if (const Errors errors = values.errors(); !errors.empty()) return errors;
    return out;
}

}  // namespace pipeline::foreign
