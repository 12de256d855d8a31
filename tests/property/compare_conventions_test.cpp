// A right renderer under each row of the conventions' table, and under any two: nobody accuses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "pipeline/compare/verdict.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/view.h"
#include "tests/support/sweep.h"

using namespace pipeline;
using foreign::Coding;
using foreign::Form;
using foreign::HandedFile;
using foreign::Values;

namespace {

struct ConventionRow {
    std::string_view key, value;
    Coding coding = Coding::AsIs;
};
using Conventions = std::vector<ConventionRow>;

// Those of the manual: orders of rows, columns and channels, and the table of codings.
Conventions allConventions() {
    Conventions all{{"rows", "bottom-up"}, {"columns", "right-to-left"}, {"channels", "bgr"}};
    for (const foreign::CodingInfo& row : foreign::codingTable())
        if (row.id != Coding::AsIs) all.push_back({row.key, row.value, row.id});
    return all;
}

// Both can hold in one program, and neither is an error there: y runs upwards where the rows do, and dot products that are
// cut at 0 need no sign.
bool isPossible(const Conventions& made) {
    if (made.size() == 2 && made[0].coding == Coding::Signed && made[1].coding == Coding::CutAtZero) return false;
    for (const ConventionRow& one : made)
        if (one.value == "y-up" && made.front().key != "rows") return false;
    return made.size() < 2 || made[0].key != made[1].key;
}

// A renderer that is right: this program's frame, written as somebody else would.
class Renderer {
public:
    explicit Renderer(const Conventions& made) : m_made(made) {
        auto scene = readScene(SHADESCOPE_STARTER "/check_me.toml");
        EXPECT_TRUE(scene);
        m_scene = std::move(scene).value();
        m_scene.settings.width = 96, m_scene.settings.height = 60;
        m_scene.camera.pixelsPerUnit *= 0.3;
        if (has(Coding::WindowOfOwnPlanes) || has(Coding::LinearOfOwnPlanes))
            m_scene.camera.near = m_scene.camera.far = 0;
        // Phong's model alone scales by I_max: the others cut off at 1 themselves.
        const bool scales = has(Coding::WhiteIsOne) || has(Coding::WhiteIsHundred);
        if (scales) m_scene.settings.model = Model::Phong;
        const double brighter = has(Coding::WhiteIsHundred) ? 80 : 1;
        if (m_scene.ambient.intensity) *m_scene.ambient.intensity *= brighter;
        for (Light& light : m_scene.lights) light.intensity *= brighter;
        const auto corner = !has(Coding::Corner)      ? PixelCorner::None
                            : is("rows", "bottom-up") ? PixelCorner::LowerLeft
                                                      : PixelCorner::UpperLeft;
        static std::map<std::tuple<bool, double, double, PixelCorner>, std::shared_ptr<const foreign::Reference>> drawn;
        const auto draw = [&](PixelCorner at) {
            auto& kept = drawn[{scales, brighter, m_scene.camera.near, at}];
            if (!kept) kept = std::make_shared<const foreign::Reference>(*foreign::makeReference(m_scene, {}, {}, at));
            return kept;
        };
        m_reference = draw(PixelCorner::None), m_drawn = draw(corner);
    }

    // wanted: names of files.
    Result<foreign::Report> compared(const std::vector<std::string>& wanted) const {
        std::vector<HandedFile> files;
        for (const std::string& name : wanted) files.push_back(file(name));
        return compared(std::move(files));
    }
    Result<foreign::Report> compared(std::vector<HandedFile> files) const {
        foreign::HandedIn in;
        in.files = std::move(files);
        if (has(Coding::Gamma22)) in.conventions = "encoding = \"gamma-2.2\"\n";  // an error where nobody says so
        in.conventionsName = "mine.toml";
        foreign::CompareOptions options;
        options.known = false;
        return compareRenderer(m_scene, m_reference, std::move(in), "mine", options);
    }

