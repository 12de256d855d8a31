#include "pipeline/study/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "pipeline/core/version.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/run/draws.h"
#include "pipeline/run/runner.h"
#include "pipeline/study/blame.h"
#include "pipeline/study/errors.h"
#include "pipeline/study/machine.h"
#include "pipeline/study/memory_share.h"
#include "pipeline/study/ray_caster.h"

namespace pipeline {
namespace {

std::map<std::string, std::string> settingsBeside(const Scene& scene, const std::vector<SweepAxis>& axes) {
    std::map<std::string, std::string> settings;
    for (const SettingRef& ref : settingsOf(scene)) settings[ref.key()] = formatSetting(ref, ref.get(scene));
    for (const SweepAxis& axis : axes) {
        const auto swept = sweptSettings(scene, axis.key);
        for (const SettingRef& ref : *swept) settings.erase(ref.key());
    }
    return settings;
}

// Of one frame, from nothing.
FramePtr frameOf(const Scene& scene, BufferSet wanted, int threads, Stop stop) {
    return runFrame(std::make_shared<const Scene>(scene), {wanted, StageId::Shading, threads, std::move(stop)},
                    nullptr);
}

// The scene with 113 bits, or why there is no such reference: it is one itself, or needs too much memory.
Result<Scene> sceneInQuad(Scene scene, BufferSet wanted) {
    if (scene.settings.precision == Precision::Quad) return Error{{}, "quad is the widest arithmetic there is", {}};
    scene.settings.precision = Precision::Quad;
    if (const Errors errors = checkMemory(scene, wanted); !errors.empty()) return errors;
    return scene;
}

void setCounters(const Frame& frame, StudyPoint& point) {
    point.counters.clear();  // an interrupted search may have left some
    for (const StageId stage : kStages)
        for (const Tally& tally : frame.run(stage).tallies) point.counters[std::string(tally.what)] += tally.done;
    point.megabytes = bufferBytes(frame) / 1e6;
}

// What no reference reads takes its default: scenes with an equal rest have the same one.
Scene referenceKey(Scene scene, RaySurfaces surfaces) {
    const Settings own = scene.settings;
    Settings& s = scene.settings;
    s = {};
    s.width = own.width, s.height = own.height, s.cull = own.cull, s.model = own.model;
    s.exponentFactor = own.exponentFactor, s.localViewer = own.localViewer, s.twoSided = own.twoSided;
    s.visibility = own.visibility;
    if (surfaces == RaySurfaces::Polygons) {
        s.shading = own.shading, s.interpolation = own.interpolation, s.normalWeight = own.normalWeight;
        return scene;
    }
    for (Object& object : scene.objects)
        if (object.shape) object.mesh = nullptr, object.shape->tessellation = 1;
    return scene;
}

// FNV-1a. G. Fowler, L. C. Noll, P. Vo, 1991. Byte by byte: of whole words the signs of two numbers would cancel.
class Mark {
public:
    void add(std::uint64_t word) {
        for (int i = 0; i < 8; ++i, word >>= 8) m_value = (m_value ^ (word & 0xff)) * 0x100000001b3u;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(Vec3d v) { add(v.x), add(v.y), add(v.z); }
    std::string text() const { return fmt::format("{:016x}", m_value); }

private:
    std::uint64_t m_value = 0xcbf29ce484222325u;
};

// What a scene has that stands in no setting.
std::string markOf(const Scene& scene) {
    Mark mark;
    for (const Object& object : scene.objects) {
        const Mesh& mesh = *object.mesh;
        for (const std::size_t count : {mesh.positions.size(), mesh.normals.size(), mesh.polygonCount(),
                                        object.transform.turns.size(), std::size_t(object.backMaterial.has_value())})
            mark.add(std::uint64_t(count));
        for (const auto* vectors : {&mesh.positions, &mesh.normals, &mesh.colors})
            for (const Vec3d& v : *vectors) mark.add(v);
        for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
            for (const std::uint32_t corner : mesh.polygon(i)) mark.add(std::uint64_t(corner));
        for (const AxisTurn& turn : object.transform.turns) mark.add(turn.angle), mark.add(turn.axis);
        if (const auto& back = object.backMaterial) {
            for (const Vec3d& color : {back->diffuse, back->specular, back->ambient, back->emission}) mark.add(color);
            mark.add(back->exponent), mark.add(back->alpha);
        }
    }
    return mark.text();
}

}  // namespace

StudyReport beginStudy(const StudyRequest& request) {
    StudyReport report;
    const Scene& scene = *request.scene;
    report.scene = scene.name, report.file = scene.file, report.version = programVersion();
    report.geometry = markOf(scene);
    report.width = scene.settings.width, report.height = scene.settings.height;
    report.threads = request.threads, report.warmups = request.warmups, report.repeats = request.repeats;
    report.machine = machineName(), report.compiler = compilerName();
    report.settings = settingsBeside(scene, request.sweep.axes);
    report.axes = request.sweep.axes;
    report.choice = request.choice.value_or(request.sweep.choice.value_or(ErrorChoice()));
    for (std::size_t i = request.shard; i < pointCount(report.axes); i += request.shards) {
        StudyPoint& point = report.points.emplace_back();
        point.number = i, point.values = valuesOf(report.axes, i);
        const auto at = sceneAt(scene, report.axes, point.values);
        const Errors errors = at ? checkMemory(*at, errorsNeed()) : at.errors();
        if (!errors.empty()) point.failure = format(errors.front());
    }
    return report;
}

bool ErrorFinder::antialiases() const {
    const auto named = [](const SweepAxis& axis) { return axis.key == "antialiasing"; };
    return m_request.scene->settings.antialiasing > 1 || std::ranges::any_of(m_request.sweep.axes, named);
}

bool ErrorFinder::variesSamplesAlone() const {
    return std::ranges::all_of(m_request.sweep.axes, [](const SweepAxis& axis) {
        return axis.key.starts_with("antialiasing") || axis.key.starts_with("shadow.") || axis.key.ends_with("samples");
    });
}

BufferSet ErrorFinder::wanted() const {
    return antialiases() ? errorsNeed() | setOf({BufferId::Antialiased}) : errorsNeed();
}

std::shared_ptr<const Reference> ErrorFinder::modelReference(const Scene& scene, StudyReport* report, Stop stop) {
    Scene shaded = scene;
    RaySurfaces surfaces = RaySurfaces::Exact;
    std::string why = whyNoRays(scene, surfaces);
    std::string instead = why.empty() ? "" : fmt::format("the true surfaces are not known: {}", why);
    if (variesSamplesAlone() && whyNoRays(scene, RaySurfaces::Polygons).empty()) {
        surfaces = RaySurfaces::Polygons;
        instead = "only samples are varied, and the error of the polygons themselves would hide theirs";
    } else if (!why.empty()) {  // then at least its own polygons, shaded pixel by pixel
        surfaces = RaySurfaces::Polygons;
        shaded.settings.shading = Shading::Phong, shaded.settings.interpolation = Interpolation::Perspective;
        if (const std::string none = whyNoRays(shaded, surfaces); !none.empty()) {
            if (report) report->whyNone[index(ErrorKind::Model)] = none;
            return nullptr;
        }
    }
    Scene key = referenceKey(shaded, surfaces);
    if (!m_reference || !(key == m_referenceKey)) {
        auto found = rayCast(shaded, surfaces, 0, stop);
        if (!found || (antialiases() && !castWholePixels(shaded, surfaces, 0, stop, *found))) return nullptr;
        m_reference = std::make_shared<const Reference>(std::move(*found));
        m_referenceKey = std::move(key);
    }
    if (report) {
        const std::size_t model = index(ErrorKind::Model);
        report->references[model] = m_reference->name;
        report->whyNone[model] = instead;
        addErrorBars(m_reference->errorBars, *report);
        report->errorWhy = m_reference->errorWhy;
    }
    return m_reference;
}

constexpr const char* kNotMeasurable =
    "of extended not measurable where a buffer, rounded to double, differs by that rounding alone";

namespace {

// The model's errors over several draws of samples: each the median, with its interval. False when it was stopped.
bool drawAgain(const FramePtr& frame, const Picture& reference, const Stop& stop, std::vector<ErrorRow>& rows) {
    std::vector<std::vector<ErrorRow>> draws{rows};
    while (draws.size() < kDraws) {
        const FramePtr again = withDraw(frame, unsigned(draws.size()), stop);
        if (!again) return false;
        draws.push_back(compare(*again, pictureOf(*again), {&reference, nullptr}));
    }
    for (ErrorRow& row : rows) {
        std::vector<double> errors;
        for (const auto& draw : draws)
            for (const ErrorRow& other : draw)
                if (const auto& error = other.value[index(ErrorKind::Model)];
                    error && other.buffer == row.buffer && other.measure == row.measure)
                    errors.push_back(*error);
        if (errors.size() < kDraws) continue;
        std::ranges::sort(errors);
        if (!(errors.front() < errors.back())) continue;  // not of what is drawn, or not finite
        row.value[index(ErrorKind::Model)] = (errors[kDraws / 2 - 1] + errors[kDraws / 2]) / 2;
        row.drawn = {errors.front(), errors.back()};
    }
    return true;
}

}  // namespace

bool ErrorFinder::find(StudyPoint& point, StudyReport& report, Stop stop) {
    const auto scene = sceneAt(*m_request.scene, report.axes, point.values);
    if (stop.stop_requested()) return false;
    if (!scene) point.failure = format(scene.errors().front());
    if (!point.failure.empty()) return true;
    // Counted is the frame whose time is taken: nobody asks it for buffers.
    const FramePtr frame = frameOf(*scene, wanted(), 0, stop), plain = frameOf(*scene, {}, 0, stop);
    if (!frame || !plain) return false;
    setCounters(*plain, point);

    const std::size_t arithmetic = index(ErrorKind::Arithmetic);
    FramePtr exact;
    if (const auto quad = sceneInQuad(*scene, wanted())) {
        exact = frameOf(*quad, wanted(), 0, stop);
        if (!exact) return false;
        report.references[arithmetic] = "the same stages in quad, 113 bits";
        if (isWiderThanDouble(scene->settings.precision)) report.whyNone[arithmetic] = kNotMeasurable;
    } else {
        report.whyNone[arithmetic] = fmt::format("none for point {}: {}", point.number, format(quad.errors().front()));
    }
    report.references[index(ErrorKind::Storage)] = "what was to be stored, unrounded";
    const auto reference = modelReference(*scene, &report, stop);
    if (stop.stop_requested()) return false;
    const Picture ours = pictureOf(*frame);
    if (!ours.object.empty() && !showsAnything(ours) && (!reference || !showsAnything(reference->picture))) {
        point.failure = "nothing is drawn: there is nothing to compare";
        return true;
    }
    point.errors = compare(*frame, ours, {reference ? &reference->picture : nullptr, exact.get()});
    const Settings& settings = scene->settings;
    const bool isDrawn = settings.antialiasing > 1 && (settings.antialiasingPattern == SamplePattern::Jittered ||
                                                       settings.antialiasingPattern == SamplePattern::Random);
    if (isDrawn && reference && !drawAgain(frame, reference->picture, stop, point.errors)) return false;
    if (reference) point.blame = blame(*scene, ours, reference->picture);
    return true;
}

std::optional<PointPictures> ErrorFinder::show(const StudyPoint& point, Stop stop) {
    const auto scene = sceneAt(*m_request.scene, m_request.sweep.axes, point.values);
    if (!scene) return std::nullopt;
    const FramePtr frame = frameOf(*scene, wanted(), 0, stop);
    if (!frame) return std::nullopt;
    PointPictures shown{frame, pictureOf(*frame), modelReference(*scene, nullptr, stop)};
    if (stop.stop_requested()) return std::nullopt;
    return shown;
}

bool measureTimes(const StudyRequest& request, std::span<StudyPoint> points,
                  const std::function<void(int done, int all)>& progress, Stop stop) {
    struct Running {
        StudyPoint* point;
        std::shared_ptr<const Scene> scene;
        std::vector<double> frame;
        std::array<std::vector<double>, kStageCount> stages;
    };
    std::vector<Running> all;
    for (StudyPoint& point : points) {
        if (!point.failure.empty()) continue;
        const auto scene = sceneAt(*request.scene, request.sweep.axes, point.values);
        if (scene) all.push_back({&point, std::make_shared<const Scene>(*scene), {}, {}});
    }
    const int rounds = request.warmups + request.repeats;
    for (int round = 0; round < rounds; ++round) {
        for (Running& one : all) {
            const FramePtr frame = runFrame(one.scene, {{}, StageId::Shading, request.threads, stop}, nullptr);
            if (!frame) return false;
            if (round < request.warmups) continue;
            one.frame.push_back(frame->milliseconds());
            for (const StageId stage : kStages)
                if (frame->plan()[index(stage)].action == Action::Run)
                    one.stages[index(stage)].push_back(frame->run(stage).milliseconds);
        }
        if (progress) progress(round + 1, rounds);
    }
    for (Running& one : all) {
        one.point->frame.processes.push_back(std::move(one.frame));
        for (std::size_t i = 0; i < kStageCount; ++i)
            if (!one.stages[i].empty()) one.point->stages[i].processes.push_back(std::move(one.stages[i]));
    }
    return true;
}

}  // namespace pipeline
