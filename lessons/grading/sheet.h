#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lessons/lesson.h"

// Sheets for a class: variants of a lesson whose answers differ, for paper, with their keys apart.

namespace lessons {

// A lesson whose header may also say
//
//   vary light.0.x: 300..700+100        a value from 300 to 700 in steps of 100
//   vary shading: flat, gouraud, phong  one of these
//   vary pick: pixel of polygon 2, 12 px inside
//   keep: 0.2 < buffer(n_dot_l.0, pick_x, pick_y)
//
// A setting is set to what is drawn. A pixel gives its name to the key pixel ("pixel: pick") and two names to formulas,
// pick_x and pick_y. What keep says has to hold in the first page's frame.
struct SheetTemplate {
    struct Vary {
        std::string key;
        std::vector<std::string> values;  // empty: a pixel
        std::size_t polygon = 0;          // of the pixel
        int inside = 0;                   // px from the polygon's outline at least
        pipeline::SourceLocation where;
    };
    struct Keep {
        std::string condition;
        pipeline::SourceLocation where;
    };
    std::string text;  // without these lines, which are left blank
    std::vector<Vary> vary;
    std::vector<Keep> keep;
    std::filesystem::path folder;
    std::string file;  // for messages
};
pipeline::Result<SheetTemplate> readSheetTemplate(const std::filesystem::path& folder);

// One variant.
struct Sheet {
    std::size_t number = 0;                                  // from 1
    std::vector<std::pair<std::string, std::string>> drawn;  // what vary has given: key, value
    std::string text;                                        // a lesson
    std::vector<std::string> answers;                        // of each question, as on the key
    // Eight digits of a hash of its text and answers, on the sheet, on its key and in its file to hand in: another draw has
    // other ones, whatever its seed.
    std::string draw{};
};

struct SheetOptions {
    std::uint64_t seed = 1;
    std::size_t count = 1;   // of sheets, 1 to 500
    std::size_t blanks = 0;  // numbers of tables and equations that are left blank, on each page
};

// What a class is given, and what its teacher keeps.
struct Sheets {
    struct Pages {
        std::string sheet, key;  // HTML
    };
    std::vector<Sheet> sheets;
    std::vector<Pages> pages;  // of each
    pipeline::Errors leftOut;  // pictures, and why; once
};
// Each sheet's questions are checked as lesson check does, and more than half of its answers differ from those of every
// sheet before it. Errors: those of the template and its lesson; that no draw out of 1 000 fits; "stopped". The same on
// every machine.
pipeline::Result<Sheets> makeSheets(const SheetTemplate& made, const SheetOptions& options,
                                    const pipeline::Stop& stop = {},
                                    const std::function<void(std::size_t sheet)>& progress = {});

// sheet-01.html … and sheet-01-answers.json …, to be filled in, into `folder`, and sheet-01-key.html …, sheets.csv and
// sheets.json into its folder "keys": all of them, or none. Those of an earlier draw go. Gives the number of files.
pipeline::Result<std::size_t> writeSheets(const Sheets& sheets, const SheetTemplate& made, const SheetOptions& options,
                                          const std::filesystem::path& folder);

// What grading needs of the sheets that were given out.
struct SheetKeys {
    std::string lesson;                        // the name of its folder
    std::filesystem::path folder;              // of the template, for its scenes
    std::map<std::size_t, std::string> texts;  // of each sheet, by its number
    std::map<std::size_t, std::string> draws;  // of each sheet; none of sheets that an earlier version has written
};
// From sheets.json.
std::string drawNumber(const Sheet& sheet);  // from its text and answers

inline constexpr const char* kSheetIndex = "keys/sheets.json";
// All files of so many sheets, in the folder of the sheets, the index last.
std::vector<std::string> sheetFiles(std::size_t count);
pipeline::Result<SheetKeys> readSheetKeys(const std::filesystem::path& file);

}  // namespace lessons
