#include "lessons/state/cue_text.h"

#include <algorithm>
#include <optional>

#include "lessons/state/toml_lines.h"

namespace lessons {
namespace {

using Kind = TomlItem::Kind;
using Items = std::vector<TomlItem>;

constexpr std::string_view kCueHeader = "[[cue]]";

// A header with what follows it, up to the next one; the first section has none.
struct Section {
    std::string name;  // of its header
    Items items;
};
using Sections = std::vector<Section>;

Sections sectionsOf(const Items& items) {
    Sections sections(1);
    for (const TomlItem& item : items) {
        if (item.kind == Kind::Header) sections.push_back({item.name, {}});
        sections.back().items.push_back(item);
    }
    return sections;
}

// What stands before the first cue, then the cues, each with the comments right above it and the blank lines above these.
std::vector<Items> blocksOf(std::string_view text) {
    std::vector<Items> blocks(1);
    for (TomlItem& item : tomlItems(text)) {
        if (item.kind == Kind::Header && item.name == kCueHeader) {
            Items& last = blocks.back();
            auto begin = last.end();
            while (begin != last.begin() && std::prev(begin)->kind == Kind::Comment) --begin;
            while (begin != last.begin() && std::prev(begin)->kind == Kind::Blank) --begin;
            Items own(begin, last.end());
            last.erase(begin, last.end());
            blocks.push_back(std::move(own));
        }
        blocks.back().push_back(std::move(item));
    }
    return blocks;
}

std::string textOf(const Items& items) {
    std::string text;
    for (const TomlItem& item : items) text += item.text;
    return text;
}

const TomlItem* entryOf(const Section* section, const std::string& key) {
    if (!section) return nullptr;
    const auto found = std::ranges::find_if(
        section->items, [&](const TomlItem& item) { return item.kind == Kind::Entry && item.name == key; });
    return found == section->items.end() ? nullptr : &*found;
}

int countOf(const Sections& sections, const std::string& name) {
    return int(std::ranges::count(sections, name, &Section::name));
}

// The `which`-th of that name.
const Section* find(const Sections& sections, const std::string& name, int which) {
    for (const Section& section : sections)
        if (section.name == name && which-- == 0) return &section;
    return nullptr;
}
Section* find(Sections& sections, const std::string& name, int which) {
    return const_cast<Section*>(find(std::as_const(sections), name, which));
}

// The comments of what is taken out stay as lines.
void takeOut(Section& section, const std::string& key) {
    for (TomlItem& item : section.items)
        if (item.kind == Kind::Entry && item.name == key)
            item = {Kind::Comment, item.comments, {}, {}, {}, item.comments};
}

void putIn(Section& section, const TomlItem& entry) {
    for (TomlItem& item : section.items)
        if (item.kind == Kind::Entry && item.name == entry.name) {
            item = withValue(item, entry.value);
            return;
        }
    auto place = section.items.end();
    while (place != section.items.begin() && std::prev(place)->kind != Kind::Entry &&
           std::prev(place)->kind != Kind::Header)
        --place;
    section.items.insert(place, entry);
}

// What differs between two ways to say the same cue, `before` and `after`, is changed in what was written by hand.
std::string merged(const Items& written, std::string_view before, std::string_view after) {
    Sections hand = sectionsOf(written);
    const Sections was = sectionsOf(tomlItems(before)), is = sectionsOf(tomlItems(after));
    for (std::size_t i = 0; i < is.size(); ++i) {
        const std::string& name = is[i].name;
        const int which = int(std::ranges::count(is.begin(), is.begin() + std::ptrdiff_t(i), name, &Section::name));
        const Section* old = find(was, name, which);
        if (old && textOf(old->items) == textOf(is[i].items)) continue;
        Section* place = find(hand, name, which);
        if (!place) {
            // Those before it that go without saying have to be said now.
            for (int missing = countOf(hand, name); missing <= which; ++missing)
                hand.push_back(*find(is, name, missing));
            continue;
        }
        for (const TomlItem& entry : is[i].items) {
            if (entry.kind != Kind::Entry) continue;
            const TomlItem* same = entryOf(old, entry.name);
            if (!same || same->value != entry.value) putIn(*place, entry);
        }
        for (const TomlItem& entry : place->items)
            if (entry.kind == Kind::Entry && !entryOf(&is[i], entry.name) && entryOf(old, entry.name)) {
                takeOut(*place, std::string(entry.name));
            }
    }
    std::string text;
    for (std::size_t i = 0; i < hand.size(); ++i) {
        const int which =
            int(std::ranges::count(hand.begin(), hand.begin() + std::ptrdiff_t(i), hand[i].name, &Section::name));
        const bool isGone = !find(is, hand[i].name, which) && find(was, hand[i].name, which);
        for (const TomlItem& item : hand[i].items)
            text += isGone && item.kind != Kind::Blank ? item.comments : item.text;
    }
    return text;
}

// All comments above what the program writes: where nothing can be said of their places.
std::string rewritten(const Items& written, std::string_view after) {
    std::string text = "\n";
    for (const TomlItem& item : written) text += item.comments;
    return text + std::string(after.substr(std::min(after.find_first_not_of('\n'), after.size())));
}

// The cue of `before` that cue `i` has become.
std::optional<std::size_t> originOf(const CueList& list, std::size_t i, const CueList& before) {
    const auto position = [&](const std::string& name) -> std::optional<std::size_t> {
        const auto found = std::ranges::find(before.cues, name, &Cue::name);
        return found == before.cues.end() ? std::nullopt : std::optional(std::size_t(found - before.cues.begin()));
    };
    if (const auto same = position(list.cues[i].name)) return same;
    // A name that is gone, of a cue that is not: it has another one.
    for (std::size_t k = 0; k < before.cues.size(); ++k) {
        const Cue& old = before.cues[k];
        const bool isGone = std::ranges::find(list.cues, old.name, &Cue::name) == list.cues.end();
        if (isGone && old.state == list.cues[i].state) return k;
    }
    return {};
}

// One cue alone, as toToml has it.
std::string cueAlone(const Cue& cue) {
    const std::string text = toToml(CueList{{}, 1, {cue}});
    return text.substr(std::min(text.find(kCueHeader), text.size()));
}
std::string head(const CueList& list) { return toToml(CueList{list.title, list.minutes, {}}); }

}  // namespace

std::string cueText(const CueList& list, std::string_view text, const CueList& before) {
    std::string plain = toToml(list);
    const std::vector<Items> blocks = blocksOf(text);
    if (text.empty() || blocks.size() != before.cues.size() + 1) return plain;
    const auto write = [&](const auto& change) {
        std::string all = merged(blocks[0], head(before), head(list));
        for (std::size_t i = 0; i < list.cues.size(); ++i) {
            const auto origin = originOf(list, i, before);
            const std::string now = cueAlone(list.cues[i]);
            if (!origin)
                all += '\n' + now;
            else if (before.cues[*origin] == list.cues[i])
                all += textOf(blocks[*origin + 1]);
            else
                all += change(blocks[*origin + 1], cueAlone(before.cues[*origin]), now);
        }
        return all;
    };
    const auto isRight = [&](const std::string& written) {
        const auto read = readCues(written, "");
        return read && *read == list;
    };
    std::string written = write(merged);
    if (isRight(written)) return written;
    written = write([](const Items& hand, const std::string&, const std::string& now) { return rewritten(hand, now); });
    return isRight(written) ? written : plain;
}

}  // namespace lessons
