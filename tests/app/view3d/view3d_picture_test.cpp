#include <gtest/gtest.h>

#include <QImage>
#include <cmath>

#include "app/look/theme.h"
#include "app/vtk/offscreen.h"
#include "tests/app/view3d/view3d_fixture.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

// The 3D views rendered without a display: claims about the pixels that come out.
namespace {

using app::Theme;
using app::ThemeId;
using app::Vec3d;
using app::ViewContent;
using app::ViewPreset;
using view3d::kRightFace;

constexpr glm::ivec2 kSize{800, 600};

ViewContent pyramidContent(std::optional<glm::ivec2> pixel = kRightFace) {
    const pipeline::Scene scene = test::pyramid();
    return app::contentOf(*test::frameOf(scene, app::contentBuffers(scene, false)), pixel);
}

QImage render(const ViewContent& content, ViewPreset preset = ViewPreset::Iso, const app::ViewOptions& options = {}) {
    const auto image = app::renderView(content, options, preset, kSize);
    EXPECT_TRUE(image) << (image ? "" : format(image.errors()));
    return image ? *image : QImage();
}

int difference(QRgb a, QRgb b) {
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

// How many pixels around a place have a colour, within 3 of 255.
int countNear(const QImage& image, glm::dvec2 at, int radius, QColor color) {
    int count = 0;
    for (int y = int(at.y) - radius; y <= int(at.y) + radius; ++y)
        for (int x = int(at.x) - radius; x <= int(at.x) + radius; ++x)
            if (image.valid(x, y) && difference(image.pixel(x, y), color.rgb()) <= 3) ++count;
    return count;
}

glm::dvec2 place(const ViewContent& content, Vec3d point, ViewPreset preset = ViewPreset::Iso) {
    return app::project(app::presetCamera(preset, content, {}, kSize, false), kSize, point).at;
}

class EveryTheme : public testing::TestWithParam<ThemeId> {
protected:
    void SetUp() override { Theme::current().set(GetParam()); }
    void TearDown() override { Theme::current().set(ThemeId::Light); }
};
INSTANTIATE_TEST_SUITE_P(View3dPicture, EveryTheme, testing::Values(ThemeId::Dark, ThemeId::Light, ThemeId::Projector));

}  // namespace

TEST_P(EveryTheme, TheBackgroundIsTheThemes) {
    const QImage image = render(pyramidContent());
    ASSERT_FALSE(image.isNull());
    EXPECT_LE(difference(image.pixel(3, 3), Theme::current().colors().view.rgb()), 1);
}

// (37, 93, 167) is what the frame buffer holds in polygon 2; polygon 1's mean is (425, 75, 50):
// N = (150, 0, 135) / 201.8, N·L = 0.8156, R·V = 0.5226, FB = (39, 97, 173) within rounding.
TEST_P(EveryTheme, FacesKeepTheFrameBuffersColours) {
    const ViewContent content = pyramidContent({});
    const QImage image = render(content, ViewPreset::Iso, {.normals = app::NormalsShown::Off});
    EXPECT_GT(countNear(image, place(content, {335, 125, 50}), 4, QColor(37, 93, 167)), 70);
}

TEST_P(EveryTheme, ArrowsHaveTheirColoursAtTheirTips) {
    const ViewContent content = pyramidContent();
    const QImage image = render(content);
    const app::ViewFrame view{app::presetCamera(ViewPreset::Iso, content, {}, kSize, false), kSize,
                              Theme::current().scale()};
    int letters = 0;
    for (const app::Label& label : app::drawWorld(content, {}, view).labels) {
        if (label.kind != app::Label::Kind::Letter) continue;
        ++letters;
        const QColor ink = app::colorOf(label.ink, Theme::current().colors());
        EXPECT_GT(countNear(image, app::project(view.camera, view.size, label.at).at, 9, ink), 8) << label.text;
    }
    EXPECT_EQ(letters, 5);
}

TEST_P(EveryTheme, ThePickedPolygonHasAWhiteEdge) {
    const ViewContent content = pyramidContent();
    const glm::dvec2 middleOfEdge = place(content, {402.5, 112.5, 75});  // of the edge that faces 1 and 2 share
    EXPECT_GT(countNear(render(content), middleOfEdge, 3, Qt::white), 5);
    EXPECT_GT(countNear(render(content), middleOfEdge, 5, Qt::black), 5);
}

// White in black around each edge of its box that nothing hides: the upper four.
TEST_P(EveryTheme, ASelectedObjectHasABoxThatIsSeenWithoutAPickedPixel) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const lessons::Selection object{lessons::Selection::Kind::Object, 0};
    const ViewContent content = app::withSelection(app::contentOf(*frame, {}), *frame, object);
    const QImage image = render(content, ViewPreset::Iso, {.normals = app::NormalsShown::Off});
    // A quarter of the way along each; x from 200 to 470, y from 0 to 150.
    for (const Vec3d at :
         {Vec3d(267.5, 0, 150), Vec3d(267.5, 150, 150), Vec3d(200, 37.5, 150), Vec3d(470, 37.5, 150)}) {
        EXPECT_GT(countNear(image, place(content, at), 2, Qt::white), 2) << at.x << ", " << at.y;
        EXPECT_GT(countNear(image, place(content, at), 6, Qt::black), 4) << at.x << ", " << at.y;
    }
}

