#include "app/look/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>
#include <algorithm>

#include "app/look/theme.h"

namespace app {

namespace {

void paintIcon(QPainter& painter, const QString& name, const QColor& color, const QRectF& rect) {
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return;
    QSvgRenderer renderer(file.readAll().replace("currentColor", color.name().toLatin1()));
    renderer.render(&painter, rect);
}

// Draws the file anew in the colour of the moment, so that a change of theme needs no new icons.
class ThemedIcon : public QIconEngine {
public:
    explicit ThemedIcon(QString name) : m_name(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const ThemeColors& c = Theme::current().colors();
        const QColor color = mode == QIcon::Disabled ? c.text3 : state == QIcon::On ? c.accent : c.text2;
        const int side = std::min(rect.width(), rect.height());
        QRect square(0, 0, side, side);
        square.moveCenter(rect.center());
        paintIcon(*painter, m_name, color, square);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new ThemedIcon(*this); }

private:
    QString m_name;
};

}  // namespace

QIcon icon(const QString& name) { return QIcon(new ThemedIcon(name)); }

QPixmap iconPixmap(const QString& name, const QColor& color, int pixels, double devicePixelRatio) {
    const int side = int(std::lround(pixels * devicePixelRatio));
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    {
        QPainter painter(&pixmap);
        paintIcon(painter, name, color, QRectF(0, 0, side, side));
    }
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

}  // namespace app
