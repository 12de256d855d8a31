#include "pipeline/study/errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/numerics.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/stages/transform.h"
#include "pipeline/study/error_rows.h"

namespace pipeline {
namespace {

double degreesBetween(Vec3d a, Vec3d b) { return angleBetween(a, b) * 180 / std::numbers::pi; }

// The pixels that two pictures can be compared in.
using Same = std::vector<std::uint8_t>;

void addCoverage(const Picture& ours, const Picture& reference, ErrorKind kind, ErrorRows& rows) {
    const auto& a = ours.object.pixels;
    const auto& b = reference.object.pixels;
    double falsely = 0, missing = 0, other = 0, outline = 0;
    const std::size_t width = std::size_t(ours.size.x);
    for (std::size_t i = 0; i < a.size(); ++i) {
        falsely += a[i] >= 0 && b[i] < 0;
        missing += a[i] < 0 && b[i] >= 0;
        other += a[i] >= 0 && b[i] >= 0 && a[i] != b[i];
        outline += i % width != 0 && b[i] != b[i - 1];
        outline += i >= width && b[i] != b[i - width];
    }
    const auto put = [&](std::string_view measure, std::string_view unit, double value) {
        rows.put({BufferId::ObjectId}, measure, unit, kind, value);
    };
    put("pixels that differ", "pixels", falsely + missing + other);
    put("falsely drawn", "pixels", falsely);
    put("missing", "pixels", missing);
    put("another object", "pixels", other);
    if (outline > 0) put("by outline", "", (falsely + missing + other) / outline);
}

// Of no place at all nothing was measured: no row, not an error of 0.
bool any(const Same& same) { return std::ranges::find(same, 1) != same.end(); }

void addZView(const Picture& ours, const Picture& reference, const Same& same, ErrorKind kind, ErrorRows& rows) {
    if (ours.zView.empty() || reference.zView.empty() || !any(same)) return;
    std::vector<double> sizes;
    double relative = 0;
    for (std::size_t i = 0; i < same.size(); ++i) {
        if (!same[i]) continue;
        const double z = reference.zView.pixels[i];
        sizes.push_back(std::abs(ours.zView.pixels[i] - z));
        if (z != 0) relative = std::max(relative, sizes.back() / std::abs(z));
    }
    const ErrorSpread spread = spreadOf(std::move(sizes));
    rows.put({BufferId::ZView}, "RMSE", "world units", kind, spread.rmse);
    rows.put({BufferId::ZView}, "largest", "world units", kind, spread.largest);
    rows.put({BufferId::ZView}, "largest relative", "", kind, relative);
}

void addAngles(const BufferName& buffer, std::vector<double> degrees, ErrorKind kind, ErrorRows& rows) {
    if (degrees.empty()) return;
    const ErrorSpread spread = spreadOf(std::move(degrees));
    rows.put(buffer, "mean angle", "degrees", kind, spread.mean);
    rows.put(buffer, "99 % angle", "degrees", kind, spread.p99);
    rows.put(buffer, "largest angle", "degrees", kind, spread.largest);
}

void addNormals(const Picture& ours, const Picture& reference, const Same& same, ErrorKind kind, ErrorRows& rows) {
    if (ours.normal.empty() || reference.normal.empty()) return;
    std::vector<double> degrees;
    for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i]) degrees.push_back(degreesBetween(ours.normal.pixels[i], reference.normal.pixels[i]));
    addAngles({BufferId::Normal}, std::move(degrees), kind, rows);
}

void addShadows(const Scene& scene, const Picture& ours, const Picture& reference, const Same& same, ErrorKind kind,
                ErrorRows& rows) {
    for (std::size_t k = 0; k < std::min(ours.shadow.size(), reference.shadow.size()); ++k) {
        const Light& light = scene.lights[k];
        const bool counts = light.castsShadow && light.intensity != 0 && modelFacts(scene.settings.model).shadows;
        if (!counts || ours.shadow[k].empty()) continue;
        double falsely = 0, leak = 0, largest = 0, count = 0;
        for (std::size_t i = 0; i < same.size(); ++i) {
            if (!same[i]) continue;
            const double difference = ours.shadow[k].pixels[i] - reference.shadow[k].pixels[i];
            (difference < 0 ? falsely : leak) += std::abs(difference);
            largest = std::max(largest, std::abs(difference));
            ++count;
        }
        if (count == 0) continue;
        const BufferName name{BufferId::Shadow, int(k)};
        rows.put(name, "misclassified", "", kind, (falsely + leak) / count);
        rows.put(name, "false shadow", "", kind, falsely / count);
        rows.put(name, "leak", "", kind, leak / count);
        rows.put(name, "largest", "", kind, largest);
    }
}

