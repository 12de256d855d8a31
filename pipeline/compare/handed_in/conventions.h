#pragma once
#include <map>

#include "pipeline/compare/handed_in/reading.h"
#include "pipeline/compare/reference_values.h"

namespace pipeline::foreign {

// What somebody has said of the files: of mine.toml.
struct StatedConventions {
    std::optional<bool> bottomUp, mirrored, bgr;
    std::map<std::string, Coding> codings{};           // by their key; each counts for the buffers that can have it
    std::map<std::string, StatedConventions> files{};  // by the buffer's name: what is said of one file alone
    // What counts for a file: its own first, then what is said of all.
    StatedConventions of(const HandedFile& file) const;
    bool states(const HandedFile& file, const ReadingContext& context) const;  // how its numbers are coded
    bool atCorner() const {
        const auto sample = codings.find("sample");
        return sample != codings.end() && sample->second == Coding::Corner;
    }
};
// All readings that a file may have, but for those that are stated to be others; of vertices in the picture y upwards too.
std::vector<Reading> allowedReadings(const HandedFile& file, const ReadingContext& context,
                                     const StatedConventions& stated);

// rows = "top-down", columns = "left-to-right", channels = "rgb", and the keys of the table of codings; of one file in a
// table of its name, [depth]. An unknown key or value is an error with line and column.
Result<StatedConventions> readStated(const std::string& text, const std::string& name);

// How sure a convention is.
enum class Certainty : std::uint8_t {
    Clear,      // at least three times as close as the next reading
    Agreed,     // this file cannot tell, the others can
    Stated,     // in mine.toml
    Explains,   // with the error that is named
    CannotTell  // no reading is clearly better: the program's own is taken
};
struct Convention {
    std::string buffer;
    std::string words;       // "rows bottom-up"
    std::string key, value;  // for mine.toml
    Certainty certainty = Certainty::Clear;
    double margin = 1;  // how many times as close as the next reading; infinite where that one explains nothing
    bool own = false;   // the program's own: said only where nobody can tell
};

// A file with the reading that is taken for it, and the others that could be meant.
struct ReadFile {
    const HandedFile* file = nullptr;
    Reading reading;
    Values mine;
    std::vector<Reading> others{};  // of channels and coding, nearly as close: a wrong buffer cannot tell them apart
};

struct Conventions {
    std::vector<ReadFile> files;
    std::vector<Convention> said;
    ReadingContext context{};             // of their files: with what they show where nothing is drawn
    std::optional<bool> towardsViewer{};  // z of the folder's normals in view space, if there are any
};

// Whether all pictures of a folder have one order of rows and columns, as they have if one program has written them. A file
// that is turned round by itself may be read so only where all of them agree then: else a wrong one would be made to fit.
enum class Together : bool { No, Yes };
Conventions findConventions(const HandedIn& in, const ReferenceValues& reference, const ReadingContext& context,
                            const std::map<std::string, double>& tolerances, const StatedConventions& stated,
                            Together together);

}  // namespace pipeline::foreign
