#include <memory>

#include "app/web/core/core.h"
#include "app/web/core/scene_text.h"
#include "lessons/games/wrong_picture.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"

namespace pipeline {

// Those that the page has given.
std::vector<BuiltInScene> builtInScenes() {
    std::vector<BuiltInScene> scenes;
    for (const auto& one : web::core().files) {
        const std::string& name = one.first;
        if (name.ends_with(".toml") || name.ends_with(".scene"))
            scenes.push_back({.name = name.substr(0, name.rfind('.')), .title = {}, .look = {}, .file = name});
    }
    return scenes;
}
Result<Scene> readScene(const std::filesystem::path& file, const ReadProgress&) {
    const auto text = readFile(file, std::size_t(-1));
    return text ? web::sceneFromText(file.string(), *text) : text.errors();
}

}  // namespace pipeline

// The wrong picture: somebody looks for a planted error. The game knows no page; pictures are those of picture().

namespace web {

namespace {

using lessons::WrongPicture;

std::unique_ptr<WrongPicture> s_game;

// What is known of the game. said: by the call before, as the command prints it.
Json gameJson(const std::string& said = {}) {
    const WrongPicture& game = *s_game;
    const auto phase = game.phase();
    Json boxes = Json::array(), causes = Json::array();
    for (int box = 0; box < lessons::kBoxes; ++box)
        boxes.push_back({{"label", lessons::boxLabel(box)}, {"cleared", game.isCleared(box)}});
    if (phase != WrongPicture::Phase::Stage)
        for (std::size_t i = 0; i < game.riddle().causes.size(); ++i)
            causes.push_back({{"name", defectInfo(game.riddle().causes[i]).name}, {"excluded", game.isExcluded(i)}});
    const bool isOver = phase == WrongPicture::Phase::Over;
    return {{"scene", game.row().scene},
            {"phase", phase == WrongPicture::Phase::Stage ? "stage"
                      : isOver                            ? "over"
                                                          : "cause"},
            {"boxes", boxes},
            {"causes", causes},
            {"looks", game.looks().size()},
            {"par", game.riddle().par},
            {"hints", game.hints()},
            {"points", game.points()},
            {"said", said},
            {"reveal", isOver ? game.reveal() : ""}};
}

}  // namespace

// A picture by a seed and its number, from 0: the riddle that `shadescope bug --seed` has there.
WEB_CALL(game) int webGame(double seed, int number) {
    auto riddle = lessons::makeRiddle(std::uint64_t(seed), std::size_t(number));
    if (!riddle) return refuse(riddle.errors());
    s_game = WrongPicture::begin(std::move(riddle).value());
    core().own = {};
    core().own.scene = s_game->wrong()->sharedScene(), core().own.frame = s_game->wrong();
    return give(gameJson(s_game->look(pipeline::BufferName{pipeline::BufferId::Color})));
}

// A buffer by its name, or with an empty name the pixel.
WEB_CALL(game_look) int webGameLook(const char* text, int size, int x, int y) {
    if (!s_game) return refuse("no game was begun");
    const std::string_view what = textAt(text, size);
    const pipeline::Settings& settings = s_game->wrong()->scene().settings;
    if (what.empty() && (x < 0 || y < 0 || x >= settings.width || y >= settings.height)) return refuse("no such pixel");
    if (what.empty()) return give(gameJson(s_game->look(glm::ivec2(x, y))));
    const auto name = pipeline::findBuffer(what);
    if (!name) return refuse("no buffer \"" + std::string(what) + "\"; " + pipeline::insteadOfBuffer(what));
    return give(gameJson(s_game->look(*name)));
}

// This box is wrong first, 0 to 6.
WEB_CALL(game_mark) int webGameMark(int box) {
    if (!s_game || s_game->phase() != WrongPicture::Phase::Stage || box < 0 || box >= lessons::kBoxes)
        return refuse("no stage is asked for");
    return give(gameJson(s_game->mark(box).why));
}

// This is the cause, 0 to 4.
WEB_CALL(game_name) int webGameName(int cause) {
    if (!s_game || s_game->phase() != WrongPicture::Phase::Cause || cause < 0 ||
        std::size_t(cause) >= s_game->riddle().causes.size())
        return refuse("no cause is asked for");
    return give(gameJson(s_game->name(std::size_t(cause)).why));
}

WEB_CALL(game_hint) int webGameHint() {
    if (!s_game) return refuse("no game was begun");
    return give(gameJson(s_game->hint()));
}

}  // namespace web
