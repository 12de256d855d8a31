#include "app/desktop/layout_store.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSettings>

#include "app/core/theme.h"

namespace app {
namespace {

constexpr int kLayoutVersion = 2;  // of what stands in the window; another one makes old layouts void

QString layoutKey(const QMainWindow& window) {
    const QSize size = window.screen()->size();
    return QStringLiteral("layout/%1x%2").arg(size.width()).arg(size.height());
}

constexpr const char* kThemeNames[]{"dark", "light", "projector"};

}  // namespace

void saveLayout(const QMainWindow& window) {
    QSettings().setValue(layoutKey(window), window.saveState(kLayoutVersion));
}

bool restoreLayout(QMainWindow& window) {
    const QByteArray state = QSettings().value(layoutKey(window)).toByteArray();
    return !state.isEmpty() && window.restoreState(state, kLayoutVersion);
}

void forgetLayout(const QMainWindow& window) { QSettings().remove(layoutKey(window)); }

void saveTheme() {
    const Theme& theme = Theme::current();
    QSettings settings;
    settings.setValue("theme", kThemeNames[int(theme.id())]);
    settings.setValue(QStringLiteral("textScale/") + kThemeNames[int(theme.id())], theme.scale());
}

void restoreTheme() {
    Theme& theme = Theme::current();
    const QSettings settings;
    const QString wanted = settings.value("theme").toString();
    ThemeId chosen =
        QGuiApplication::palette().color(QPalette::Window).lightness() < 128 ? ThemeId::Dark : ThemeId::Light;
    for (const ThemeId id : {ThemeId::Dark, ThemeId::Light, ThemeId::Projector}) {
        if (wanted == kThemeNames[int(id)]) chosen = id;
        const QVariant scale = settings.value(QStringLiteral("textScale/") + kThemeNames[int(id)]);
        if (!scale.isValid()) continue;
        theme.set(id);
        theme.setScale(scale.toDouble());
    }
    theme.set(chosen);
}

}  // namespace app
