#include "pipeline/scene/hold/code_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/view.h"

namespace pipeline {

CodeFigure codeFigure(const Scene& scene) {
    constexpr int kMarks = 64;
    const View view = makeView(scene);
    CodeFigure figure{view.near, view.far, std::numeric_limits<double>::infinity(), 0, {}, 0};
    for (const Object& object : scene.objects) {
        const ObjectMatrix matrix = makeObjectMatrix(object.transform);
        for (const Vec3d& position : object.mesh->positions) {
            const double z = toView(view, toWorld(matrix, position)).z;
            if (!(z > view.near)) continue;
            figure.nearest = std::min(figure.nearest, z), figure.farthest = std::max(figure.farthest, z);
        }
    }
    if (!(figure.nearest <= figure.farthest)) figure.nearest = figure.farthest = view.far;
    if (!view.perspective) return figure;
    // d = f/(f-n) - fn/((f-n) z), as in pipeline/stages/depth.h, and its inverse.
    const double n = view.near, f = view.far, range = f - n;
    const auto codeAt = [&](double z) { return 0xFFFF * (f / range) * (1 - n / std::min(z, f)); };
    for (int i = 0; i <= kMarks; ++i) figure.marks.push_back(f * n / (f - double(i) / kMarks * range));
    figure.codes = std::round(codeAt(figure.farthest) - codeAt(figure.nearest)) + 1;
    return figure;
}

}  // namespace pipeline