    HandedFile file(const std::string& name) const {
        HandedFile out;
        out.name = *foreign::findHanded(name, m_scene.lights.size()), out.path = name + ".npy";
        const BufferName& buffer = out.name.buffer;
        const bool isPicture = bufferInfo(buffer.id).domain == Domain::Pixel;
        const foreign::Reference& drawn = isPicture ? *m_drawn : *m_reference;
        const Values& right = drawn.values.at(buffer.text());
        std::vector<double> numbers;
        std::pair range(HUGE_VAL, 0.0);
        for (std::size_t i = 0; i < right.count() && buffer.id == BufferId::ZView; ++i)
            if (right.there[i])
                range = {std::min(range.first, right.numbers[i]), std::max(range.second, right.numbers[i])};
        for (std::size_t i = 0; i < right.count(); ++i) {
            const bool there = right.there[i] != 0;
            std::vector<double> v(right.at(i), right.at(i) + right.channels);
            using enum BufferId;
            switch (buffer.id) {
                case Color:
                    for (std::size_t c = 0; c < 3; ++c)
                        v[c] = std::round(255 * color(drawn.values.at("intensity").at(i)[c]));
                    break;
                case ZView: {
                    const double* const p = drawn.values.at("position").at(i);
                    v[0] = depth(v[0], glm::length(Vec3d(p[0], p[1], p[2]) - makeView(m_scene).eye), range, there);
                    break;
                }
                case PolygonsNormal:
                case Normal: {
                    const Vec3d n = there ? normal({v[0], v[1], v[2]}) : Vec3d(0);
                    v = {n.x, n.y, n.z};
                    break;
                }
                case PolygonId:
                    if (has(Coding::FromOne)) v[0] += 1;
                    if (has(Coding::Permuted) && there) v[0] = std::fmod(7919 * v[0] + 3, 100003);
                    break;
                case PolygonsVerdict:
                    if (has(Coding::Codes)) v[0] = m_drawn->frame->buffer({PolygonsVerdict})->flat(i);
                    if (has(Coding::DroppedIsOne)) v[0] = 1 - v[0];
                    break;
                case VerticesView: v[2] *= has(Coding::TowardsViewer) ? -1 : 1; break;
                case VerticesScreen:
                    if (has(Coding::PixelFromCentre)) v[0] -= 0.5, v[1] -= 0.5;
                    if (has(Coding::FromTheFoot)) v[1] = m_scene.settings.height - v[1];
                    break;
                case NDotL:
                    if (has(Coding::CutAtZero)) v[0] = std::max(0.0, v[0]);
                    if (has(Coding::Signed)) v[0] = std::round(255 * (v[0] + 1) / 2);
                    break;
                case Shadow: v[0] = has(Coding::LitIsZero) ? 1 - v[0] : v[0]; break;
                case Diffuse:
                    for (double& part : v) part /= has(Coding::OfIMax) ? drawn.context.iMax : 1;
                    break;
                default: break;
            }
            numbers.insert(numbers.end(), v.begin(), v.end());
        }
        const bool isGrey = has(Coding::Grey) || has(Coding::GreyReversed);
        const bool isLevels = buffer.id == BufferId::Color || (buffer.id == BufferId::ZView && isGrey) ||
                              (buffer.id == BufferId::NDotL && has(Coding::Signed));
        out.numbers.kind = isLevels ? NumberKind::Levels8 : NumberKind::Real;
        out.numbers.shape = {right.rows};
        if (isPicture) out.numbers.shape.push_back(right.columns);
        if (right.channels > 1) out.numbers.shape.push_back(std::size_t(right.channels));
        out.numbers.values = isPicture ? ordered(numbers, right, buffer.id) : numbers;
        countStrange(out.numbers);
        return out;
    }

private:
    bool has(Coding coding) const {
        return std::ranges::any_of(m_made, [&](const ConventionRow& one) { return one.coding == coding; });
    }
    bool is(std::string_view key, std::string_view value) const {
        return std::ranges::any_of(m_made, [&](const auto& one) { return one.key == key && one.value == value; });
    }

    double color(double intensity) const {
        const double v = std::clamp(intensity / m_drawn->context.iMax, 0.0, 1.0);
        if (has(Coding::Srgb)) return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        if (has(Coding::Gamma22)) return std::pow(v, 1 / 2.2);
        if (has(Coding::WhiteIsOne)) return std::clamp(intensity, 0.0, 1.0);
        if (has(Coding::WhiteIsHundred)) return std::clamp(intensity / 100, 0.0, 1.0);
        return v;
    }
    // range: of what is drawn. Of nothing what each kind of z-buffer is cleared to.
    double depth(double z, double distance, const std::pair<double, double>& range, bool there) const {
        const View view = makeView(m_scene);
        const auto window = [&](double n, double f) { return there ? f * (z - n) / (z * (f - n)) : 1; };
        const double n = view.near, f = view.far, linear = there ? (z - n) / (f - n) : 1;
        const double grey = std::round(255 * (0.1 + 0.8 * (z - range.first) / (range.second - range.first)));
        if (has(Coding::MinusZ)) return there ? -z : -f;
        if (has(Coding::Distance)) return there ? distance : HUGE_VAL;
        if (has(Coding::Ndc)) return 2 * window(n, f) - 1;
        if (has(Coding::Window)) return window(n, f);
        if (has(Coding::Reversed)) return 1 - window(n, f);
        if (has(Coding::Inverse)) return there ? 1 / z : 0;
        if (has(Coding::Linear)) return linear;
        if (has(Coding::LinearReversed)) return 1 - linear;
        if (has(Coding::Grey)) return there ? grey : 255;
        if (has(Coding::GreyReversed)) return there ? 255 - grey : 0;
        if (has(Coding::WindowOfOwnPlanes)) return window(range.first / 3, 5 * range.second);
        if (has(Coding::LinearOfOwnPlanes)) return there ? 3 * z + 7 : 1000;
        return there ? z : HUGE_VAL;
    }
    Vec3d normal(Vec3d n) const {
        const View view = makeView(m_scene);
        const bool isAway = has(Coding::View) || has(Coding::ViewRgb);
        if (isAway || has(Coding::ViewTowards) || has(Coding::ViewTowardsRgb))
            n = {glm::dot(n, view.right), glm::dot(n, view.up), (isAway ? 1 : -1) * glm::dot(n, view.forward)};
        const bool isColor = has(Coding::WorldRgb) || has(Coding::ViewRgb) || has(Coding::ViewTowardsRgb);
        return isColor ? (n + 1.0) / 2.0 : n;
    }