// Polygon 2 lies behind the pyramid from the front; its outline is seen through it, fainter than it is.
TEST(View3dPicture, AHiddenSelectedPolygonShinesThroughFaintly) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const ViewContent plain = app::contentOf(*frame, {});
    const ViewContent marked =
        app::withSelection(plain, *frame, lessons::Selection{lessons::Selection::Kind::Polygon, 2});
    const app::ViewOptions options{.normals = app::NormalsShown::Off};
    const QImage with = render(marked, ViewPreset::Front, options), without = render(plain, ViewPreset::Front, options);
    const auto at = glm::ivec2(place(plain, {300, 150, 0}, ViewPreset::Front));  // on its lower edge
    int most = 0;
    for (int y = at.y - 6; y <= at.y + 6; ++y)
        for (int x = at.x - 6; x <= at.x + 6; ++x)
            most = std::max(most, difference(with.pixel(x, y), without.pixel(x, y)));
    EXPECT_GT(most, 20);
    EXPECT_EQ(countNear(with, glm::dvec2(at), 6, Qt::black), 0) << "not at full strength";
}

TEST(View3dPicture, HiddenArrowsShineThroughFaintly) {
    // From the front (looking along +y) polygon 2 lies behind the pyramid.
    const ViewContent content = pyramidContent();
    const QImage with = render(content, ViewPreset::Front, {.normals = app::NormalsShown::Off});
    const QImage without = render(content, ViewPreset::Front, {.normals = app::NormalsShown::Off, .vectors = false});
    const app::ViewFrame view{app::presetCamera(ViewPreset::Front, content, {}, kSize, false), kSize};
    // A point in the middle of N's shaft, 65 of 130 pixels from its foot.
    const double unit = view.camera.unitsPerPixel(view.size.y);
    const Vec3d inShaft = *content.foot + 65 * unit * Vec3d(0, 2, 1) / std::sqrt(5.0);
    const auto at = glm::ivec2(app::project(view.camera, kSize, inShaft).at);
    const int change = difference(with.pixel(at.x, at.y), without.pixel(at.x, at.y));
    EXPECT_GT(change, 8);
    EXPECT_GT(difference(with.pixel(at.x, at.y), Theme::current().colors().N.rgb()), 20) << "not at full strength";
}

// A tile's matrix is rounded otherwise than the whole one: along lines a sample of four may fall to the other side.
TEST(View3dPicture, RenderedInTilesItIsThePictureInOnePiece) {
    const auto content = std::make_shared<const ViewContent>(pyramidContent());
    for (const bool orthographic : {false, true})
        for (const bool transparent : {false, true}) {
            app::SpacePicture picture{
                content, {}, app::presetCamera(ViewPreset::Iso, *content, {}, kSize, orthographic), {}};
            picture.shot = {.size = kSize, .transparent = transparent, .hasGround = true, .tile = 1024};
            const auto whole = app::renderView(picture);
            picture.shot.tile = 170;  // 800 and 600 are no multiples of it
            std::vector<double> shares;
            const auto tiled = app::renderView(picture, [&](double share) {
                shares.push_back(share);
                return true;
            });
            ASSERT_TRUE(whole && tiled);
            ASSERT_EQ(tiled->size(), whole->size());
            EXPECT_EQ(shares.size(), 5u * 4u);
            EXPECT_EQ(shares.back(), 1);
            const auto isSeam = [](int at) { return at % 170 == 0 || at % 170 == 169; };
            int others = 0, atSeams = 0, seams = 0;
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x) {
                    const QRgb a = tiled->pixel(x, y), b = whole->pixel(x, y);
                    const bool isOther = difference(a, b) > 2 || std::abs(qAlpha(a) - qAlpha(b)) > 2;
                    others += isOther;
                    seams += isSeam(x) || isSeam(y);
                    atSeams += isOther && (isSeam(x) || isSeam(y));
                }
            EXPECT_LT(others, kSize.x * kSize.y / 500);
            EXPECT_LT(atSeams, seams / 100) << "of " << seams;
        }
}

