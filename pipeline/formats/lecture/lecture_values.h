#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/scene.h"
#include "pipeline/scene/settings_table.h"

// What the readers of lecture 1's two formats share.
namespace pipeline {

// Limits of all objects of a scene together.
inline constexpr std::size_t kMaxVertices = std::size_t{1} << 27, kMaxTriangles = std::size_t{1} << 27;

// Things that a file announces the number of.
struct Countable {
    std::string_view one, many;
    std::size_t least, most;
    std::size_t words;  // at least, for each; a word and what parts it from the last take two bytes
};

// A number of things that the rest of the file has room for, so that nothing is allocated on
// the strength of a wrong one. Whatever is not right is reported, with `polygon` where one is
// given; a number that is only too small is returned all the same, for reading can go on.
std::optional<std::size_t> readCount(TextScanner& scanner, const Countable& thing,
                                     std::optional<std::size_t> polygon = {});

// The row of settings_table.h with a key that is known to exist.
const Setting& settingRow(std::string_view key);
std::string numberFrom(double min, double max);

// One number for each key. What a file may say is what the setting may be. Their places go to `places`, if given.
void readSettings(TextScanner& scanner, std::span<const std::string_view> keys, Scene& scene, std::size_t index = 0,
                  KeyPlaces* places = nullptr);

void expectEnd(TextScanner& scanner);

// At most `count`.
std::vector<std::string_view> firstWords(std::string_view text, std::size_t count);

}  // namespace pipeline
