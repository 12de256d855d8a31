#include "tests/architecture/rules.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

namespace architecture {
namespace {

bool isSource(const SourceFile& file) { return file.path.ends_with(".h") || file.path.ends_with(".cpp"); }

std::string breach(const SourceFile& file, std::size_t line, const std::string& found, std::string_view rule) {
    return file.path + ":" + std::to_string(line) + ": " + found + "; " + std::string(rule);
}

struct Include {
    std::size_t line;  // from 1
    std::string target;
    bool quoted;  // "target", not <target>
};

std::vector<Include> includesOf(const SourceFile& file) {
    static const std::regex directive(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> includes;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (std::regex_search(file.lines[i], match, directive)) includes.push_back({i + 1, match[2], match[1] == "\""});
    }
    return includes;
}

// Says of each include of each C++ file what rule it breaks, if any.
template <class RuleBroken>
Breaches checkIncludes(const SourceTree& tree, RuleBroken ruleBroken) {
    Breaches breaches;
    for (const SourceFile& file : tree) {
        if (!isSource(file)) continue;
        for (const Include& include : includesOf(file)) {
            const std::string_view rule = ruleBroken(file, include);
            if (!rule.empty()) breaches.push_back(breach(file, include.line, "includes " + include.target, rule));
        }
    }
    return breaches;
}

// Lines that match, in the C++ files that a condition on their path chooses.
template <class Chosen>
void findLines(const SourceTree& tree, Chosen chosen, const std::regex& pattern, std::string_view rule,
               Breaches& breaches) {
    for (const SourceFile& file : tree) {
        if (!isSource(file) || !chosen(file.path)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_search(file.lines[i], match, pattern))
                breaches.push_back(breach(file, i + 1, "has " + match.str(), rule));
        }
    }
}

// The libraries, each above those it may include: a folder and its height.
struct Layer {
    std::string_view folder;
    int height;
};
constexpr std::array kLayers{
    Layer{"pipeline/defects/defect.h", 0},
    Layer{"pipeline/defects/hooks.h", 0},  // each stage has a line
    Layer{"pipeline/defects/drawing_hooks.h", 0},
    Layer{"pipeline/defects/", 7},
    Layer{"pipeline/core/", 0},
    Layer{"pipeline/scene/", 1},
    Layer{"pipeline/buffers/", 2},
    Layer{"pipeline/illumination/", 3},
    Layer{"pipeline/stages/", 4},
    Layer{"pipeline/simd/", 5},
    Layer{"pipeline/plan/", 6},
    Layer{"pipeline/run/", 7},
    Layer{"pipeline/contracts/", 8},
    Layer{"pipeline/inspect/", 8},
    Layer{"pipeline/steps/", 9},
    Layer{"pipeline/study/", 9},
    Layer{"pipeline/formats/", 10},
    Layer{"pipeline/export/", 11},
    Layer{"pipeline/check/", 12},
    Layer{"pipeline/compare/", 12},
    Layer{"lessons/state/", 12},
    Layer{"lessons/", 13},
    Layer{"app/headless/", 14},
    Layer{"app/cli/", 14},
    Layer{"app/python/", 14},
    Layer{"app/web/", 14},
    Layer{"app/look/", 15},
    Layer{"app/jobs/", 16},
    Layer{"app/frames/", 17},
    Layer{"app/document/", 18},
    Layer{"app/drawing3d/", 19},
    Layer{"app/vtk/", 20},
    Layer{"app/view3d/", 21},
    Layer{"app/widgets/", 22},
    Layer{"app/canvas/", 23},
    Layer{"app/holds/", 24},
    Layer{"app/compare/", 25},
    Layer{"app/buffer_view/", 26},
    Layer{"app/inspector/", 27},
    Layer{"app/settings/", 28},
    Layer{"app/stages/", 29},
    Layer{"app/tables/", 30},
    Layer{"app/my_renderer/", 31},
    Layer{"app/lesson/", 32},
    Layer{"app/study/", 33},
    Layer{"app/start/", 34},
    Layer{"app/check/", 35},
    Layer{"app/bug_game/", 36},
    Layer{"app/views/", 37},
    Layer{"app/commands/", 38},
    Layer{"app/export/", 39},
    Layer{"app/talk/", 40},
    Layer{"app/docks/", 41},
    Layer{"app/desktop/", 42},
    Layer{"tests/", 43},
};

const Layer* layerOf(std::string_view path) {
    const auto layer = std::ranges::find_if(kLayers, [&](const Layer& l) { return path.starts_with(l.folder); });
    return layer == kLayers.end() ? nullptr : &*layer;
}

// The rooms of app/ that are made with Qt.
bool isOfWindow(std::string_view path) {
    return path.starts_with("app/") &&
           std::ranges::none_of(std::array{"app/cli/", "app/headless/", "app/python/", "app/web/"},
                                [&](const char* folder) { return path.starts_with(folder); });
}

// The part of a path without its ending: a panel's pair of files has one stem.
std::string_view stem(std::string_view path) { return path.substr(0, path.rfind('.')); }

bool isQt(std::string_view header) {
    return header.starts_with("Qt") || (header.size() > 1 && header[0] == 'Q' && header[1] >= 'A' && header[1] <= 'Z');
}

}  // namespace

