#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QImage>

#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"
#include "app/drawing3d/world_drawing.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"

namespace app {

// Fonts need an application object; where there is none, one of the platform that needs no display is made and lives as
// long as this.
class FontSystem {
public:
    FontSystem();
    ~FontSystem();
    bool ready() const;  // false: the application there is has no fonts

private:
    struct Own;
    std::unique_ptr<Own> m_own;
};
std::string pngBytes(const QImage& image);  // empty where it cannot be packed

// One view as an image, in the theme in force, without a display. Needs a QGuiApplication for
// the letters' fonts.
pipeline::Result<QImage> renderView(const ViewContent& content, const ViewOptions& options, ViewPreset preset,
                                    glm::ivec2 size);

// The same through any camera, of any space or of the hemisphere at a point, with transparency: a pixel is rendered on
// black and on white, and what differs is what shines through. pixelRatio: device pixels a logical one; letters and
// lines grow with it.
struct ViewShot {
    glm::ivec2 size{1280, 960};  // pixels
    double pixelRatio = 1;
    bool transparent = false, isPoint = false, hasGround = false;
    int tile = 1024;  // pixels: it is rendered in parts of at most so many rows and columns
};
// What a view shows, as values.
struct SpacePicture {
    std::shared_ptr<const ViewContent> content;
    ViewOptions options;
    OrbitCamera camera;
    ViewShot shot;
};
// How far a picture has got, 0 to 1. False: give up; then there is none.
using ShotProgress = std::function<bool(double share)>;
pipeline::Result<QImage> renderView(const SpacePicture& picture, const ShotProgress& progress = {});
// The same for a caller whose thread may have the window's OpenGL: a thread has one kind of OpenGL at a time.
pipeline::Result<QImage> renderBeside(const SpacePicture& picture, const ShotProgress& progress = {});

// The 3D views of a frame as PNG files of 1280 × 960 pixels in `folder`: world.png, front.png,
// side.png, top.png, eye.png and everything.png (the eye and its picture plane included), with
// the vectors of `pixel` where one is given, and then point.png, the hemisphere there. Works without a display; makes a QGuiApplication
// where there is none. Errors: no EGL with OpenGL 3.2, or a file that cannot be written.
std::vector<std::string> viewFiles();  // without the pixel's
pipeline::Result<std::vector<std::filesystem::path>> writeViews(const pipeline::Frame& frame,
                                                                std::optional<glm::ivec2> pixel,
                                                                const std::filesystem::path& folder);

}  // namespace app
