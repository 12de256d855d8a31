#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/arguments/derived_argument.h"
#include "app/cli/arguments/frame_argument.h"
#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/library_guard.h"
#include "app/cli/message.h"
#include "pipeline/core/text.h"
#include "pipeline/export/figure/figure.h"
#include "pipeline/run/runner.h"

namespace app {
namespace {

struct FigureOptions {
    SceneArgument scene;
    DerivedArgument derived;
    std::string target, buffer = "color", pixel, part, range, caption, width, format;
    std::string colors = "light";
    double letters = 8, dots = 300;
    int threads = 0;
    bool noBar = false, scale = false, grid = false, edges = false, hasCaption = false;
};

int wrongFigure(const std::string& why) {
    tell("shadescope figure: {}\n", why);
    return kWrongUsage;
}

// As many finite numbers as asked for, with commas between them.
std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count) {
    std::vector<double> numbers;
    while (numbers.size() < count) {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        numbers.push_back(value);
        text.remove_prefix(std::size_t(end - text.data()));
        if (numbers.size() == count) break;
        if (!text.starts_with(',')) return std::nullopt;
        text.remove_prefix(1);
    }
    return text.empty() ? std::optional(numbers) : std::nullopt;
}

// "84mm" or "84".
std::optional<double> millimetres(std::string_view text) {
    if (text.ends_with("mm")) text.remove_suffix(2);
    const auto value = numbersIn(text, 1);
    if (!value || (*value)[0] < pipeline::kLeastFigure || (*value)[0] > pipeline::kMostFigure) return std::nullopt;
    return (*value)[0];
}

// By name, else by the ending of the file.
std::optional<pipeline::FigureFormat> formatOf(const FigureOptions& options) {
    const std::string name = !options.format.empty() ? options.format
                             : options.target == kStandardOutput
                                 ? "svg"
                                 : std::filesystem::path(options.target).extension().string();
    if (name.ends_with("svg")) return pipeline::FigureFormat::Svg;
    if (name.ends_with("pdf")) return pipeline::FigureFormat::Pdf;
    if (name.ends_with("png")) return pipeline::FigureFormat::Png;
    return std::nullopt;
}

// A pixel of the buffer, or nothing.
std::optional<glm::ivec2> pixelOf(const pipeline::AnyBuffer& buffer, const std::string& text) {
    const auto at = parsePair(text, ',');
    const bool isInside =
        at && at->x >= 0 && at->y >= 0 && std::size_t(at->x) < buffer.columns() && std::size_t(at->y) < buffer.rows();
    return isInside ? at : std::nullopt;
}

// What is wrong with the options that depend on the buffer, or nothing.
std::string place(const FigureOptions& options, pipeline::Figure& figure) {
    const auto size = [&] { return fmt::format("{} × {}", figure.buffer.columns(), figure.buffer.rows()); };
    if (!options.part.empty()) {
        const auto numbers = numbersIn(options.part, 4);
        const auto whole = [](double value) { return value == std::floor(value) && std::abs(value) < 1e9; };
        const std::string wrong = fmt::format("--part {}: the first and the last column and row, X,Y,X,Y, inside {}",
                                              pipeline::inQuotes(options.part), size());
        if (!numbers || !std::ranges::all_of(*numbers, whole)) return wrong;
        const pipeline::Figure::Part part{{int((*numbers)[0]), int((*numbers)[1])},
                                          {int((*numbers)[2]), int((*numbers)[3])}};
        if (part.first.x < 0 || part.first.y < 0 || part.last.x < part.first.x || part.last.y < part.first.y ||
            std::size_t(part.last.x) >= figure.buffer.columns() || std::size_t(part.last.y) >= figure.buffer.rows())
            return wrong;
        figure.part = part;
    }
    if (!options.pixel.empty()) {
        figure.pixel = pixelOf(figure.buffer, options.pixel);
        if (!figure.pixel)
            return fmt::format("--pixel {}: a column and a row, X,Y, inside {}", pipeline::inQuotes(options.pixel),
                               size());
        const auto& at = *figure.pixel;
        if (const auto& part = figure.part;
            part && (at.x < part->first.x || at.x > part->last.x || at.y < part->first.y || at.y > part->last.y))
            return "--pixel is outside --part";
    }
    if (!options.range.empty()) {
        const auto range = numbersIn(options.range, 2);
        if (!range || (*range)[0] == (*range)[1])
            return fmt::format("--range {}: two different numbers, FIRST,LAST", pipeline::inQuotes(options.range));
        figure.range = {(*range)[0], (*range)[1]};
    }
    return {};
}

// The buffer of a finished frame: its own, or made of it. False: the reason went to standard error.
struct Found {
    std::optional<pipeline::AnyBuffer> buffer;
    std::string meaning;
    int status = kDone;
};
Found bufferOf(const FigureOptions& options, const std::shared_ptr<const pipeline::Scene>& scene,
               const Interrupt& interrupt, pipeline::FramePtr& frame) {
    const auto derivedName = pipeline::findDerived(options.buffer);
    const auto named =
        derivedName ? pipeline::Result<pipeline::BufferName>(*derivedName) : bufferNamed(*scene, options.buffer, true);
    if (!named) {
        printErrors(named.errors());
        return {{}, {}, kWrongUsage};
    }
    const pipeline::BufferInfo& info = bufferInfo(named->id);
    if (info.domain != pipeline::Domain::Pixel && info.domain != pipeline::Domain::Texel)
        return {{}, {}, wrongFigure(fmt::format("{} has no pixels, so that there is no picture of it", named->text()))};
    if (options.edges && info.domain == pipeline::Domain::Texel)
        return {{}, {}, wrongFigure(fmt::format("--edges: {} is no picture of the camera", named->text()))};
    const bool isMade = pipeline::isDerived(named->id);
    const auto made = derivedWanted(options.derived, isMade ? std::vector{*named} : std::vector<pipeline::BufferName>(),
                                    *scene, std::nullopt);
    if (!made) {
        printErrors(made.errors());
        return {{}, {}, kWrongUsage};
    }
    pipeline::FrameRequest request;
    request.threads = options.threads;
    request.stop = interrupt.token();
    request.wanted = made->buffers | pipeline::setOf({pipeline::BufferId::PolygonId});
    if (!isMade) request.wanted.set(index(named->id));
    if (options.edges) request.wanted |= pipeline::outlineBuffers();
    int status = kDone;
    if (!fits(*scene, request, options.scene, status)) return {{}, {}, status};
    frame = runFrame(scene, request, nullptr);
    if (!frame) return {{}, {}, kInterrupted};
    tellRemarks(*frame);
    if (!isMade) {
        auto buffer = frame->buffer(*named);
        if (!buffer) return {{}, {}, wrongFigure(fmt::format("no {}. {}", named->text(), frame->whyAbsent(*named)))};
        return {std::move(buffer), std::string(info.meaning)};
    }
    auto derived = derivedOf(*made, *frame, options.threads, interrupt.token());
    if (!derived) {
        printErrors(derived.errors());
        return {{}, {}, kBadInput};
    }
    for (auto& one : *derived)
        if (one.buffer.name == *named) return {std::move(one.buffer), std::move(one.meaning)};
    return {{}, {}, kInterrupted};
}

int runFigure(const FigureOptions& options) {
    if (options.target.empty()) return wrongFigure("-o needs the name of a file");
    const auto format = formatOf(options);
    if (!format) return wrongFigure("-o: expected a file that ends in .svg, .pdf or .png, or --format");
    const auto width = millimetres(options.width);
    if (!width)
        return wrongFigure(fmt::format("--width {}: a width of {} to {} mm", pipeline::inQuotes(options.width),
                                       pipeline::kLeastFigure, pipeline::kMostFigure));
    const Interrupt interrupt;
    int status = kDone;
    const auto scene = loadScene(options.scene, interrupt.token(), status);
    if (!scene) return status;
    if (!mayWriteTo(options.target)) return kCouldNotWrite;
    pipeline::FramePtr frame;
    Found found = bufferOf(options, scene, interrupt, frame);
    if (interrupt.asked()) return tellCancelled();
    if (!found.buffer) return found.status;
    pipeline::Figure figure = figureOf(*frame, std::move(*found.buffer));
    if (const std::string wrong = place(options, figure); !wrong.empty()) return wrongFigure(wrong);
    figure.hasBar = !options.noBar, figure.hasScale = options.scale, figure.hasGrid = options.grid;
    if (options.edges) figure.outlines = polygonOutlines(*frame, figure.part);
    figure.width = *width, figure.letters = options.letters, figure.dotsPerInch = options.dots;
    figure.isForProjector = options.colors == "projector";
    figure.caption = options.hasCaption ? options.caption : captionOf(figure, *scene, found.meaning);
    const auto bytes = guarded(pipeline::figureFile)(figure, *format);
    if (!bytes) {
        printErrors(bytes.errors());
        return kWrongUsage;
    }
    if (const auto errors = writeOutput(options.target, *bytes); !errors.empty()) {
        printErrors(errors);
        return kCouldNotWrite;
    }
    const pipeline::FigureSize size = sizeOf(figure);
    tell("{:.1f} × {:.1f} mm, ", size.width, size.height);
    tellWritten(options.target, bytes->size());
    return kDone;
}

}  // namespace

