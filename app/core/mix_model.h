#pragma once
#include "app/core/background_job.h"
#include "pipeline/inspect/term_mix.h"

namespace app {

class Document;

// How the terms of the illumination are mixed, and the picture that they make so: that of the document's frame, as
// soon as it is computed. Another scene begins with every term as it is.
class MixModel : public QObject {
    Q_OBJECT
public:
    explicit MixModel(Document& document);

    const pipeline::TermMix& mix() const { return m_mix; }
    bool isPlain() const { return pipeline::isPlain(m_mix); }
    void set(const pipeline::TermMix& mix);
    void reset();  // every term as it is
    // The newest; it may lag behind the frame. Nothing where the mix is plain, or before it has come.
    const std::optional<pipeline::MixedPicture>& picture() const { return m_picture; }
    QString sentence() const;  // "Mix of terms: specular 0 alone"; or why there is no picture

signals:
    void changed();       // the mix
    void pictureReady();  // or gone

private:
    void compute();

    Document& m_document;
    pipeline::TermMix m_mix;
    std::optional<pipeline::MixedPicture> m_picture;
    QString m_why;
    BackgroundJob m_job;
};

}  // namespace app
