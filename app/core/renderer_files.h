#pragma once
#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/compare/verdict.h"

// What the window makes of another renderer's files, beside what pipeline/compare says of them.
namespace app {

// Names, sizes and times of the files in folders, and of files by themselves: another text where one has changed.
QString stampOf(const QStringList& paths);

// The text of mine.toml with other values for these keys.
using StatedByHand = std::map<std::string, std::string>;
std::string withStated(const std::string& text, const StatedByHand& byHand);

// One key of mine.toml that some of the files can be read by.
struct ConventionChoice {
    std::string key;
    std::string value;                // as the files are read now
    std::vector<std::string> values;  // all that there are
    QString certainty;                // "28 × closer"; empty where the program's own reading is taken without a word
    QString buffers;                  // that are read so: "color, depth"
};
// Those that were found first.
std::vector<ConventionChoice> conventionChoices(const pipeline::foreign::Report& report);

// A buffer that was handed in, in the type of `like`, this program's of the same name; nothing where it was not handed in.
std::optional<pipeline::AnyBuffer> handedBuffer(const pipeline::foreign::Report& report,
                                                const pipeline::AnyBuffer& like);

}  // namespace app
