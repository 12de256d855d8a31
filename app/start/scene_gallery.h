#pragma once
#include <QImage>
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/frame.h"

namespace app {

// The frame buffer as an image; empty if the frame has none.
QImage colorImage(const pipeline::Frame& frame);

// A picture of a scene, and the rectangle in it that the scene's polygons cover.
struct ScenePicture {
    QImage image;
    QRect drawn = {};
};

// Pictures of the built-in scenes, computed by the pipeline in the background, one at a time.
class SceneGallery : public QObject {
    Q_OBJECT
public:
    explicit SceneGallery(QObject* parent = nullptr);
    ~SceneGallery() override;  // stops the running pictures
    // Whether the gallery is visible. Pictures are computed only then, so that a scene that opens has the CPU to
    // itself.
    void setWatched(bool watched);

    const std::vector<pipeline::BuiltInScene>& scenes() const { return m_scenes; }
    // 4:3; empty before it is ready, and for a scene that cannot be read.
    const ScenePicture& picture(std::size_t scene) const { return m_pictures[scene]; }
    // The number of a picture that start views show: of a scene's frame buffer, or of one of its terms. These come after
    // the scenes. Nothing where the gallery has none.
    std::optional<std::size_t> find(const std::string& scene, const pipeline::BufferName& buffer) const;

signals:
    void pictureReady(std::size_t picture);

private:
    std::vector<pipeline::BuiltInScene> m_scenes;
    struct Term {
        std::size_t scene;
        pipeline::BufferName buffer;
    };
    std::vector<Term> m_terms;
    std::vector<ScenePicture> m_pictures;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    bool m_watched = false;
    std::jthread m_thread;
};

}  // namespace app