Breaches unrootedIncludes(const SourceTree& tree) {
    std::set<std::string> paths;
    for (const SourceFile& file : tree) paths.insert(file.path);
    return checkIncludes(tree, [&](const SourceFile& file, const Include& include) -> std::string_view {
        if (!include.quoted || paths.contains(include.target)) return "";
        // What a build step makes from a file stands in no folder.
        if (include.target.ends_with(".moc") && stem(file.path).ends_with(stem(include.target))) return "";
        return "a header of the project is there, and included by its path from the root";
    });
}

Breaches includesPointingBack(const SourceTree& tree) {
    return checkIncludes(tree, [](const SourceFile& file, const Include& include) -> std::string_view {
        const Layer* from = layerOf(file.path);
        const Layer* to = layerOf(include.target);
        if (!from && (file.path.starts_with("pipeline/") || isOfWindow(file.path)))
            return "a folder of the pipeline and a room of the window have a row in this test";
        if (!from || !to || from->folder == to->folder) return "";
        if (from->folder == "app/cli/" && isOfWindow(to->folder)) return "app/cli is built without Qt";
        const bool isAlone = from->folder == "app/web/" || from->folder == "app/headless/";
        if (isAlone && to->folder.starts_with("app/") && to->folder != "app/headless/")
            return "the core of live pages has commands without a terminal, lessons and the pipeline alone";
        if (to->height > from->height)
            return isOfWindow(from->folder) && isOfWindow(to->folder)
                       ? "a room of the window includes only rooms above it in the table of this test"
                       : "arrows point from app to lessons to lessons/state to pipeline_io to pipeline, there from "
                         "run to plan to simd to stages to illumination to buffers to scene to core";
        return "";
    });
}

Breaches panelsIncludingPanels(const SourceTree& tree) {
    // The panels are what the table of panels includes of the rooms between the widgets and the views; the other headers
    // beside them are their parts.
    constexpr std::string_view kTable = "app/docks/panel_table.cpp";
    const auto isFeature = [](const Layer& room) {
        return room.height > layerOf("app/widgets/")->height && room.height < layerOf("app/views/")->height;
    };
    std::set<std::string> panels;
    for (const SourceFile& file : tree) {
        if (file.path != kTable) continue;
        for (const Include& include : includesOf(file)) {
            const Layer* room = layerOf(include.target);
            if (room && isFeature(*room)) panels.insert(include.target);
        }
    }
    return checkIncludes(tree, [&](const SourceFile& file, const Include& include) -> std::string_view {
        const Layer* room = layerOf(file.path);
        if (!room || !isFeature(*room) || !panels.contains(include.target)) return "";
        const std::string_view own = stem(file.path), panel = stem(include.target);
        if (own == panel || (own.starts_with(panel) && own.substr(panel.size()).starts_with("_")))
            return "";  // its own files
        return "a panel knows no other panel; both follow the document";
    });
}

Breaches misplacedToolkits(const SourceTree& tree) {
    return checkIncludes(tree, [](const SourceFile& file, const Include& include) -> std::string_view {
        const std::string_view path = file.path;
        const bool qtHere = isOfWindow(path) || path.starts_with("tests/app/");
        if (isQt(include.target) && !qtHere) return "Qt stands in app, outside app/cli, app/python and app/web";
        // A test reads with VTK what export writes for it.
        const bool vtkHere = path.starts_with("app/vtk/") || path == "tests/app/view3d/vtk_file_test.cpp";
        if (include.target.starts_with("vtk") && !vtkHere) return "VTK stands in app/vtk";
        const bool jsonHere = path == "pipeline/export/json/json_value.cpp" ||
                              path == "pipeline/formats/text/json_error.cpp" ||
                              path == "pipeline/formats/gltf/gltf_value.h" || path.starts_with("tests/");
        if (include.target.starts_with("nlohmann/") && !jsonHere) return "JSON is pipeline/export/json/json_value.h";
        return "";
    });
}