// The ground's lines become thinner with their distance. On a transparent picture that is alpha alone: premultiplied, a
// channel is alpha / 255 times the ink's, where lines that fade into the theme's background would end in its colour.
TEST_P(EveryTheme, OnATransparentPictureTheGroundFadesIntoNothing) {
    const auto content = std::make_shared<const ViewContent>(pyramidContent());
    app::SpacePicture picture{content, {}, app::presetCamera(ViewPreset::Iso, *content, {}, kSize, false), {}};
    picture.shot = {.size = kSize, .transparent = true, .hasGround = true};
    const auto with = app::renderView(picture);
    picture.shot.hasGround = false;
    const auto without = app::renderView(picture);
    ASSERT_TRUE(with && without);
    const QRgb ink = Theme::current().colors().line.rgb();
    const auto* pixels = reinterpret_cast<const QRgb*>(with->constBits());
    const auto* bare = reinterpret_cast<const QRgb*>(without->constBits());
    int faint = 0, strong = 0;
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
        const int alpha = qAlpha(pixels[i]);
        if (alpha == 0 || qAlpha(bare[i]) != 0) continue;
        (alpha < 64 ? faint : strong) += 1;
        const QRgb expected = qRgb(qRed(ink) * alpha / 255, qGreen(ink) * alpha / 255, qBlue(ink) * alpha / 255);
        // Either picture's samples are averaged and rounded on their own.
        ASSERT_LE(difference(pixels[i], expected), 4) << "pixel " << i << ", alpha " << alpha;
    }
    EXPECT_GT(faint, 100);
    EXPECT_GT(strong, 100);
}

TEST(View3dPicture, ItCanBeGivenUpAfterEachTile) {
    const auto content = std::make_shared<const ViewContent>(pyramidContent());
    app::SpacePicture picture{content, {}, app::presetCamera(ViewPreset::Iso, *content, {}, kSize, false), {}};
    picture.shot.size = kSize;
    picture.shot.tile = 200;
    int tiles = 0;
    EXPECT_FALSE(app::renderView(picture, [&](double) { return ++tiles < 3; }));
    EXPECT_EQ(tiles, 3);
}

// Twice as large letters bring lines and arrows of twice the width, in the same places.
TEST(View3dPicture, MarksGrowWithTheLetters) {
    const auto content = std::make_shared<const ViewContent>(pyramidContent());
    const auto inked = [&](double scale) {
        Theme::current().setScale(scale);
        const QImage with = render(*content, ViewPreset::Iso, {.normals = app::NormalsShown::Off, .lights = false});
        const QColor ink = Theme::current().colors().N;
        int count = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) count += difference(with.pixel(x, y), ink.rgb()) <= 3;
        return count;
    };
    const int once = inked(1), twice = inked(2);
    Theme::current().setScale(1);
    // An arrow twice as long and twice as wide covers four times as much, its letter too; its rim takes from both.
    EXPECT_GT(twice, 3 * once);
    EXPECT_LT(twice, 5.5 * once);
}

TEST(View3dPicture, NormalsCanBeSwitchedOff) {
    const ViewContent content = pyramidContent({});
    EXPECT_NE(render(content), render(content, ViewPreset::Iso, {.normals = app::NormalsShown::Off}));
    EXPECT_NE(render(content), render(content, ViewPreset::Iso, {.normalLength = 200}));
}

// From the eye the view shows the picture that the pipeline computed: the pixel that is covered is
// covered here, at 800 / 640 of its coordinates.
TEST(View3dPicture, FromTheEyeItAgreesWithTheFrameBuffer) {
    const ViewContent content = pyramidContent({});
    const QImage image = render(content, ViewPreset::Eye, {.normals = app::NormalsShown::Off, .lights = false});
    const QRgb background = Theme::current().colors().view.rgb();
    const app::Picture& picture = content.mesh->picture;
    int compared = 0;
    for (int y = 230; y < 320; y += 7)
        for (int x = 230; x < 320; x += 7) {
            const pipeline::Color8 expected = picture.pixels[std::size_t(y * picture.size.x + x)];
            const QRgb shown = image.pixel(int((x + 0.5) * 1.25), int((y + 0.5) * 1.25));
            if (expected == pipeline::Color8(0)) continue;
            ++compared;
            // Edges are drawn here and not there.
            EXPECT_TRUE(difference(shown, qRgb(expected.r, expected.g, expected.b)) <= 2 || shown != background)
                << x << ' ' << y;
        }
    EXPECT_GT(compared, 30);
}

