#pragma once
#include <QObject>
#include <optional>

#include "app/canvas/show_job.h"
#include "app/document/document.h"
#include "app/frames/derived_job.h"
#include "app/frames/other_frame.h"
#include "app/frames/other_source.h"

namespace app {

// Finds B, the buffer that a view compares what it shows with, and has it computed.
class OtherSide : public QObject {
    Q_OBJECT
public:
    OtherSide(Document& document, QObject* parent);

    // Adds B to the view's request. If there is no B, why() gives the reason.
    void addTo(ShowRequest& request, const std::optional<OtherSource>& source);
    void forget();                         // what has been found
    QString why() const { return m_why; }  // there is no B, or it cannot be compared; else empty
    void giveUp(const QString& why) { m_why = why; }
    const pipeline::FramePtr& frame() const { return m_frame; }                // of B; null for a file
    const std::optional<pipeline::AnyBuffer>& file() const { return m_file; }  // what a file has, once it is read
    bool busy() const { return m_other.busy() || m_derived.busy(); }
    QString remark() const;  // what B lags behind; empty where it does not
    void tellWork();

signals:
    void changed();
    void workChanged();

private:
    void observeWork();
    std::optional<pipeline::AnyBuffer> find(const OtherSource& source, const pipeline::FramePtr& frame,
                                            const pipeline::AnyBuffer& a);
    std::optional<pipeline::AnyBuffer> readFile(const QString& file, const pipeline::AnyBuffer& a);
    std::optional<pipeline::AnyBuffer> findDerived(const pipeline::BufferName& name, bool isOwn);
    QString whyNotYet() const;

    Document& m_document;
    OtherScene m_scene;
    OtherFrame m_other;
    DerivedJob m_derived;  // B, of another frame
    pipeline::FramePtr m_frame;
    std::optional<pipeline::AnyBuffer> m_file;
    QString m_why;
};

}  // namespace app