void addIntensity(const Picture& ours, const Picture& reference, const Same& same, double white, ErrorKind kind,
                  ErrorRows& rows) {
    if (ours.intensity.empty() || reference.intensity.empty() || !(white > 0) || !any(same)) return;
    constexpr double kFloor = 0.01;  // of white: where it is darker, relative errors mean little
    std::vector<double> sizes;
    double relative = 0;
    for (std::size_t i = 0; i < same.size(); ++i)
        for (int c = 0; c < 3 && same[i]; ++c) {
            const double a = ours.intensity.pixels[i][c] / white, b = reference.intensity.pixels[i][c] / white;
            sizes.push_back(std::abs(a - b));
            relative = std::max(relative, sizes.back() / (std::abs(b) + kFloor));
        }
    const ErrorSpread spread = spreadOf(std::move(sizes));
    rows.put({BufferId::Intensity}, "RMSE", "of white", kind, spread.rmse);
    rows.put({BufferId::Intensity}, "99 %", "of white", kind, spread.p99);
    rows.put({BufferId::Intensity}, "largest", "of white", kind, spread.largest);
    rows.put({BufferId::Intensity}, "largest relative", "", kind, relative);
}

// Over the whole picture: the background next to an edge has its share, too. With one sample a pixel that sample is the
// mean.
void addAntialiased(const Picture& ours, const Picture& reference, double white, ErrorKind kind, ErrorRows& rows) {
    const Buffer2D<Vec3d>& mean = ours.antialiased.empty() ? ours.intensity : ours.antialiased;
    if (mean.empty() || reference.antialiased.empty() || !(white > 0)) return;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            sizes.push_back(std::abs(mean.pixels[i][c] - reference.antialiased.pixels[i][c]) / white);
    const ErrorSpread spread = spreadOf(std::move(sizes));
    rows.put({BufferId::Antialiased}, "RMSE", "of white", kind, spread.rmse);
    rows.put({BufferId::Antialiased}, "largest", "of white", kind, spread.largest);
}

void addSameSeen(const Scene& scene, const Picture& ours, const Picture& reference, const Same& same, ErrorKind kind,
                 ErrorRows& rows) {
    addZView(ours, reference, same, kind, rows);
    addNormals(ours, reference, same, kind, rows);
    addShadows(scene, ours, reference, same, kind, rows);
    addIntensity(ours, reference, same, whiteOf(scene), kind, rows);
    addAntialiased(ours, reference, whiteOf(scene), kind, rows);
}

void addPictures(const Frame& frame, const Picture& ours, const Picture& reference, const Same& same, ErrorKind kind,
                 ErrorRows& rows) {
    addCoverage(ours, reference, kind, rows);
    addSameSeen(frame.scene(), ours, reference, same, kind, rows);
}

// What stages leave before there are pixels, against the same stages in a wider arithmetic.

void addScreen(const std::vector<double>& a, const std::vector<double>& b, ErrorRows& rows) {
    double largest = 0;
    for (std::size_t i = 0; 3 * i < a.size(); ++i) {
        const Vec3d p = vectorAt(a, i), q = vectorAt(b, i);
        if (hasScreenPosition(p) && hasScreenPosition(q)) largest = std::max(largest, std::hypot(p.x - q.x, p.y - q.y));
    }
    rows.put({BufferId::VerticesScreen}, "largest", "pixels", ErrorKind::Arithmetic, largest);
}

void addUnitVectors(const BufferName& name, const Frame& frame, const Frame& reference, ErrorRows& rows) {
    const auto ours = frame.buffer(name), theirs = reference.buffer(name);
    if (!ours || !theirs) return;
    const std::vector<double> a = numbersOf(*ours), b = numbersOf(*theirs);
    std::vector<double> degrees;
    for (std::size_t i = 0; 3 * i < a.size(); ++i)
        if (vectorAt(a, i) != Vec3d(0) && vectorAt(b, i) != Vec3d(0))
            degrees.push_back(degreesBetween(vectorAt(a, i), vectorAt(b, i)));
    addAngles(name, std::move(degrees), ErrorKind::Arithmetic, rows);
}

// (0, 0, 0) stands for a direction that is not defined.
void addLengths(const BufferName& name, const Frame& frame, ErrorRows& rows) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return;
    const std::vector<double> numbers = numbersOf(*buffer);
    const double unit = std::holds_alternative<std::span<const float>>(buffer->data) ? 0x1p-24 : 0x1p-53;
    double count = 0;
    for (std::size_t i = 0; 3 * i < numbers.size(); ++i) {
        const Vec3d n = vectorAt(numbers, i);
        count += n != Vec3d(0) && !(std::abs(glm::length(n) - 1) <= 4 * unit);
    }
    rows.put(name, "not of unit length", "vectors", ErrorKind::Arithmetic, count);
}