TEST(View3dPicture, ViewsAreWrittenAsPictures) {
    const test::TemporaryFolder folder;
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene, app::contentBuffers(scene, false));
    const auto files = app::writeViews(*frame, kRightFace, folder.path());
    ASSERT_TRUE(files) << format(files.errors());
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"everything.png", "eye.png", "front.png", "point.png",
                                                        "side.png", "top.png", "world.png"}));
    for (const auto& file : *files) {
        const test::Png png = test::readPng(file);
        EXPECT_EQ(png.width, 1280);
        EXPECT_EQ(png.height, 960);
    }
}

TEST(View3dPicture, AFolderThatIsNotThereIsReported) {
    const pipeline::Scene scene = test::pyramid();
    const auto files = app::writeViews(*test::frameOf(scene), {}, "/nowhere/at/all");
    ASSERT_FALSE(files);
    EXPECT_EQ(files.errors().front().where.file, "/nowhere/at/all/world.png");
}

// Polygon 2 has N = (0, 2, 1)/√5: (N + 1)/2 is (0.5, 0.947, 0.724), in bytes (128, 242, 185).
TEST(View3dPicture, NormalsAsColours) {
    const ViewContent content = pyramidContent({});
    const QImage image =
        render(content, ViewPreset::Iso, {.normals = app::NormalsShown::Off, .faces = app::FacesShown::Normals});
    EXPECT_GT(countNear(image, place(content, {335, 125, 50}), 4, QColor(128, 242, 185)), 70);
}

// A face of opacity 1/4 before the background, and one of 1/2 before the two: what is nearer is laid over what is farther,
// whatever the order of the faces. c = 1/2 near + 1/2 (1/4 far + 3/4 background).
TEST(View3dPicture, TranslucentFacesLetThroughWhatIsBehindThem) {
    ViewContent content = pyramidContent({});
    app::ViewMesh mesh = *content.mesh;
    const auto far = std::ranges::find(mesh.faces, 2, &app::Face::polygon);
    ASSERT_NE(far, mesh.faces.end());
    app::Face behind = *far, before = *far;
    behind.polygon = 0, behind.alpha = 0.25f;
    before.polygon = 1, before.alpha = 0.5f;
    mesh.polygonColors = {{1, 0, 0}, {0, 0, 1}};
    const Vec3d towards = -app::presetCamera(ViewPreset::Iso, content, {}, kSize, false).forward;
    for (std::uint32_t& vertex : before.vertices) {
        mesh.positions.push_back(mesh.positions[vertex] + 20.0 * towards);
        vertex = std::uint32_t(mesh.positions.size() - 1);
    }
    mesh.edges.clear();
    mesh.faces = {before, behind};
    content.mesh = std::make_shared<const app::ViewMesh>(mesh);
    const app::ViewOptions bare{.normals = app::NormalsShown::Off};
    const glm::dvec2 middle = place(content, {335, 125, 50});
    const glm::vec3 ground(Theme::current().colors().view.redF(), Theme::current().colors().view.greenF(),
                           Theme::current().colors().view.blueF());
    const auto byte = [](glm::vec3 c) { return QColor::fromRgbF(c.r, c.g, c.b); };
    const glm::vec3 one = 0.25f * glm::vec3(1, 0, 0) + 0.75f * ground;
    EXPECT_GT(
        countNear(render(content, ViewPreset::Iso, bare), middle, 4, byte(0.5f * glm::vec3(0, 0, 1) + 0.5f * one)), 40);
    mesh.faces = {behind};
    content.mesh = std::make_shared<const app::ViewMesh>(mesh);
    EXPECT_GT(countNear(render(content, ViewPreset::Iso, bare), middle, 4, byte(one)), 40);
    mesh.faces[0].alpha = 0;
    content.mesh = std::make_shared<const app::ViewMesh>(mesh);
    EXPECT_GT(countNear(render(content, ViewPreset::Iso, bare), middle, 4, byte(ground)), 40)
        << "as if it were not there";
}
