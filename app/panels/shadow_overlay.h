#pragma once
#include <QImage>
#include <QObject>
#include <optional>

#include "app/core/background_job.h"
#include "app/core/document.h"
#include "pipeline/study/shadow_verdict.h"

class QMenu;

namespace app {

// The shadow factor of a light against exact rays, laid over a picture: lit, shadowed, acne, leak. Rays are cast off
// the GUI thread, once for as long as surfaces, camera and light stay; a bias alone is followed at once.
class ShadowOverlay : public QObject {
    Q_OBJECT
public:
    explicit ShadowOverlay(Document& document, QObject* parent = nullptr);

    std::optional<std::size_t> light() const { return m_light; }
    void setLight(std::optional<std::size_t> light);    // nothing: no overlay
    void fillMenu(QMenu& menu, const QString& whyNot);  // whyNot: of this buffer; empty where it can have one
    const std::optional<pipeline::ShadowVerdicts>& verdicts() const { return m_verdicts; }
    bool busy() const { return m_job.busy(); }
    QImage image() const;    // null while there is none
    QString notice() const;  // what its colours stand for, how far it is, why it is not there; rich text

signals:
    void changed();

private:
    void refresh();
    void judge();

    Document& m_document;
    std::optional<std::size_t> m_light;
    std::shared_ptr<const pipeline::Scene> m_scene;  // that the rays are cast in, or have been
    std::optional<pipeline::ExactShadows> m_exact;
    std::optional<pipeline::ShadowVerdicts> m_verdicts;
    QString m_why;
    double m_share = 0;
    BackgroundJob m_job;
};

}  // namespace app