void addShadowBuffers(const Frame& frame, const Frame& reference, ErrorRows& rows) {
    for (std::size_t k = 0; k < frame.scene().lights.size(); ++k) {
        const BufferName name{BufferId::ShadowBuffer, int(k)};
        const auto ours = frame.buffer(name), theirs = reference.buffer(name);
        if (!ours || !theirs) continue;
        const std::vector<double> a = numbersOf(*ours), b = numbersOf(*theirs);
        double largest = 0, scale = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
            largest = std::max(largest, std::abs(a[i] - b[i]));
            scale = std::max(scale, std::abs(b[i]));
        }
        rows.put(name, "largest relative", "", ErrorKind::Arithmetic, scale > 0 ? largest / scale : 0);
    }
}

void addStages(const Frame& frame, const Frame& reference, ErrorRows& rows) {
    const auto both = [&](BufferId id, auto add) {
        const auto a = frame.buffer({id}), b = reference.buffer({id});
        if (a && b) add(numbersOf(*a), numbersOf(*b));
    };
    both(BufferId::VerticesScreen, [&](const auto& a, const auto& b) { addScreen(a, b, rows); });
    both(BufferId::PolygonsVerdict, [&](const auto& a, const auto& b) {
        double different = 0;
        for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
        rows.put({BufferId::PolygonsVerdict}, "polygons that differ", "polygons", ErrorKind::Arithmetic, different);
    });
    addUnitVectors({BufferId::PolygonsNormal}, frame, reference, rows);
    addUnitVectors({BufferId::VerticesNormal}, frame, reference, rows);
    addShadowBuffers(frame, reference, rows);
}

// Where both see the same object, and of two frames the same polygon.
Same sameSeen(const Picture& a, const Picture& b) {
    Same same(a.object.pixels.size());
    for (std::size_t i = 0; i < same.size(); ++i)
        same[i] = a.object.pixels[i] >= 0 && a.object.pixels[i] == b.object.pixels[i];
    return same;
}
void keepSamePolygons(const Frame& a, const Frame& b, Same& same, ErrorRows& rows) {
    const auto ours = a.buffer({BufferId::PolygonId}), theirs = b.buffer({BufferId::PolygonId});
    if (!ours || !theirs) return;
    const std::vector<double> x = numbersOf(*ours), y = numbersOf(*theirs);
    double different = 0;
    for (std::size_t i = 0; i < same.size(); ++i) {
        same[i] = same[i] && x[i] == y[i];
        different += x[i] != y[i];
    }
    rows.put({BufferId::PolygonId}, "pixels that differ", "pixels", ErrorKind::Arithmetic, different);
}

// Whether a buffer's numbers differ from the reference's by no more than the last digit of a double, which rounding makes
// of two numbers however close they are. Of pixels those that are compared.
bool isWithinRounding(const AnyBuffer& ours, const AnyBuffer& theirs, const Same& same) {
    const std::vector<double> a = numbersOf(ours), b = numbersOf(theirs);
    const bool ofPixels = ours.info->domain == Domain::Pixel && a.size() % std::max<std::size_t>(1, same.size()) == 0;
    const std::size_t channels = std::size_t(ours.channels());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (ofPixels && !same.empty() && !same[i / channels]) continue;
        if (a[i] != b[i] && std::nextafter(a[i], b[i]) != b[i]) return false;
    }
    return true;
}

// Arithmetic wider than double is more accurate than the buffers can say: an error of 0 was not measured.
void dropUnmeasurable(const Frame& frame, const Frame& reference, const Same& same, std::vector<ErrorRow>& rows) {
    if (!isWiderThanDouble(frame.scene().settings.precision)) return;
    for (ErrorRow& row : rows) {
        std::optional<double>& error = row.value[index(ErrorKind::Arithmetic)];
        const auto name = findBuffer(row.buffer);
        if (!error || !name || bufferInfo(name->id).element != Element::Real || row.measure == "not of unit length")
            continue;
        const auto ours = frame.buffer(*name), theirs = reference.buffer(*name);
        if (ours && theirs && isWithinRounding(*ours, *theirs, same)) error.reset();
    }
}

void fill(const Frame& frame, const BufferName& name, glm::ivec2 size, Buffer2D<Vec3d>& out) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return;
    const std::vector<double> numbers = numbersOf(*buffer);
    out = {size, Vec3d(0)};
    for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = vectorAt(numbers, i);
}
void fill(const Frame& frame, const BufferName& name, glm::ivec2 size, Buffer2D<double>& out) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return;
    out.size = size;
    const std::vector<double> numbers = numbersOf(*buffer);
    out.pixels.assign(numbers.begin(), numbers.end());
}

}  // namespace

BufferSet picturesNeed() {
    using enum BufferId;
    return setOf({ObjectId, ZView, Position, Normal, Shadow, Intensity});
}

