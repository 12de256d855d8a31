#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/core/result.h"
#include "pipeline/steps/steps.h"

namespace pipeline {

// A film of a frame's build-up: one buffer, step by step, each picture with a line that says where it stands.
struct FilmRequest {
    BufferName buffer{BufferId::Color};
    StepLevel level = StepLevel::Polygon;
    Moment from, to;             // the first picture and the last
    std::size_t pictures = 120;  // at most; where there are more steps, evenly spread ones, the last among them
    int milliseconds = 100;      // a picture, in a GIF; the last stays ten times as long
    bool captions = true;
    bool algorithm = false;  // with its lines and values, below each picture
};

// The moments that the film shows, ascending; `from` and `to` are among them.
std::vector<Moment> filmMoments(const Steps& steps, const FilmRequest& request);
// The names of a film in a folder: its pictures, and film.json last.
std::vector<std::string> filmFiles(const Steps& steps, const FilmRequest& request);

// One picture: the buffer at the moment in the colours of the whole frame's range, so that they mean the same all
// along, and below it a line in words. Before the buffer's stage has begun, black. The buffer has pixels.
Buffer2D<Color8> filmPicture(const Steps& steps, Moment moment, const FilmRequest& request);

// Whether a film of this name is one file, "film.gif" or "FILM.GIF"; any other is a folder.
bool isGif(const std::filesystem::path& target);
// "film.gif", or the first picture in the folder.
std::filesystem::path firstFileOf(const std::filesystem::path& target);

// Called before each picture; false cancels.
using FilmProgress = std::function<bool(std::size_t done, std::size_t all)>;
struct FilmSummary {
    bool cancelled = false;  // nothing was written
    std::size_t pictures = 0;
    std::uint64_t bytes = 0;
    std::size_t behind = 0;  // pictures in the folder that go on where the film ends; of no film, and left alone
    std::vector<std::string> removed{};  // of the film that was there before
    std::string inDoubt{};               // why its pictures were not those of its film.json
};
// Writes "FILE.gif", or into a folder step_0001.png, step_0002.png… and film.json: what the film shows, where each
// picture stands, and the hashes of the pictures. All of it, or nothing; film.json goes first and comes last, and a film
// that was there goes. A GIF has at most 256 colours a picture. The same request gives the same bytes on one machine; another may have other letters.
Result<FilmSummary> writeFilm(const Steps& steps, const FilmRequest& request, const std::filesystem::path& target,
                              const FilmProgress& progress = {});

}  // namespace pipeline
