// The program: a command, or the window.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "app/cli/cli.h"
#include "app/cli/library_guard.h"
#include "app/cli/message.h"
#include "app/cli/out_of_memory.h"
#include "lessons/state/cue_list.h"
#include "lessons/state/state_scene.h"
#include "pipeline/core/memory.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/simd/missing_instructions.h"
#ifdef SHADESCOPE_WINDOW
#include "app/desktop/window_main.h"
#include "app/talk/cue_picture.h"
#include "app/vtk/offscreen.h"
#endif

namespace {

app::CliHost makeHost() {
    app::CliHost host;
#ifdef SHADESCOPE_WINDOW
    host.hasWindow = true;
    host.writeViews = app::guarded(app::writeViews);
    host.drawCueView = app::guarded(app::drawCueView);
#endif
    return host;
}

constexpr std::string_view kNoSession = "--no-session";

int refuse(const std::string& message) {
    app::tell("shadescope: {}\nRun shadescope --help to see what there is.\n", message);
    return app::kWrongUsage;
}

#ifdef SHADESCOPE_WINDOW
// Qt ends the program where it finds no display; this is said before.
bool hasDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (const char* value = std::getenv(name); value && *value) return true;
    return false;
}

// What Qt and its readers of pictures have to say may quote a file.
void tellOfQt(QtMsgType kind, const QMessageLogContext& context, const QString& message) {
    app::tell("{}\n", qFormatLogMessage(kind, context, message).toStdString());
}

int openWindow(int argc, char** argv, const std::string& file, const lessons::CueName& cue, bool session) {
    qInstallMessageHandler(tellOfQt);
    if (!hasDisplay()) return refuse("there is no display for the window; the commands need none");
    app::onlyThrowWhenOutOfMemory();
    return app::runWindow(argc, argv,
                          {.cues = QString::fromStdString(cue.file.string()),
                           .cue = QString::fromStdString(cue.name),
                           .file = QString::fromLocal8Bit(file.c_str()),
                           .session = session});
}
#else
int openWindow(int, char**, const std::string&, const lessons::CueName&, bool) {
    app::tell("shadescope: this build has no window\n\n{}", app::helpText(makeHost()));
    return app::kWrongUsage;
}
#endif

// "present FILE" and "present FILE:CUE".
int present(int argc, char** argv, bool session) {
    if (argc != 3) return refuse("present takes one cue list: present FILE, or present FILE:CUE");
    const auto named = lessons::parseCueName(argv[2]);
    const lessons::CueName cue = named ? *named : lessons::CueName{lessons::cueFileAt(argv[2]), {}};
    const auto list = lessons::readCueFile(cue.file);
    const auto found = !list              ? pipeline::Result<std::size_t>(list.errors())
                       : cue.name.empty() ? pipeline::Result<std::size_t>(0)
                                          : findCue(*list, cue.name);
    if (found) return openWindow(1, argv, {}, cue, session);
    app::tell("{}", format(found.errors()));
    return app::kBadInput;
}

// The window's texts and a plot's are drawn in fonts that an unpacked folder brings along; see resources/packaging.
void useOwnFonts() {
    const std::filesystem::path fonts = pipeline::resourceFolder() / "fonts" / "fonts.conf";
    std::error_code ignored;
    if (std::filesystem::exists(fonts, ignored)) setenv("FONTCONFIG_FILE", fonts.c_str(), 0);
}

int runProgram(int argc, char** argv) {
    useOwnFonts();
    app::keepStandardFiles();
    app::tellOfFullFiles();
    pipeline::keepFreedMemory();
    if (const std::string_view lacking = pipeline::missingInstructions(); !lacking.empty()) {
        app::tell("shadescope: built for a CPU with {}, which this machine lacks; ./run builds it for this one\n",
                  lacking);
        return app::kWrongUsage;
    }
    const bool session = !(argc > 1 && std::string_view(argv[1]) == kNoSession);
    if (!session) std::rotate(argv + 1, argv + 2, argv + argc--);  // Qt reads the rest
    const std::string first = argc > 1 ? argv[1] : "";
    const bool isHelp = std::any_of(argv, argv + argc, [](std::string_view a) { return a == "-h" || a == "--help"; });
    const bool isCheck = std::any_of(argv, argv + argc, [](std::string_view a) { return a == "--check"; });
    const bool isExport = argc > 3 && std::string_view(argv[2]) == "export";
    if (first == "present" && !isHelp && !isCheck && !isExport) return present(argc, argv, session);  // else a command
    if (app::isForCli(first)) return app::runCli(argc, argv, makeHost());
    if (first.starts_with("--")) return refuse("there is no option " + pipeline::inQuotes(first));
    const bool file = !first.empty() && first[0] != '-';  // "-platform" and the like are for Qt
    std::error_code ignored;
    const std::string scene = file ? lessons::sceneFile(first, {}).string() : "";
    if (file && first.find_first_of("./") == first.npos && !std::filesystem::exists(scene, ignored))
        return refuse("there is no file and no command " + pipeline::inQuotes(first) + "; the nearest command is " +
                      app::nearestCommand(first));
    if (file && argc > 2 && argv[2][0] != '-')
        return refuse("the window takes one file, not also " + pipeline::inQuotes(argv[2]));
    return openWindow(argc, argv, scene, {}, session);
}

// Run by the loader before the libraries begin (System V ABI, DT_PREINIT_ARRAY).
void beforeAll(int, char**, char**) { app::endWhenOutOfMemory(); }
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = beforeAll;

}  // namespace

int main(int argc, char** argv) {
    app::throwWhenOutOfMemory();
    try {
        return runProgram(argc, argv);
    } catch (const app::OutOfMemorySaid&) {
        return app::kCouldNotWrite;
    } catch (const std::bad_alloc&) {
        return app::sayOutOfMemory();
    }
}