BufferSet errorsNeed() {
    using enum BufferId;
    return picturesNeed() |
           setOf({VerticesScreen, PolygonsVerdict, PolygonsNormal, ShadowBuffer, Depth, PolygonId, Color});
}

Picture pictureOf(const Frame& frame) {
    Picture picture;
    const glm::ivec2 size = picture.size = {frame.scene().settings.width, frame.scene().settings.height};
    if (const auto ids = frame.buffer({BufferId::ObjectId})) {
        picture.object = {size, -1};
        for (std::size_t i = 0; i < ids->count(); ++i) picture.object.pixels[i] = std::int32_t(ids->flat(i));
    }
    fill(frame, {BufferId::ZView}, size, picture.zView);
    fill(frame, {BufferId::Position}, size, picture.position);
    fill(frame, {BufferId::Normal}, size, picture.normal);
    fill(frame, {BufferId::Intensity}, size, picture.intensity);
    fill(frame, {BufferId::Antialiased}, size, picture.antialiased);
    picture.shadow.resize(frame.scene().lights.size());
    for (std::size_t k = 0; k < picture.shadow.size(); ++k)
        fill(frame, {BufferId::Shadow, int(k)}, size, picture.shadow[k]);
    return picture;
}

double whiteOf(const Scene& scene) { return maximumIntensity(scene); }

std::vector<ErrorRow> compare(const Frame& frame, const Picture& ours, const ErrorReferences& references) {
    ErrorRows rows;
    if (references.arithmetic) addStages(frame, *references.arithmetic, rows);
    addLengths({BufferId::PolygonsNormal}, frame, rows);
    addLengths({BufferId::VerticesNormal}, frame, rows);
    addLengths({BufferId::Normal}, frame, rows);
    if (references.model && !ours.object.empty())
        addPictures(frame, ours, *references.model, sameSeen(ours, *references.model), ErrorKind::Model, rows);
    if (references.model) addColor(frame, *references.model, rows);
    Same same;
    if (references.arithmetic && !ours.object.empty()) {
        const Picture wider = pictureOf(*references.arithmetic);
        same = sameSeen(ours, wider);
        keepSamePolygons(frame, *references.arithmetic, same, rows);
        addPictures(frame, ours, wider, same, ErrorKind::Arithmetic, rows);
        addColor(frame, *references.arithmetic, rows);
    }
    addDepthStorage(frame, ours, rows);
    addColorStorage(frame, rows);
    std::vector<ErrorRow> all = rows.take();
    if (references.arithmetic) dropUnmeasurable(frame, *references.arithmetic, same, all);
    std::ranges::stable_sort(all, {}, [](const ErrorRow& row) { return index(row.stage); });
    return all;
}

std::vector<ErrorRow> comparePictures(const Scene& scene, const Picture& ours, const Picture& reference) {
    ErrorRows rows;
    addSameSeen(scene, ours, reference, sameSeen(ours, reference), ErrorKind::Model, rows);
    return rows.take();
}

bool showsAnything(const Picture& picture) {
    return std::ranges::any_of(picture.object.pixels, [](std::int32_t id) { return id >= 0; });
}

Buffer2D<Vec3d> signedError(const Picture& ours, const Picture& reference, double white) {
    Buffer2D<Vec3d> error(ours.size, Vec3d(0));
    if (!(white > 0)) return error;
    for (std::size_t i = 0; i < error.pixels.size(); ++i)
        error.pixels[i] = (ours.intensity.pixels[i] - reference.intensity.pixels[i]) / white;
    return error;
}

ErrorSpread spreadOf(std::vector<double> sizes) {
    ErrorSpread spread;
    if (sizes.empty()) return spread;
    long double sum = 0, squares = 0;  // wide enough for squares of any double
    for (const long double size : sizes) sum += size, squares += size * size;
    const double count = double(sizes.size());
    const auto rank = sizes.begin() + std::ptrdiff_t(std::ceil(0.99 * count)) - 1;
    std::ranges::nth_element(sizes, rank);
    return {double(sum / count), double(std::sqrt(squares / count)), *rank, std::ranges::max(sizes)};
}

std::vector<double> numbersOf(const AnyBuffer& buffer) {
    return std::visit([](const auto& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); },
                      buffer.data);
}

Vec3d vectorAt(const std::vector<double>& numbers, std::size_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

void ErrorRows::put(const BufferName& buffer, std::string_view measure, std::string_view unit, ErrorKind kind,
                    double value) {
    const std::string name = buffer.text();
    auto row =
        std::ranges::find_if(m_rows, [&](const ErrorRow& r) { return r.buffer == name && r.measure == measure; });
    if (row == m_rows.end()) {
        m_rows.push_back({name, bufferInfo(buffer.id).stage, std::string(measure), std::string(unit)});
        row = m_rows.end() - 1;
    }
    row->value[index(kind)] = value;
}

}  // namespace pipeline
