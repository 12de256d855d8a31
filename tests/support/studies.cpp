#include "tests/support/studies.h"

namespace test {

StudyPoint studyPoint(std::size_t number, std::vector<std::string> values, double milliseconds, double error,
                      double spread) {
    StudyPoint point;
    point.number = number;
    point.values = std::move(values);
    std::vector<double>& samples = point.frame.processes.emplace_back();
    for (int i = -10; i <= 10; ++i) samples.push_back(milliseconds * (1 + spread * i / 10));
    point.errors.push_back({"intensity", StageId::Shading, "RMSE", "", {error, std::nullopt, std::nullopt}});
    return point;
}

StudyReport sphereStudy() {
    StudyReport report;
    report.scene = "sphere";
    report.version = "0.1.0";
    report.width = report.height = 512;
    report.warmups = 2;
    report.repeats = 21;
    report.processes = 1;
    report.geometry = "0123456789abcdef";
    report.machine = "AMD EPYC 7763, 2 processors";
    report.compiler = "GCC 12.2, release";
    report.load = {0.1};
    report.settings = {{"precision", "float"}, {"light.0.x", "-0.5"}};
    report.axes = {{"shading", "Shading", {"flat", "gouraud", "phong"}},
                   {"tessellation", "Tessellation", {"4", "16", "64", "128"}}};
    report.references = {"analytic", "the stages in quad", ""};
    report.whyNone[index(ErrorKind::Storage)] = "Nothing is stored with fewer digits.";
    report.errorBars = {{"intensity", StageId::Shading, "RMSE", "", {2e-16, std::nullopt, std::nullopt}}};
    report.errorWhy = "against the same rays in long double";

    struct Measured {
        double milliseconds, error;
    };
    const std::vector<Measured> measured{{0.59, 4.2e-2}, {0.79, 1.1e-2}, {3.26, 2.7e-3}, {10.6, 1.3e-3},
                                         {0.72, 2.4e-2}, {0.86, 2.1e-3}, {3.00, 1.6e-4}, {0, 0},
                                         {2.70, 4.4e-3}, {2.94, 3.4e-4}, {4.35, 3.5e-5}, {8.50, 9.3e-6}};
    for (std::size_t i = 0; i < measured.size(); ++i) {
        std::vector<std::string> values{report.axes[0].values[i / 4], report.axes[1].values[i % 4]};
        if (measured[i].milliseconds > 0) {
            report.points.push_back(studyPoint(i, std::move(values), measured[i].milliseconds, measured[i].error));
        } else {
            StudyPoint& failed = report.points.emplace_back();
            failed.number = i;
            failed.values = std::move(values);
            failed.failure = "stopped after 60 s";
        }
    }
    StudyPoint& first = report.points[0];
    first.errors.push_back({"normal", StageId::Normals, "largest angle", "degrees", {10.4, 1.2e-5, 0.0}});
    first.blame = {{StageId::Normals, 1.3e-3, 0.97}, {StageId::Shading, 4.3e-2, -0.02}};
    first.stages[index(StageId::Shading)].processes = {{0.25, 0.5}, {0.375}};
    first.counters = {{"fragments", 205887}, {"triangles", 320}};
    first.megabytes = 21.5;
    return report;
}

}  // namespace test
