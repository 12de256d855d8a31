#pragma once
#include <QImage>
#include <QObject>
#include <optional>

#include "app/document/document.h"
#include "pipeline/study/shadow_verdict.h"

class QMenu;

namespace app {

// The derived buffer shadow_verdict.k of a light laid over a picture: lit, shadowed, acne, leak.
class ShadowOverlay : public QObject {
    Q_OBJECT
public:
    explicit ShadowOverlay(Document& document, QObject* parent = nullptr);

    std::optional<std::size_t> light() const { return m_light; }
    void setLight(std::optional<std::size_t> light);    // nothing: no overlay
    void fillMenu(QMenu& menu, const QString& whyNot);  // whyNot: of this buffer; empty where it can have one
    std::shared_ptr<const pipeline::ShadowVerdicts> verdicts() const;  // null while there are none
    QString notice() const;  // what its colours stand for, how far it is, why it is not there; rich text
    void cancel();           // the rays

signals:
    void changed();

private:
    pipeline::BufferName name() const { return {pipeline::BufferId::ShadowVerdict, int(m_light.value_or(0))}; }

    Document& m_document;
    std::optional<std::size_t> m_light;
};

// A map in its colours, of which those with `alpha` of 255; acne is striped and leaks are dotted in black.
inline constexpr int kVerdictAlpha = 225;  // of what is laid over a picture
QImage verdictPicture(const pipeline::ShadowVerdicts& verdicts, int alpha);

// "■ lit 80 %  ■ shadowed 15 % …": the shares of a map, in its colours; rich text.
QString sharesText(const pipeline::ShadowVerdicts& verdicts);

}  // namespace app
