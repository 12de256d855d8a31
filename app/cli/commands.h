#pragma once
#include <string_view>

#include "app/cli/cli.h"

namespace CLI {
class App;
}

namespace app {

// A subcommand: its own file, and a row in cli.cpp. `declare` adds it with its options; when it
// is called it runs and leaves its exit status in `status`.
struct Command {
    std::string_view name;
    void (*declare)(CLI::App& program, const CliHost& host, int& status);
};

// All of them, and what the program itself takes.
void declareProgram(CLI::App& program, const CliHost& host, int& status);

void declareExport(CLI::App& program, const CliHost& host, int& status);
void declarePlan(CLI::App& program, const CliHost& host, int& status);
void declareInspect(CLI::App& program, const CliHost& host, int& status);
void declareStudy(CLI::App& program, const CliHost& host, int& status);
void declareBench(CLI::App& program, const CliHost& host, int& status);
void declareCheck(CLI::App& program, const CliHost& host, int& status);
void declareFilm(CLI::App& program, const CliHost& host, int& status);
void declareFigure(CLI::App& program, const CliHost& host, int& status);
void declareBug(CLI::App& program, const CliHost& host, int& status);
void declareCompare(CLI::App& program, const CliHost& host, int& status);
void declareStage(CLI::App& program, const CliHost& host, int& status);
void declareSheet(CLI::App& program, const CliHost& host, int& status);
void declareDrill(CLI::App& program, const CliHost& host, int& status);
void declareGrade(CLI::App& program, const CliHost& host, int& status);
void declareLesson(CLI::App& program, const CliHost& host, int& status);
void declareSite(CLI::App& program, const CliHost& host, int& status);
void declarePresent(CLI::App& program, const CliHost& host, int& status);

}  // namespace app
