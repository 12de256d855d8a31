#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/frame_argument.h"
#include "app/cli/scene_argument.h"
#include "lessons/condition.h"
#include "pipeline/export/json.h"
#include "pipeline/export/table_json.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/runner.h"

namespace app {

namespace {

struct InspectOptions {
    SceneArgument scene;
    std::string pixel, table, where;
    std::string format = "text";
    int threads = 0;
    bool json = false;
};

pipeline::FramePtr frameOf(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options,
                           pipeline::BufferSet wanted = {}) {
    pipeline::FrameRequest request;
    request.wanted = wanted;
    request.threads = options.threads;
    return runFrame(std::move(scene), request, nullptr);
}

int printTable(std::shared_ptr<const pipeline::Scene> scene, const InspectOptions& options) {
    const auto id = pipeline::findTable(options.table).value();  // CLI11 has checked both words
    const auto format = std::ranges::find(pipeline::kTableFormats, options.format);
    const auto write = [](std::string_view text) { fmt::print("{}", text); };
    const pipeline::SceneTable table = sceneTable(frameOf(std::move(scene), options), id);
    const std::vector<std::uint32_t> rows = allRows(table);
    if (options.json)
        writeTableJson(table, rows, write);
    else
        writeTable(table, rows, pipeline::TableFormat(format - pipeline::kTableFormats.begin()), write);
    return kDone;
}

// The pixels that a condition holds for, in reading order: the first of them as text, all as JSON.
int printWhere(const std::shared_ptr<const pipeline::Scene>& scene, const InspectOptions& options) {
    const auto condition = lessons::parseCondition(options.where, {"--where", 1, 1}, *scene);
    if (!condition) {
        printErrors(condition.errors());
        return kWrongUsage;
    }
    const pipeline::FramePtr frame = frameOf(scene, options, condition->buffers);
    const auto mask = evaluate(*condition, *frame);
    if (!mask) {
        printErrors(mask.errors());
        return kBadInput;
    }
    constexpr std::size_t kShown = 20;
    const std::size_t most = options.json ? mask->count : std::min(mask->count, kShown);
    std::vector<glm::ivec2> pixels;
    std::optional<glm::ivec2> at;
    while (pixels.size() < most) pixels.push_back(*(at = nextHolding(*mask, at)));
    if (options.json) {
        pipeline::Json list = pipeline::Json::array();
        for (const glm::ivec2 pixel : pixels) list.push_back({pixel.x, pixel.y});
        const pipeline::Json all{
            {"condition", condition->text}, {"count", mask->count}, {"drawn", mask->drawn}, {"pixels", list}};
        fmt::print("{}\n", all.dump(2, ' ', false, pipeline::Json::error_handler_t::replace));
        return kDone;
    }
    fmt::print("{} of {} pixels where something was drawn\n", mask->count, mask->drawn);
    for (const glm::ivec2 pixel : pixels) fmt::print("{},{}\n", pixel.x, pixel.y);
    if (mask->count > most) fmt::print("and {} more; --json lists all\n", mask->count - most);
    return kDone;
}

int runInspect(const InspectOptions& options) {
    int status = kDone;
    const auto scene = loadScene(options.scene, status);
    if (!scene) return status;
    if (!options.table.empty()) return printTable(scene, options);
    if (!options.where.empty()) return printWhere(scene, options);
    const auto pixel = pixelIn(*scene, options.pixel);
    if (!pixel) return kWrongUsage;
    const pipeline::FramePtr frame = frameOf(scene, options);
    const pipeline::PixelReport report = inspectPixel(*frame, *pixel);
    if (options.json)
        fmt::print("{}\n", toJson(*frame, report).dump(2, ' ', false, pipeline::Json::error_handler_t::replace));
    else
        fmt::print("{}", toText(*frame, report));
    return kDone;
}

}  // namespace

void declareInspect(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App* command = program.add_subcommand(
        "inspect", "Print everything known about a pixel, its equation included, a table, or where a condition holds");
    declareSceneArgument(*command, options->scene);
    CLI::Option_group* what = command->add_option_group("what");
    what->add_option("--pixel", options->pixel, "Column and row, from 0 at the top left")->type_name("X,Y");
    std::vector<std::string> tables;
    for (std::size_t i = 0; i < pipeline::kTableCount; ++i) tables.emplace_back(name(pipeline::TableId(i)));
    CLI::Option* table =
        what->add_option("--table", options->table, "An array of the scene: " + CLI::detail::join(tables, ", "))
            ->type_name("TABLE")
            ->check(CLI::IsMember(tables));
    what->add_option("--where", options->where, "The pixels that a condition holds for: \"n_dot_l.0 < 0.5\"")
        ->type_name("CONDITION");
    what->require_option(1);
    const std::vector<std::string> formats(pipeline::kTableFormats.begin(), pipeline::kTableFormats.end());
    CLI::Option* format =
        command->add_option("--format", options->format, "How to write the table: " + CLI::detail::join(formats, ", "))
            ->type_name("FORMAT")
            ->check(CLI::IsMember(formats))
            ->needs(table);
    declareThreads(*command, options->threads);
    command->add_flag("--json", options->json, "Print JSON")->excludes(format);
    command->callback([options, &status] { status = runInspect(*options); });
}

}  // namespace app