    std::vector<double> ordered(const std::vector<double>& numbers, const Values& picture, BufferId id) const {
        std::vector<double> out;
        const auto channels = std::size_t(picture.channels);
        for (std::size_t y = 0; y < picture.rows; ++y)
            for (std::size_t x = 0; x < picture.columns; ++x)
                for (std::size_t c = 0; c < channels; ++c) {
                    const std::size_t row = is("rows", "bottom-up") ? picture.rows - 1 - y : y;
                    const std::size_t column = is("columns", "right-to-left") ? picture.columns - 1 - x : x;
                    const bool isTurned = is("channels", "bgr") && id == BufferId::Color;
                    out.push_back(numbers[(row * picture.columns + column) * channels + (isTurned ? 2 - c : c)]);
                }
        return out;
    }

    Conventions m_made;
    Scene m_scene;
    std::shared_ptr<const foreign::Reference> m_reference, m_drawn;  // pixels at their centres; theirs
};

TEST(CompareConventions, noTwoOfThemAccuseARightRenderer) {
    const Conventions all = allConventions();
    std::vector<Conventions> ways{{}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        ways.push_back({all[i]});
        for (std::size_t j = i + 1; j < all.size(); ++j) ways.push_back({all[i], all[j]});
    }
    std::erase_if(ways, [](const Conventions& made) { return !isPossible(made); });
    EXPECT_GT(ways.size(), 400u);
    const std::vector<std::string> natural{"color", "depth"};
    for (const std::size_t i : test::sweep(ways.size())) {
        const Conventions& made = ways[i];
        const auto is = [&](std::string_view value) {
            return std::ranges::any_of(made, [&](const ConventionRow& one) { return one.value == value; });
        };
        std::vector<std::string> full{"vertices.view", "vertices.screen", "depth",     "polygon_id", "normal",
                                      "n_dot_l.0",     "shadow.0",        "diffuse.0", "color"};
        full.insert(full.begin() + 2, is("codes") || is("kept-is-1") ? "polygons.verdict" : "polygons.visible");
        std::string words;
        for (const ConventionRow& one : made) words += std::string(one.key) + " = " + std::string(one.value) + "; ";
        const Renderer renderer(made);
        for (const auto& files : {full, natural}) {
            const auto report = renderer.compared(files);
            ASSERT_TRUE(report) << words << format(report.errors().front());
            EXPECT_TRUE(report->agrees())
                << words << files.size() << " files: " << headline(*report) << " " << evidence(*report);
        }
    }
}

// z of a program's normals in view space points one way: a file of it in which z points the other way is wrong.
TEST(CompareConventions, normalsInViewSpaceHaveOneHandednessInAFolder) {
    const Renderer away({{"normals", "view", Coding::View}});
    const Renderer towards({{"normals", "view-towards", Coding::ViewTowards}});
    for (const Renderer* const one : {&away, &towards}) {
        const auto report = one->compared(std::vector<std::string>{"polygons.normal", "normal"});
        ASSERT_TRUE(report);
        EXPECT_TRUE(report->agrees()) << headline(*report);
    }
    const auto report = away.compared({away.file("polygons.normal"), towards.file("normal")});
    ASSERT_TRUE(report);
    ASSERT_EQ(report->findings.size(), 2u);
    EXPECT_TRUE(report->findings[0].agrees) << findingText(report->findings[0]);
    EXPECT_FALSE(report->findings[1].agrees) << findingText(report->findings[1]);
}

}  // namespace