void declareFigure(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<FigureOptions>();
    options->width = "84";
    CLI::App* command = program.add_subcommand(
        "figure", "Write a buffer as a figure for a text: palette bar, marked pixel and caption, as SVG, PDF or PNG");
    declareSceneArgument(*command, options->scene);
    command->add_option("-o,--output", options->target, "A file that ends in .svg, .pdf or .png; - is standard output")
        ->required()
        ->type_name("FILE");
    command->add_option("--buffer,-B", options->buffer, "Which buffer the figure shows")
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--pixel", options->pixel, "Mark a pixel, with its value")->type_name("X,Y");
    command->add_option("--part", options->part, "Only the columns and rows from X,Y to X,Y")->type_name("X,Y,X,Y");
    command
        ->add_option("--range", options->range,
                     "The values at the two ends of the palette; all that is seen unless given")
        ->type_name("FIRST,LAST");
    CLI::Option* caption =
        command->add_option("--caption", options->caption, "The text below; one is made unless given, and \"\" is none")
            ->type_name("TEXT");
    command->add_option("--width", options->width, "Of the whole figure, in mm: 84 or 84mm")
        ->type_name("MM")
        ->capture_default_str();
    command->add_option("--text", options->letters, "The size of letters in pt")
        ->type_name("PT")
        ->check(CLI::Range(pipeline::kLeastLetters, pipeline::kMostLetters))
        ->capture_default_str();
    command->add_option("--dpi", options->dots, "Dots per inch of a PNG")
        ->type_name("N")
        ->check(CLI::Range(pipeline::kLeastDots, pipeline::kMostDots))
        ->capture_default_str();
    command->add_flag("--no-bar", options->noBar, "Leave out the palette's bar");
    command->add_flag("--grid", options->grid, "Draw lines between the pixels");
    command->add_flag("--edges", options->edges, "Draw the edges of the polygons that go on to the z-buffer");
    command->add_flag("--scale-bar", options->scale, "Show how long some pixels are");
    command->add_option("--colors", options->colors, "Of lines and letters: light, or projector with more contrast")
        ->type_name("THEME")
        ->check(CLI::IsMember({"light", "projector"}))
        ->capture_default_str();
    command->add_option("--format", options->format, "The file's format, whatever it is called")
        ->type_name("FORMAT")
        ->check(CLI::IsMember({"svg", "pdf", "png"}));
    declareDerived(*command, options->derived);
    declareThreads(*command, options->threads);
    command->callback([options, caption, &status] {
        options->hasCaption = caption->count() > 0;
        status = runFigure(*options);
    });
}

}  // namespace app