// Writing to a string is not printing: fmt::format passes.
static const std::regex kPrinting(
    R"(#\s*include\s*<iostream>|\bstd::c(out|err|log)\b|\b(f|v|vf)?printf\s*\(|\bf?puts\s*\(|\bfmt::print\b)");

Breaches printingPastMessages(const SourceTree& tree) {
    Breaches breaches;
    findLines(
        tree,
        [](const std::string& path) {
            return (path.starts_with("app/") || path.starts_with("lessons/")) && path != "app/cli/message.cpp";
        },
        kPrinting, "what is printed goes through app/cli/message.h", breaches);
    return breaches;
}

Breaches markupInNewPlaces(const SourceTree& tree) {
    static constexpr std::string_view known =
        " app/buffer_view/buffer_captions app/buffer_view/region_panel app/desktop/manual_window "
        "app/docks/status_line app/holds/held_files app/inspector/inspector_panel app/inspector/terms_section "
        "app/inspector/why_section app/jobs/application app/lesson/prose_view app/look/style_sheet "
        "app/settings/setting_row app/settings/settings_panel app/talk/clean_view ";
    static const std::regex markup(
        R"(Qt::(RichText|MarkdownText|AutoText)|\b(setHtml|insertHtml|fromHtml|setMarkdown|fromMarkdown)\b|\bQ(TextBrowser|StaticText)\b)");
    Breaches breaches;
    findLines(
        tree,
        [](const std::string& path) {
            return path.starts_with("app/") && known.find(' ' + std::string(stem(path)) + ' ') == known.npos;
        },
        markup, "a text of a file is shown as it is", breaches);
    return breaches;
}

Breaches impurePipeline(const SourceTree& tree) {
    Breaches breaches;
    findLines(
        tree, [](const std::string& path) { return path.starts_with("pipeline/"); }, kPrinting,
        "the pipeline does not print", breaches);
    static const std::regex scheduling(
        R"(#\s*include\s*(<(thread|mutex|atomic|future|condition_variable)>|[<"](oneapi/)?tbb/|"pipeline/(run|plan)/))");
    findLines(
        tree, [](const std::string& path) { return path.starts_with("pipeline/stages/"); }, scheduling,
        "a stage knows neither threads nor plan nor runner", breaches);
    return breaches;
}

Breaches numbersOfALocale(const SourceTree& tree) {
    Breaches breaches;
    static const std::regex byLocale(R"(\b(sn?printf|sscanf|ato[fl]|strto[fdl]|sto[fdl])\s*\()");
    findLines(
        tree,
        [](const std::string& path) {
            // The catalogue's naive reader is strtod; number.cpp has it for libraries without from_chars.
            return (path.starts_with("app/") || path.starts_with("lessons/") || path.starts_with("pipeline/")) &&
                   path != "pipeline/check/reader_cases.cpp" && path != "pipeline/core/number.cpp";
        },
        byLocale, "numbers are the same in every locale", breaches);
    return breaches;
}

Breaches unorderedDraws(const SourceTree& tree) {
    static const std::regex draw(R"(\b(random\s*[.(]|\w+\(random\b|(uniform|between|below|within)\s*\())");
    Breaches breaches;
    for (const SourceFile& file : tree) {
        // In 3D views between() is a point of an edge; nothing there is drawn by chance.
        if (!isSource(file) || file.path.starts_with("tests/architecture/") || isOfWindow(file.path)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            for (std::size_t open = line.find('('); open != line.npos; open = line.find('(', open + 1)) {
                int draws = 0, depth = 0;
                std::size_t begin = open + 1;
                for (std::size_t at = open; at < line.size(); ++at) {
                    const char c = line[at];
                    depth += c == '(' || c == '{' || c == '[';
                    depth -= c == ')' || c == '}' || c == ']';
                    if (depth > 1 || (depth == 1 && c != ',')) continue;
                    draws += std::regex_search(line.substr(begin, at - begin), draw);
                    begin = at + 1;
                    if (depth == 0) break;
                }
                if (draws > 1) breaches.push_back(breach(file, i + 1, "draws twice for one call", "draw x, then y"));
            }
        }
    }
    return breaches;
}

