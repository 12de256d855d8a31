#include "app/buffer_view/buffer_feature.h"

#include <QLabel>

#include "app/buffer_view/buffer_view.h"

namespace app {

BufferFeature::BufferFeature(BufferView& view) : QObject(&view), m_view(view) {}

bool BufferFeature::press(const QKeyEvent&) { return false; }
QString BufferFeature::notice() const { return {}; }
pipeline::Errors BufferFeature::read(const lessons::BufferShown&) { return {}; }

bool BufferFeature::showsScene() const {
    return m_view.frame() && m_view.frame()->sharedScene() == m_view.document().sharedScene();
}

QLabel* labelOver(QWidget* canvas) {
    auto* label = new QLabel(canvas);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->setProperty("kind", "overlay");
    label->setMargin(5);
    label->hide();
    return label;
}

}  // namespace app
