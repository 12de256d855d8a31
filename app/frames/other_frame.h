#pragma once
#include <QObject>
#include <memory>

#include "app/frames/frame_worker.h"

namespace app {

// The frame of another scene, for comparison with the document's. Computed on a thread of its own, which starts with
// the first request.
class OtherFrame : public QObject {
    Q_OBJECT
public:
    explicit OtherFrame(QObject* parent = nullptr);
    ~OtherFrame() override;

    // Repeating the last request changes nothing.
    void request(const std::shared_ptr<const pipeline::Scene>& scene, pipeline::BufferSet wanted);
    void forget();  // drops the result and the running work
    void cancel();  // stops until another request; the result stays
    void retry();   // restarts with the next request after cancel()
    bool wasCancelled() const { return m_cancelled; }
    // The newest result; null before the first. It may lag behind the request.
    const pipeline::FramePtr& frame() const { return m_frame; }
    bool busy() const { return m_taken < m_ticket; }

signals:
    void ready();
    void busyChanged(bool busy);

private:
    void giveUp();

    std::shared_ptr<const pipeline::Scene> m_scene;
    pipeline::BufferSet m_wanted;
    pipeline::FramePtr m_frame;
    long m_ticket = 0, m_taken = 0, m_oldestValid = 0;
    bool m_cancelled = false;
    std::unique_ptr<FrameWorker> m_worker;
};

}  // namespace app