Breaches functionsOfALibrary(const SourceTree& tree) {
    Breaches breaches;
    static const std::regex ofLibrary(
        R"(((std|glm)|(^|[^\w]))::(a?(sin|cos|tan)h?|atan2|exp(2|m1)?|log(2|10|1p)?|pow|cbrt|hypot|l?gamma|erfc?|lerp|fma)[fl]?\s*\()");
    findLines(
        tree,
        [](const std::string& path) {
            if (path.starts_with("pipeline/core/elementary.") || path.starts_with("pipeline/core/quad.")) return false;
            if (!path.starts_with("pipeline/")) return false;
            // What measures frames and writes reports makes no buffer.
            return std::ranges::none_of(
                std::array{"check/", "compare/", "export/", "inspect/", "study/"},
                [&](const char* folder) { return path.starts_with(std::string("pipeline/") + folder); });
        },
        ofLibrary, "frames have the same bits on every machine: pipeline/core/elementary.h has the function", breaches);
    return breaches;
}

Breaches longFiles(const SourceTree& tree) {
    Breaches breaches;
    for (const SourceFile& file : tree) {
        const bool script = file.path.ends_with("CMakeLists.txt") || file.path.ends_with(".cmake") ||
                            file.path.ends_with(".sh") || file.path.ends_with(".py");
        if (!isSource(file) && !script) continue;
        if (file.path.starts_with("tests/student/")) continue;  // a renderer is handed in as one file
        std::size_t limit = 400;
        if (file.path.starts_with("pipeline/stages/") && file.path.ends_with(".cpp")) limit = 200;
        if (file.lines.size() > limit)
            breaches.push_back(breach(file, file.lines.size(), std::to_string(file.lines.size()) + " lines",
                                      "this file has at most " + std::to_string(limit)));
    }
    return breaches;
}

Breaches unlistedSources(const SourceTree& tree) {
    Breaches breaches;
    for (const SourceFile& file : tree) {
        if (!file.path.ends_with(".cpp")) continue;
        bool listed = false;
        for (const SourceFile& list : tree) {
            if (list.path != "CMakeLists.txt" && !list.path.ends_with("/CMakeLists.txt")) continue;
            const std::string folder =
                list.path.substr(0, list.path.size() - std::string_view("CMakeLists.txt").size());
            if (!file.path.starts_with(folder)) continue;
            const std::string name = file.path.substr(folder.size());
            // The whole name: "plan.cpp" is not listed by a line that has "stage_plan.cpp".
            const std::regex entry("(^|[\\s(])" + std::regex_replace(name, std::regex("\\."), "\\.") + "($|[\\s)])");
            listed = listed || std::ranges::any_of(
                                   list.lines, [&](const std::string& line) { return std::regex_search(line, entry); });
        }
        if (!listed) breaches.push_back(breach(file, 1, "in no CMakeLists.txt", "a source is listed by its name"));
    }
    return breaches;
}

Breaches machinePaths(const SourceTree& tree) {
    // Put together here, so that this file passes its own test.
    static const std::regex path("(^|[^A-Za-z0-9_.})/*-])/(work|root|home|Users|tmp/b-[a-z]+)" +
                                 std::string("/[A-Za-z0-9_.]"));
    Breaches breaches;
    for (const SourceFile& file : tree) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (std::regex_search(file.lines[i], match, path))
                breaches.push_back(breach(file, i + 1, "has " + match.str(), "no path of one machine"));
        }
    }
    return breaches;
}

Breaches strangersAtTheTop(const std::vector<std::string>& names) {
    static const std::set<std::string> allowed{// the six entries
                                               "CMakeLists.txt", "pipeline", "app", "lessons", "tests", "resources",
                                               // what tools and people look for here
                                               "run", "test", "README.md", "LICENSE", "CONTRIBUTING.md", "CHANGELOG.md",
                                               "SECURITY.md", "CITATION.cff", "CMakePresets.json"};
    Breaches breaches;
    for (const std::string& name : names) {
        if (!allowed.contains(name) && !name.starts_with('.'))
            breaches.push_back(name +
                               ":1: stands at the root; the layout in CONTRIBUTING.md has no place for it there");
    }
    return breaches;
}

}  // namespace architecture
