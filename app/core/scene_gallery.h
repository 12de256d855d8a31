#pragma once
#include <QImage>
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/frame.h"

namespace app {

// The frame buffer as an image; empty where the frame has none.
QImage colorImage(const pipeline::Frame& frame);

// The scenes that come with the program, as pictures that the pipeline computes in the
// background, one after the other.
class SceneGallery : public QObject {
    Q_OBJECT
public:
    explicit SceneGallery(QObject* parent = nullptr);
    ~SceneGallery() override;  // stops the pictures that are still being made
    // Whether somebody looks: pictures are made only meanwhile, so that a scene that opens has the processor to itself.
    void setWatched(bool watched);

    const std::vector<pipeline::BuiltInScene>& scenes() const { return m_scenes; }
    // 4:3; empty until it is there, and for a scene that cannot be read.
    const QImage& picture(std::size_t scene) const { return m_pictures[scene]; }

signals:
    void pictureReady(std::size_t scene);

private:
    std::vector<pipeline::BuiltInScene> m_scenes;
    std::vector<QImage> m_pictures;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    bool m_watched = false;
    std::jthread m_thread;
};

}  // namespace app
